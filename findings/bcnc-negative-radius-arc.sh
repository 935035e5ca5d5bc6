#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, bcnc 0.9.14.318+ds-4 (class CNC: path display, path length, time estimate).
# Input:    arcs of radius 5 from X5 Y0 to X0 Y5. A negative R selects the arc over 180 degrees.
# Expected: R5 gives an arc of length 7.854; R-5 gives an arc of length 23.562.
# Seen:     R5 gives 7.849 (chords). R-5 gives 7.071: a straight line from the start to the end, for G2 and for G3.
#           The program sent to the machine is unchanged, so display and machine differ.

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

cat >check.py <<'PY'
import builtins
import math

builtins._ = lambda text: text
from CNC import CNC


def arc_length(block):
    cnc = CNC()
    cnc.initPath()
    path = []
    for line in ("G21 G90 G17", "G1 X5 Y0", block):
        cnc.motionStart(CNC.parseLine(line))
        path = cnc.motionPath()
        cnc.motionEnd()
    return round(sum(math.dist(a[:3], b[:3]) for a, b in zip(path, path[1:])), 3)


seen = {block: arc_length(block) for block in ("G3 X0 Y5 R5", "G3 X0 Y5 R-5", "G2 X0 Y5 R5", "G2 X0 Y5 R-5")}
for block, value in seen.items():
    print(f"{block}: length {value}")
assert abs(seen["G3 X0 Y5 R5"] - 2.5 * math.pi) < 0.01
assert abs(seen["G2 X0 Y5 R5"] - 2.5 * math.pi) < 0.01
assert seen["G3 X0 Y5 R-5"] == seen["G2 X0 Y5 R-5"] == round(math.dist((5, 0), (0, 5)), 3), "behaviour changed"
PY
/usr/bin/python3 check.py
