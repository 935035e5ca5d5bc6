# SPDX-License-Identifier: GPL-3.0-or-later
"""Differences between ncsim and rs274 that are meant: why, and how to recognise them."""
import re


class Explained:
    """A class of differences. `message` is searched in what differs, `program` in its lines."""

    def __init__(self, why, message, program, strict=None):
        self.why, self.message, self.program, self.strict = why, message, program, strict

    def covers(self, strict, what, lines):
        if self.strict is not None and strict != self.strict:
            return False
        return bool(re.search(self.message, what)) and any(re.search(self.program, line) for line in lines)


CLASSES = {}

BEGIN, END = "<!-- rs274 -->", "<!-- /rs274 -->"


def write_table(path, total, counts):
    with open(path, encoding="utf-8") as page:
        text = page.read()
    rows = [f"| of {total} random programs | differ | why |", "| --- | --- | --- |"]
    rows += [f"| {name} | {counts.get(name, 0)} | {CLASSES[name].why} |" for name in CLASSES]
    before, rest = text.split(BEGIN)
    with open(path, "w", encoding="utf-8") as page:
        page.write(before + BEGIN + "\n" + "\n".join(rows) + "\n" + END + rest.split(END)[1])
