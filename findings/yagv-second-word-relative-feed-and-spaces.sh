#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, yagv 0.4~20171211.r234ef16+dfsg-2 (viewer of G-code; its module gcodeParser). Python 3.11.
# Input:    programs with two G words in a block, with a feed in relative blocks, and with a space between letter and number.
#           Source: RS274/NGC: a line may have several G words of different modal groups; spaces and tabs are allowed anywhere
#           on a line; G91 is about axes, and F is a rate.
# Expected: G91 G1 X10 moves by 10, or a warning names the words that are not read. The feed of F600 F600 F600 is 600. X 10 is
#           X10.
# Seen:     Only the code at the start of a block is read: G91 G1 X10 and G90 G0 X40 move nothing, without a warning, and the
#           next block starts at 0. A block without a code is dropped with a warning. In relative blocks F adds up: 600, 1200,
#           1800. X 10 is X1, with a warning about an axis 1.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Extracts pinned Debian 12 packages into ./root, without installation.
fetch() {
  mkdir -p deb root
  (cd deb && apt-get download "$@" >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch yagv=0.4~20171211.r234ef16+dfsg-2
export PYTHONPATH=$work/root/usr/share/yagv PYTHONWARNINGS=ignore PYTHONDONTWRITEBYTECODE=1

cat >check.py <<'PY'
from gcodeParser import GcodeParser

programs = {
    "one G word": ["G91", "G1 X10 F600", "X5", "G1 X5"],
    "two G words": ["G91 G1 X10 F600", "G90 G0 X40", "G1 X50"],
    "feed in relative blocks": ["G91", "G1 X10 F600", "G1 X10 F600", "G1 X10 F600"],
    "feed in absolute blocks": ["G90", "G1 X10 F600", "G1 X20 F600", "G1 X30 F600"],
    "spaces": ["G1 X 10 Y 5 F600"],
}
for name, blocks in programs.items():
    print("%s: %s" % (name, " / ".join(blocks)))
    with open("program.nc", "w") as file:
        file.write("\n".join(blocks) + "\n")
    for segment in GcodeParser().parseFile("program.nc").segments:
        c = segment.coords
        print("  to X%g Y%g with F%g" % (c["X"], c["Y"], c["F"]))
PY
/usr/bin/python3 check.py 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
one G word: G91 / G1 X10 F600 / X5 / G1 X5
[WARN] Line 3: Unknown code 'X5' (Text:'X5')
  to X10 Y0 with F600
  to X15 Y0 with F600
two G words: G91 G1 X10 F600 / G90 G0 X40 / G1 X50
  to X50 Y0 with F0
feed in relative blocks: G91 / G1 X10 F600 / G1 X10 F600 / G1 X10 F600
  to X10 Y0 with F600
  to X20 Y0 with F1200
  to X30 Y0 with F1800
feed in absolute blocks: G90 / G1 X10 F600 / G1 X20 F600 / G1 X30 F600
  to X10 Y0 with F600
  to X20 Y0 with F600
  to X30 Y0 with F600
spaces: G1 X 10 Y 5 F600
[WARN] Line 1: Unknown axis '1' (Text:'G1 X 10 Y 5 F600')
[WARN] Line 1: Unknown axis '5' (Text:'G1 X 10 Y 5 F600')
  to X1 Y1 with F600
EXPECTED
