#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands in the tables of a page, and compares the output with what the page shows.

Usage: commands_test.py NCSIM SOURCE PAGE LEAST

A table with the columns "command" and "shows" has a command of ncsim in each row, and text of its output; an
ellipsis stands for any text. "(exit code 1)" behind a command is its code, otherwise 0. The commands run in a copy
of samples and examples. LEAST: number of rows that the page has at least.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROW = re.compile(r"^\|(.*)\|$")
COMMAND = re.compile(r"^`((?:cd [\w/-]+; )?(?:sed [^;]*; )?ncsim .*)`(?: \(exit code (\d)\))?$")


def cells(line):
    return [cell.strip() for cell in re.split(r"(?<!\\)\|", ROW.match(line)[1])]


def rows(text):
    """Yields the command and the shown text of each row of a table that has both columns."""
    head = None
    for line in text.split("\n"):
        if not ROW.match(line):
            head = None
        elif head is None:
            head = cells(line)
        elif {"command", "shows"} <= set(head) and not line.startswith("| ---"):
            row = dict(zip(head, cells(line)))
            yield row["command"], row["shows"]


def shown_in(shown, output):
    """True if the parts of `shown` between ellipses are in `output`, in this order."""
    at = 0
    for part in (part.strip() for part in shown.split("…")):
        at = output.find(part, at)
        if at < 0:
            return False
        at += len(part)
    return True


def main():
    program, source, page, least = os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3], int(sys.argv[4])
    with open(page, encoding="utf-8") as file:
        found = list(rows(file.read()))
    faults = [] if len(found) >= least else [f"{len(found)} rows, expected {least}"]
    with tempfile.TemporaryDirectory() as folder:
        for name in ("samples", "examples"):
            shutil.copytree(os.path.join(source, name), os.path.join(folder, name))
        os.mkdir(os.path.join(folder, "bin"))
        os.symlink(program, os.path.join(folder, "bin/ncsim"))
        environment = dict(os.environ, PATH=os.path.join(folder, "bin") + ":" + os.environ["PATH"])
        for command, shown in found:
            match = COMMAND.match(command.replace("\\|", "|"))
            shown = shown.strip("`").replace("\\|", "|")
            if not match or not shown:
                faults.append(f"no command and output: {command} | {shown}")
                continue
            ran = subprocess.run(["sh", "-c", match[1]], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
            output = ran.stdout.decode("utf-8", "replace")
            if ran.returncode != int(match[2] or 0):
                faults.append(f"{command}: exit code {ran.returncode}\n{output[:2000]}")
            elif not shown_in(shown, output):
                faults.append(f"{command} does not show '{shown}':\n{output[:2000]}")
    for fault in faults:
        print(fault)
    print(f"{len(found)} commands, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
