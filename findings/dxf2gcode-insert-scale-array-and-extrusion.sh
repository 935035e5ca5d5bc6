#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, dxf2gcode 20191025-2, python3-configobj 5.0.8-1. Install python3-pyqt5 and python3-opengl first.
# Input:    a block of two lines 0,0 - 4,0 - 4,1, inserted at 10,20 in six ways: scale 2,3 with the angle 0 and 90, scale
#           2,2 with 90, mirrored (scale -1,1) with 90, as an array of 3 x 2, with extrusion 0,0,-1. An ARC and a
#           CIRCLE with the centre 5,0, the radius 2 and extrusion 0,0,-1; the arc is from 0 to 90 degrees.
# Expected: DXF scales a block along its own axes and then turns it: 2,3 at 90 degrees ends at 7,28, and -1,1 at 9,16.
#           The array has six copies. Extrusion 0,0,-1 mirrors X: the insert ends at -14,21, the arc connects -3,0 and -5,2.
# Seen:     The factors are applied after the angle, along the axes of the drawing: 8,32 and 11,24. Only the
#           first copy of the array is milled. The extrusion of INSERT is ignored. The circle is mirrored;
#           the arc is not: it connects 3,0 and 5,-2. The exit status is 0 and no message about the contour appears.
# Note:     The default drawing area (mode3d = False) stops with a TypeError, so the configuration has mode3d = True.

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
fetch dxf2gcode=20191025-2 python3-configobj=5.0.8-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages HOME=$work QT_QPA_PLATFORM=offscreen
/usr/bin/python3 root/usr/bin/dxf2gcode --help >log 2>&1 # writes the configuration
sed -i 's/mode3d = False/mode3d = True/' .config/dxf2gcode/config/config.cfg

cat >check.py <<'PY'
import re
import subprocess


def tags(*items):
    return "".join(f"{item}\n" for item in items)


def section(name, content):
    return tags(0, "SECTION", 2, name) + content + tags(0, "ENDSEC")


def line(handle, x1, y1, x2, y2):
    return tags(0, "LINE", 5, handle, 8, 0, 10, x1, 20, y1, 30, 0, 11, x2, 21, y2, 31, 0)


block = tags(0, "BLOCK", 5, "B1", 8, 0, 2, "B", 70, 0, 10, 0, 20, 0, 30, 0)
block += line("B2", 0, 0, 4, 0) + line("B3", 4, 0, 4, 1) + tags(0, "ENDBLK", 5, "B4", 8, 0)
down = (210, 0, 220, 0, 230, -1)


def insert(*items):
    return tags(0, "INSERT", 5, "A1", 8, 0, 2, "B", 10, 10, 20, 20, 30, 0, *items)


def show(name, entity):
    with open("in.dxf", "w") as dxf:
        dxf.write(section("HEADER", tags(9, "$ACADVER", 1, "AC1015")) + section("BLOCKS", block))
        dxf.write(section("ENTITIES", entity) + tags(0, "EOF"))
    command = ["/usr/bin/python3", "root/usr/bin/dxf2gcode", "-q", "-e", "out.ngc", "in.dxf"]
    subprocess.run(command, check=True, capture_output=True)
    shapes = re.split(r"SHAPE Nr", open("out.ngc").read())[1:]
    ends = []
    for shape in shapes:
        moves = re.findall(r"^G[0-3] X *(\S+) Y *(\S+)", shape, re.M)
        ends += [f"{float(x):g},{float(y):g}" for x, y in moves if float(x) or float(y)]
    print(f"{name}: {len(shapes)} contour, points {' '.join(sorted(set(ends)))}")


show("scale 2,3, angle 0", insert(41, 2, 42, 3, 43, 1))
show("scale 2,3, angle 90", insert(41, 2, 42, 3, 43, 1, 50, 90))
show("scale 2,2, angle 90", insert(41, 2, 42, 2, 43, 2, 50, 90))
show("scale -1,1, angle 90", insert(41, -1, 42, 1, 43, 1, 50, 90))
show("array 3 x 2", insert(70, 3, 71, 2, 44, 15, 45, 17))
show("insert, extrusion -1", insert(*down))
show("circle, extrusion -1", tags(0, "CIRCLE", 5, "A1", 8, 0, 10, 5, 20, 0, 30, 0, 40, 2, *down))
show("arc, extrusion -1", tags(0, "ARC", 5, "A1", 8, 0, 10, 5, 20, 0, 30, 0, 40, 2, 50, 0, 51, 90, *down))
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
scale 2,3, angle 0: 1 contour, points 10,20 18,20 18,23
scale 2,3, angle 90: 1 contour, points 10,20 10,32 8,32
scale 2,2, angle 90: 1 contour, points 10,20 10,28 8,28
scale -1,1, angle 90: 1 contour, points 10,20 10,24 11,24
array 3 x 2: 1 contour, points 10,20 14,20 14,21
insert, extrusion -1: 1 contour, points 10,20 14,20 14,21
circle, extrusion -1: 1 contour, points -3.586,1.414 -6.414,-1.414
arc, extrusion -1: 1 contour, points 3,0 5,-2
EXPECTED
