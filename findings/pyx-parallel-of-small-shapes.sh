#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-pyx 0.16-1+b2 (paths and PostScript graphics: deformer.parallel).
# Input:    a circle of radius 10, a regular hexagon of radius 10, a square of 20 and a triangle of 20 x 15, counter-clockwise,
#           with inward parallels. Source: documentation of deformer.parallel ("creates a parallel path to a given path";
#           a positive distance is on the left side).
# Expected: The circle by d has the area pi (10 - d)^2. The hexagon, whose sides are 8.66 from its centre, has the area
#           2 sqrt(3) (8.66 - d)^2. Nothing remains of the square from 10 on, and of the triangle from 5 on.
# Seen:     The circle is right up to 3; from 4 to 9.9 it is a TypeError ('NoneType' and 'float'). From 5.1 on, the parallel of
#           the hexagon lies outside of it with the area -541.94 instead of 43.9. The square by 10.1 becomes a clockwise
#           square of 40.2 x 40.2 with round corners; the triangle by 6 is a TypeError, by 9 it lies outside.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

apt-get download python3-pyx=0.16-1+b2 >/dev/null 2>log || { cat log >&2; exit 2; }
dpkg -x ./*.deb root

cat >check.py <<'PY'
import math

from pyx import deformer, path, unit

unit.set(defaultunit="mm")


def polygon(*points):
    return path.path(path.moveto(*points[0]), *[path.lineto(*point) for point in points[1:]], path.closepath())


# Signed area in square millimetres, each curve as 200 chords.
def area(curves):
    total = 0
    for curve in curves.normsubpaths:
        points = [item.at_pt([i / 200])[0] for item in curve.normsubpathitems for i in range(200)]
        total += sum(a[0] * b[1] - b[0] * a[1] for a, b in zip([points[-1]] + points, points)) / 2
    return total * (25.4 / 72) ** 2


def extent(curves):
    box = curves.bbox()
    return " to ".join(",".join(f"{round(unit.tomm(x), 1) + 0:g}" for x in corner)
                       for corner in ((box.left(), box.bottom()), (box.right(), box.top())))


hexagon = polygon(*[(10 * math.cos(i * math.pi / 3), 10 * math.sin(i * math.pi / 3)) for i in range(6)])
shapes = [("circle", path.circle(0, 0, 10), (3, 4, 9.9)), ("hexagon", hexagon, (4.9, 5.1, 6, 8)),
          ("square", polygon((0, 0), (20, 0), (20, 20), (0, 20)), (9.9, 10.1, 12)),
          ("triangle", polygon((0, 0), (20, 0), (0, 15)), (4, 6, 9))]
for name, shape, distances in shapes:
    print(f"{name}: area {area(shape.normpath()):.1f}, {extent(shape.normpath())}")
    for distance in distances:
        try:
            inside = deformer.parallel(distance).deform(shape.normpath())
            print(f"  by {distance}: area {area(inside):.1f}, {extent(inside)}")
        except TypeError:
            print(f"  by {distance}: TypeError")
PY
PYTHONPATH=$work/root/usr/lib/python3/dist-packages /usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
circle: area 314.2, -10,-10 to 10,10
  by 3: area 153.9, -7,-7 to 7,7
  by 4: TypeError
  by 9.9: TypeError
hexagon: area 259.8, -10,-8.7 to 10,8.7
  by 4.9: area 49.0, -4.3,-3.8 to 4.3,3.8
  by 5.1: area -541.9, -15.1,-13.8 to 15.1,13.8
  by 6: area -660.7, -16,-14.7 to 16,14.7
  by 8: area -906.0, -18,-16.7 to 18,16.7
square: area 400.0, 0,0 to 20,20
  by 9.9: area 0.0, 9.9,9.9 to 10.1,10.1
  by 10.1: area -1360.7, -10.1,-10.1 to 30.1,30.1
  by 12: area -1685.1, -12,-12 to 32,32
triangle: area 150.0, 0,0 to 20,15
  by 4: area 6.0, 4,4 to 8,7
  by 6: TypeError
  by 9: area -807.3, -9,-9 to 29,24
EXPECTED
