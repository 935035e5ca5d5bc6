#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, bcnc 0.9.14.318+ds-4 (class GCode: load, move lines, save).
# Input:    a program with a block that begins with a comment: "(finish) G1 X2 Y0".
# Expected: The command "move lines" by X100 shifts all three feed moves: X101, X102, X103.
# Seen:     X101, X2, X103: the block with the leading comment keeps its coordinates.
#           The sender compiles the same block to G1X2Y0 and sends it, so the machine returns to X2.
#           The export to plain text omits the block.

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
fetch bcnc=0.9.14.318+ds-4 python3-numpy=1:1.24.2-1+deb12u1 python3-svgelements=1.7.2-2 \
  libblas3=3.11.0-2 liblapack3=3.11.0-2 libgfortran5=12.2.0-14+deb12u1 libquadmath0=12.2.0-14+deb12u1
lib=$work/root/usr/lib
bcnc=$work/root/usr/share/bcnc/bCNC
export HOME=$work
export LD_LIBRARY_PATH=$lib/x86_64-linux-gnu:$lib/x86_64-linux-gnu/blas:$lib/x86_64-linux-gnu/lapack
export PYTHONPATH=$lib/python3/dist-packages:$bcnc:$bcnc/lib:$bcnc/controllers

printf 'G90 G21 G17\nG1 X1 Y0 F100\n(finish) G1 X2 Y0\nG1 X3 Y0 (last)\n' >in.ngc
cat >check.py <<'PY'
import builtins

builtins._ = lambda text: text
from CNC import CNC, GCode

program = GCode()
program.init()
program.load("in.ngc")
every_line = [(b, i) for b, block in enumerate(program.blocks) for i in range(len(block))]
program.moveLines(every_line, 100, 0)
program.save("moved.ngc")
program.saveTXT("moved.txt")
moved = [line for line in open("moved.ngc").read().split("\n") if "G1 " in line]
plain = [line for line in open("moved.txt").read().split("\n") if "G1 " in line]
sent = [CNC.compileLine(line) for line in moved]
print("moved:", moved)
print("sent: ", sent)
print("text: ", plain)
assert moved == ["G1 X101 Y0 F100", "(finish) G1 X2 Y0", "G1 X103 Y0"], "behaviour changed"
assert sent == ["G1X101Y0F100", "G1X2Y0", "G1X103Y0"], "behaviour changed"
assert plain == ["G1 X101 Y0 F100", "G1 X103 Y0"], "behaviour changed"
PY
/usr/bin/python3 check.py
