# SPDX-License-Identifier: GPL-3.0-or-later
"""Faults that are put into NC programs and set-ups: mistakes of editors, posts and operators.

Each fault of FAULTS has a name, a description, and a function that takes the lines of a program (or its
set-up) and a random generator, and returns the changed lines, or None where the program has no place for
the fault. `needs` names what a check cannot know without more input:
    design   the shape of the part
    limits   limits of feed and speed, or that a feed move in air matters: `ncsim diff --process`
"""
import re
from collections import namedtuple

Fault = namedtuple("Fault", "name description inject needs of")

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)"
COMMENT = re.compile(r"\([^)]*\)|;.*")


def code_of(line):
    """The words of a line without comments, block number and blanks at the ends."""
    return re.sub(r"^\s*/?\s*N\d+", "", COMMENT.sub(" ", line)).strip()


def places(lines, pattern):
    """Numbers of the lines with a word that `pattern` matches outside of comments."""
    return [i for i, line in enumerate(lines) if re.search(pattern, code_of(line))]


def on_code(line, pattern, replacement):
    """The line with the first match outside of comments replaced."""
    start = 0
    for comment in [*COMMENT.finditer(line), None]:
        end = comment.start() if comment else len(line)
        changed, count = re.subn(pattern, replacement, line[start:end], count=1)
        if count:
            return line[:start] + changed + line[end:]
        start = comment.end() if comment else end
    return line


def at_a_place(lines, rng, pattern, replacement, among=None):
    """Replaces the first match of `pattern` in one line, chosen among those that have it."""
    there = [i for i in places(lines, pattern) if among is None or i in among]
    rng.shuffle(there)
    for i in there:
        changed = on_code(lines[i], pattern, replacement)
        if changed != lines[i]:
            return lines[:i] + [changed] + lines[i + 1:]
    return None


def without_a_line(lines, rng, pattern, among=None):
    there = [i for i in places(lines, pattern) if among is None or i in among]
    if not there:
        return None
    i = rng.choice(there)
    return lines[:i] + lines[i + 1:]


def word(letter, value=NUMBER):
    return rf"(?<![A-Z#\[<]){letter}\s*({value})(?![\d.])"


def code(letter, number):
    return rf"(?<![A-Z#\[<]){letter}0?{number}(?![\d.])"


def motion_modes(lines):
    """G0, G1, G2, G3, or the cycle that holds at each line; None before the first."""
    modes, mode = [], None
    for line in lines:
        for number in re.findall(r"(?<![A-Z#])G0?(\d+)(?![\d.])", code_of(line)):
            if int(number) in (0, 1, 2, 3, 73, 80, 81, 82, 83, 84, 85, 86, 89):
                mode = int(number)
        modes.append(mode)
    return modes


def moves(lines, modes):
    """Numbers of the lines that move in X, Y or Z under one of the modes."""
    return {i for i, mode in enumerate(motion_modes(lines))
            if mode in modes and re.search(word("[XYZ]"), code_of(lines[i]))}


def retracts(lines):
    """Lines that only lift the tool: a rapid move along Z to above zero."""
    return {i for i in moves(lines, {0}) if re.search(word("Z", r"\+?\d+\.?\d*"), code_of(lines[i]))
            and not re.search(word("[XY]"), code_of(lines[i]))}


def number_text(value):
    text = f"{value:.4f}".rstrip("0")
    return text


def scaled(letter, factor):
    def change(match):
        return f"{letter}{number_text(float(match[1]) * factor)}"
    return change


def lost_point(match):
    whole, _, digits = match[2].partition(".")
    return match[1] + whole + digits if digits.strip("0") else match[0]


def exchanged_digits(match):
    digits = match[2]
    return match[1] + digits[1] + digits[0] + digits[2:] if digits[0] != digits[1] else match[0]


def inserted(lines, rng, text, among):
    there = sorted(among)
    if not there:
        return None
    i = rng.choice(there)
    return lines[:i] + [text] + lines[i:]


def tools_of(lines):
    found = []
    for line in lines:
        for number in re.findall(word("T", r"\d+"), code_of(line)):
            if number not in found:
                found.append(number)
    return found


def other_tool(lines, rng):
    tools = tools_of(lines)
    if not tools:
        return None
    def change(match):
        others = [t for t in tools if int(t) != int(match[1])]
        return "T" + (others[0] if others else str(int(match[1]) + 1))
    return at_a_place(lines, rng, word("T", r"\d+"), change)


def tools_exchanged(lines, rng):
    tools = tools_of(lines)
    if len(tools) < 2:
        return None
    a, b = tools[0], tools[1]
    def change(match):
        return "T" + (b if match[1] == a else a if match[1] == b else match[1])
    return [re.sub(word("T", r"\d+"), change, line) if not line.lstrip().startswith(("(", ";")) else line
            for line in lines]


