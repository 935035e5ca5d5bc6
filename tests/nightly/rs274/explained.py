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
        return bool(re.search(self.message, what)) and bool(re.search(self.program, "\n".join(lines)))


CLASSES = {
    "G88": Explained("After G88 the operator takes the tool out by hand. rs274 makes no motion and counts from the "
                     "clearance plane; ncsim retracts.", r"motion", r"G88"),
    "the machine of rs274": Explained(
        "Without a configuration, T1 is in the spindle at the start, and the variables #5161 … #5390 count inches; a tool change forgets that G43 in a block "
        "before it, or G49, without a move between, has moved the tip; G20 and G21 do not convert the length in "
        "force, so G28, G30, G53 and the next G43 or G49 go elsewhere; G10 L2 with R turns the position without the offset "
        "of G92 or G52. ncsim counts millimetres, knows the tip, and warns of this R.",
        r"motion", r"#5[123]\d\d|G4[39].*\n(?:(?:(?!.*[XYZ])|.*G(?:10|92|52)).*\n)*.*M6|G43(?:.*\n)+.*G2[01](?:.*\n)+.*G(?:28|30|43|49|53)"
        r"|G(?:92|52) (?:.*\n)+.*G10 L2 .*R|G10 L1[01]? P1 (?:.*\n)+.*G43(?! ?H)"),
    "G84 and G74 in G18 and G19": Explained(
        "rs274 feeds to a point with its axes in the wrong order; the manual of LinuxCNC has the axis across the "
        "plane, as for G81.", r"motion", r"G[78]4"),
    "a corner that turns back": Explained(
        "Where the path turns back on itself within 3° into or out of an arc, rs274 cuts the outside corner short. "
        "ncsim rounds the corner, as the manual of LinuxCNC says.", r"(motion|gouge|concave corner|compensation-arc)", r"G4[12]"),
    "exact angles": Explained("Angles of whole degrees are exact in ncsim. In rs274 the cosine of 90 is 6e-17, which is true in a "
                              "condition and has a tangent, and acos[-0.5] is 120.00000000000001, which FUP rounds up.",
                              r"motion|not-a-number", r"COS\[ATAN|TAN\[A|F(?:UP|IX)\[.*A(?:COS|SIN|TAN)\["),
}

BEGIN, END = "<!-- rs274 -->", "<!-- /rs274 -->"


def write_table(path, total, counts):
    with open(path, encoding="utf-8") as page:
        text = page.read()
    rows = [f"| of {total} random programs | differ | why |", "| --- | --- | --- |"]
    rows += [f"| {name} | {counts.get(name, 0)} | {CLASSES[name].why} |" for name in CLASSES]
    before, rest = text.split(BEGIN)
    with open(path, "w", encoding="utf-8") as page:
        page.write(before + BEGIN + "\n" + "\n".join(rows) + "\n" + END + rest.split(END)[1])
