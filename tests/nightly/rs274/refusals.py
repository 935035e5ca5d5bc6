#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares which programs of refusals.txt LinuxCNC's stand-alone interpreter and ncsim --strict refuse.

refusals.py NCSIM [--record FILE]

--record writes the programs and whether rs274 refused them, for the tests of gcode. Exit code 1 if the two
disagree on a program."""
import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import compare  # noqa: E402

HEAD = "G21 G90 G17 G40 G49 G80 G54\nT1 M6\nM3 S1000 F100\nG0 X0 Y0 Z5\n"
END = "G1 X30\nM2\n"


def programs():
    """Names and texts."""
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "refusals.txt")
    with open(path, encoding="ascii") as file:
        parts = file.read().split("== ")[1:]
    for part in parts:
        name, text = part.split("\n", 1)
        yield name, text.replace("HEAD\n", HEAD).replace("END\n", END)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ncsim")
    parser.add_argument("--record", metavar="FILE")
    args = parser.parse_args()
    recorded, different = [], 0
    for name, text in programs():
        answer = compare.run_rs274(text)
        refuses = answer is None or answer[1].strip() not in ("executing", "")
        ours = " error: " in compare.run_ncsim(os.path.abspath(args.ncsim), text, True)[1]
        if ours != refuses:
            different += 1
            print(f"{name}: rs274 {'refuses' if refuses else 'accepts'} it: "
                  + " ".join((answer or ["", "crash"])[1].split("\n")[1:]))
        recorded.append(f"== {name}\n{text}--\n" + ("refused\n" if refuses else ""))
    if args.record:
        with open(args.record, "w", encoding="ascii") as out:
            out.write("# Programs of tests/nightly/rs274/refusals.txt; \"refused\": rs274 (Debian's linuxcnc-uspace\n"
                      "# 2.9.0~pre1) reads no further. Written by tests/nightly/rs274/refusals.py --record.\n")
            out.writelines(recorded)
    print(f"{len(recorded)} programs, {different} differences")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