def wrong_h(lines, rng):
    def change(match):
        others = [t for t in tools_of(lines) if int(t) != int(match[1])]
        return "H" + (others[0] if others else str(int(match[1]) + 1))
    return at_a_place(lines, rng, word("H", r"\d+"), change)


def axes_exchanged(lines, rng):
    there = [i for i in moves(lines, {0, 1, 2, 3})
             if re.search(word("X"), code_of(lines[i])) and re.search(word("Y"), code_of(lines[i]))]
    if not there:
        return None
    i = rng.choice(sorted(there))
    line = on_code(lines[i], "X", "\0")
    line = on_code(line, "Y", "X").replace("\0", "Y")
    return lines[:i] + [line] + lines[i + 1:]


def blocks_exchanged(lines, rng):
    cuts = sorted(moves(lines, {1, 2, 3}))
    there = [i for i in cuts if i + 1 in cuts and code_of(lines[i]) != code_of(lines[i + 1])]
    if not there:
        return None
    i = rng.choice(there)
    return lines[:i] + [lines[i + 1], lines[i]] + lines[i + 2:]


def rapid_for_feed(lines, rng):
    return at_a_place(lines, rng, code("G", 1), "G0", moves(lines, {1}))


def spindle_lost(lines, rng):
    there = places(lines, code("M", "[34]"))
    if not there:
        return None
    return [on_code(line, code("M", "[34]"), "") if i in there else line for i, line in enumerate(lines)]


def feeds_lost(lines, rng):
    changed = [on_code(line, word("F"), "") for line in lines]
    return changed if changed != lines else None


def units_exchanged(lines, rng):
    if places(lines, code("G", 21)):
        return at_a_place(lines, rng, code("G", 21), "G20")
    return at_a_place(lines, rng, code("G", 20), "G21")


def retract_before_change_lost(lines, rng):
    changes = places(lines, code("M", 6))
    lifts = sorted(retracts(lines))
    between = [max((i for i in lifts if i < change), default=None) for change in changes[1:]]
    there = [i for i in between if i is not None]
    if not there:
        return None
    i = rng.choice(there)
    return lines[:i] + lines[i + 1:]


def comment_of_another_tool(lines, rng):
    calls = [i for i in places(lines, word("T", r"\d+"))]
    if not calls:
        return None
    number = re.search(word("T", r"\d+"), code_of(lines[calls[0]]))[1]
    return lines[:calls[0]] + [f"(T{number} D=17. CR=0. - flat end mill)"] + lines[calls[0]:]


# Of the set-up: a function that takes it as a dictionary (toml) and returns the changed one.
def stock_higher(setup, rng):
    if "stock" not in setup or "max" not in setup["stock"]:
        return None
    stock = dict(setup["stock"], max=[*setup["stock"]["max"][:2], setup["stock"]["max"][2] + 2])
    return dict(setup, stock=stock)


def flutes_shorter(setup, rng):
    tools = [dict(t) for t in setup.get("tool", [])]
    if not tools or any("length" not in t for t in tools):
        return None
    for tool in tools:
        tool["length"] = tool["length"] / 4
    return dict(setup, tool=tools)


def holder_lower(setup, rng):
    tools = [dict(t) for t in setup.get("tool", [])]
    if not tools or any("stick_out" not in t for t in tools):
        return None
    for tool in tools:
        tool["stick_out"] = tool["stick_out"] / 2
        tool["length"] = min(tool["length"], tool["stick_out"])
        tool.pop("shank_length", None)
        tool.pop("shank_diameter", None)
    return dict(setup, tool=tools)


PROGRAM, SETUP, CLAMP = "program", "set-up", "clamp"


def f(name, description, inject, needs="", of=PROGRAM):
    return Fault(name, description, inject, needs, of)


