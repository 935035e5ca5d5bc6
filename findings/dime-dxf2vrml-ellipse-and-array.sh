#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, dime 0.20111205-2.1 (dxf2vrml).
# Input:    DXF files with one entity each: a quarter of an ELLIPSE (centre 5,0, half axes 4 in Y and 2), an INSERT as
#           an array of 3 columns and 2 rows with the angle 90, a closed half disc of two vertices (bulge 1 from 0,0
#           to 10,0) as LWPOLYLINE and as POLYLINE, and a POLYLINE with a third vertex at 5,8.
# Expected: The ellipse arc goes from 5,4 to 3,0. The array turns with the angle: columns along Y, rows along -X.
#           The half disc has an arc and a straight line back to the start.
# Seen:     The ellipse has half the size: from 5,2 to 4,0. The contents of the array turn, the array does not.
#           LWPOLYLINE loses the bulge: a line to and fro. POLYLINE has the arc and is open: the line back is missing.
#           With the third vertex the closing line is there. The exit status is 0 and no message appears.

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
fetch dime=0.20111205-2.1 libdime1=0.20111205-2.1
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu

cat >check.py <<'PY'
import re
import subprocess


def tags(*items):
    return "".join(f"{item}\n" for item in items)


def section(name, content):
    return tags(0, "SECTION", 2, name) + content + tags(0, "ENDSEC")


def lines(name, entity, blocks=""):
    with open("in.dxf", "w") as dxf:
        dxf.write(section("HEADER", tags(9, "$ACADVER", 1, "AC1015")) + section("BLOCKS", blocks))
        dxf.write(section("ENTITIES", entity) + tags(0, "EOF"))
    subprocess.run(["root/usr/bin/dxf2vrml", "in.dxf", "-o", "out.wrl", "-e", "1"], check=True)
    text = open("out.wrl").read()
    numbers = [round(float(n), 2) + 0.0 for n in re.search(r"point \[([^]]*)\]", text).group(1).replace(",", " ").split()]
    points = [f"{x:g},{y:g}" for x, y in zip(numbers[0::3], numbers[1::3])]
    indices = re.search(r"coordIndex \[([^]]*)\]", text).group(1).replace(",", " ").split()
    chains = " ".join(indices).split("-1")
    return [[points[int(i)] for i in chain.split()] for chain in chains if chain.split()]


def ends(chain):
    return f"{chain[0]} to {chain[-1]} in {len(chain) - 1} lines"


ellipse = tags(0, "ELLIPSE", 8, 0, 10, 5, 20, 0, 30, 0, 11, 0, 21, 4, 31, 0, 40, 0.5, 41, 0, 42, 1.5707963)
print("ELLIPSE:", *[f"{c[0]} to {c[-1]}" for c in lines("ellipse", ellipse)])

block = tags(0, "BLOCK", 8, 0, 2, "B", 70, 0, 10, 0, 20, 0, 30, 0)
block += tags(0, "LINE", 8, 0, 10, 0, 20, 0, 30, 0, 11, 1, 21, 0, 31, 0, 0, "ENDBLK", 8, 0)
array = tags(0, "INSERT", 8, 0, 2, "B", 10, 0, 20, 0, 30, 0, 50, 90, 70, 3, 71, 2, 44, 5, 45, 7)
print("INSERT:", *[" to ".join(c) for c in lines("array", array, block)], sep="\n  ")

light = tags(0, "LWPOLYLINE", 8, 0, 90, 2, 70, 1, 10, 0, 20, 0, 42, 1, 10, 10, 20, 0)
print("LWPOLYLINE:", *[ends(c) for c in lines("light", light)])
for third in "", tags(0, "VERTEX", 8, 0, 10, 5, 20, 8):
    heavy = tags(0, "POLYLINE", 8, 0, 66, 1, 70, 1, 0, "VERTEX", 8, 0, 10, 0, 20, 0, 42, 1)
    heavy += tags(0, "VERTEX", 8, 0, 10, 10, 20, 0) + third + tags(0, "SEQEND")
    print("POLYLINE:", ", ".join(ends(c) for c in lines("heavy", heavy)))
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
ELLIPSE: 5,2 to 4,0
INSERT:
  0,0 to 0,1
  5,0 to 5,1
  10,0 to 10,1
  0,7 to 0,8
  5,7 to 5,8
  10,7 to 10,8
LWPOLYLINE: 0,0 to 0,0 in 2 lines
POLYLINE: 0,0 to 10,0 in 3 lines
POLYLINE: 0,0 to 10,0 in 3 lines, 10,0 to 0,0 in 2 lines
EXPECTED