FAULTS = [
    f("g43-lost", "G43 left out of a block", lambda l, r: at_a_place(l, r, code("G", 43) + r"\s*(?:H\s*\d+)?", "")),
    f("wrong-h", "H of another tool", wrong_h),
    f("point-lost", "a number loses its decimal point: X12.5, X125",
      lambda l, r: at_a_place(l, r, r"(?<![A-Z#\[<])([XYZ]-?)(\d+\.\d+)", lost_point), "design"),
    f("digits-exchanged", "two digits exchanged: X12, X21",
      lambda l, r: at_a_place(l, r, r"(?<![A-Z#\[<])([XYZ]-?)(\d\d)", exchanged_digits), "design"),
    f("sign-of-z", "the sign of a Z is lost or added",
      lambda l, r: at_a_place(l, r, word("Z"), lambda m: "Z" + number_text(-float(m[1])) if float(m[1]) else m[0],
                              moves(l, {0, 1, 2, 3})), "design"),
    f("sign-of-x-or-y", "the sign of an X or Y is lost or added",
      lambda l, r: at_a_place(l, r, r"(?<![A-Z#\[<])([XY])\s*(" + NUMBER + ")",
                              lambda m: m[1] + number_text(-float(m[2])) if float(m[2]) else m[0],
                              moves(l, {0, 1, 2, 3})), "design"),
    f("axes-exchanged", "X and Y exchanged in a block", axes_exchanged, "design"),
    f("deeper", "a Z of a cut 2 mm deeper",
      lambda l, r: at_a_place(l, r, word("Z", r"-\d+\.?\d*"), lambda m: "Z" + number_text(float(m[1]) - 2),
                              moves(l, {1, 2, 3})), "design"),
    f("block-lost", "a block of a cut left out",
      lambda l, r: without_a_line(l, r, word("[XYZ]"), moves(l, {1, 2, 3})), "design"),
    f("blocks-exchanged", "two blocks of a cut exchanged", blocks_exchanged, "design"),
    f("offset-exchanged", "G54 becomes G55, or G55 G54",
      lambda l, r: at_a_place(l, r, code("G", "5([45])"), lambda m: "G55" if m[1] == "4" else "G54"), "design"),
    f("tools-exchanged", "two tools exchanged in the whole program", tools_exchanged, "design"),
    f("wrong-tool", "another tool in one call", other_tool, "design"),
    f("tool-change-lost", "M6 left out", lambda l, r: at_a_place(l, r, code("M", 6), ""), "design"),
    f("retract-lost", "a rapid move up left out", lambda l, r: without_a_line(l, r, word("Z"), retracts(l)), "design"),
    f("retract-too-low", "a rapid move up ends below the top",
      lambda l, r: at_a_place(l, r, word("Z", r"\+?\d+\.?\d*"), "Z-1.", retracts(l)), "design"),
    f("retract-before-change-lost", "no rapid move up before a tool change", retract_before_change_lost, "design"),
    f("rapid-for-feed", "G1 becomes G0", rapid_for_feed, "design"),
    f("plane-left-on", "G18 before a cut", lambda l, r: inserted(l, r, "G18", moves(l, {2, 3})), "design"),
    f("arc-direction", "G2 becomes G3, or G3 G2",
      lambda l, r: at_a_place(l, r, code("G", "([23])"), lambda m: "G3" if m[1] == "2" else "G2"), "design"),
    f("arc-centre", "the sign of I or J lost or added",
      lambda l, r: at_a_place(l, r, r"(?<![A-Z#\[<])([IJ])\s*(" + NUMBER + ")",
                              lambda m: m[1] + number_text(-float(m[2])) if float(m[2]) else m[0]), "design"),
    f("incremental-left-on", "G91 from some block on",
      lambda l, r: inserted(l, r, "G91", moves(l, {0, 1, 2, 3})), "design"),
    f("absolute-lost", "G90 left out", lambda l, r: at_a_place(l, r, code("G", 90), "")),
    f("units-exchanged", "G21 becomes G20, or G20 G21", units_exchanged, "design"),
    f("spindle-not-started", "M3 left out", spindle_lost),
    f("spindle-backwards", "M3 becomes M4", lambda l, r: at_a_place(l, r, code("M", 3), "M4")),
    f("spindle-stopped", "M5 before a cut", lambda l, r: inserted(l, r, "M5", moves(l, {1, 2, 3})), "limits"),
    f("feeds-lost", "every F left out", feeds_lost),
    f("feed-times-ten", "an F ten times as high", lambda l, r: at_a_place(l, r, word("F"), scaled("F", 10)), "limits"),
    f("speed-times-ten", "an S ten times as high", lambda l, r: at_a_place(l, r, word("S"), scaled("S", 10)), "limits"),
    f("cycle-r-too-low", "R of a drilling cycle inside the part",
      lambda l, r: at_a_place(l, r, word("R"), "R-1.5", places(l, code("G", "8[1235]"))), "design"),
    f("cycle-q-lost", "Q of a pecking cycle left out",
      lambda l, r: at_a_place(l, r, word("Q"), "", places(l, code("G", "83"))), "design"),
    f("cycle-left-on", "G80 left out", lambda l, r: at_a_place(l, r, code("G", 80), "", places(l, r"^G80$")), "design"),
    f("letter-for-digit", "the letter O for the digit 0: X1O.",
      lambda l, r: at_a_place(l, r, r"(?<![A-Z#\[<])([XYZ]-?\d*)0", r"\1O")),
    f("comment-of-another-tool", "a comment describes another tool than the set-up", comment_of_another_tool),
    f("stock-higher", "the stock is 2 mm higher", stock_higher, "design", SETUP),
    f("flutes-shorter", "flutes of a quarter of the length", flutes_shorter, "", SETUP),
    f("holder-lower", "tools stick out half as far", holder_lower, "", SETUP),
    f("clamp-moved", "a clamp stands where the stock is cut", None, "", CLAMP),
]
