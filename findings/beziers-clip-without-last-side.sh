#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-beziers 0.5.0+dfsg1-1 (BezierPath: curves, Boolean operations), python3-pyclipper 1.2.1-1+b4.
# Input:    squares of 10 that overlap in a corner and along a side; the Bezier curve 0,0 0,10 10,10 10,0; circles from
#           beziers.path.geometricshapes. Source: the docstrings of union, intersection, difference, area, bounds and includes
#           ("Returns True if the point is included in this bounding box").
# Expected: The union of two squares that share 25 is 175, the intersection 25, the difference 75. The curve rises to 7.5 and
#           crosses the line y = 5 twice. The area of a circle is pi r^2 for each radius. A box includes its centre.
# Seen:     The last side of each result is missing, and the area omits a triangle: 162.5, 12.5, 62.5. Squares that are apart
#           have the union -25 and 75. The curve has the height 0 and no intersection, because its cubic term is 0 in y; with
#           12 for one 10, all is right. A circle of radius 1 has 0.64 of its area, because flatten makes lines of
#           the length 8. A bounding box never includes a point. No error or warning appears.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Extracts Debian 12 packages into ./root, without installation: all that this machine has not installed.
fetch() {
  mkdir -p deb root
  apt-get install -s --no-install-recommends "$@" 2>log | sed -n 's/^Inst \([^ ]*\) .*(\([^ ]*\) .*/\1=\2/p' >list
  [ -s list ] || cat log >&2
  (cd deb && xargs apt-get download <../list >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch python3-beziers=0.5.0+dfsg1-1 python3-pyclipper=1.2.1-1+b4
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import math
from beziers.cubicbezier import CubicBezier
from beziers.line import Line
from beziers.path.geometricshapes import Circle, Square
from beziers.point import Point

square = Square(10)
for name, other in (("in a corner", Square(10, Point(5, 5))), ("along a side", Square(10, Point(4, 0))),
                    ("apart", Square(10, Point(20, 0))), ("hole", Square(4))):
    results = [[path.signed_area for path in operation(other)] for operation in
               (square.union, square.intersection, square.difference)]
    print(f"squares, {name}: union {results[0]}, intersection {results[1]}, difference {results[2]}")
print("intersection:", square.intersection(Square(10, Point(5, 5)))[0].asSVGPath().replace(".000000", ""))

for height in (10, 12):
    curve = CubicBezier(Point(0, 0), Point(0, height), Point(10, 10), Point(10, 0))
    top = max(curve.pointAtTime(i / 1000).y for i in range(1001))
    crossings = len(curve.intersections(Line(Point(-5, 5), Point(15, 5))))
    print(f"curve with 0,{height}: top {top:.2f}, bounds {curve.bounds().height:.2f}, {crossings} points at y = 5")

for radius in (1, 10, 100):
    print(f"circle of radius {radius}: {Circle(radius).area / (math.pi * radius ** 2):.3f} of its area")
print("the box of the circle includes its centre:", Circle(10).bounds().includes(Point(0, 0)))
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
squares, in a corner: union [162.5], intersection [12.5], difference [62.5]
squares, along a side: union [115.0], intersection [35.0], difference [45.0]
squares, apart: union [-25.0, 75.0], intersection [], difference [75.0]
squares, hole: union [75.0], intersection [12.0], difference [75.0, -12.0]
intersection: M 5 5 L 0 5  L 0 0  L 5 0  Z
curve with 0,10: top 7.50, bounds 0.00, 0 points at y = 5
curve with 0,12: top 8.27, bounds 8.27, 2 points at y = 5
circle of radius 1: 0.637 of its area
circle of radius 10: 0.895 of its area
circle of radius 100: 0.999 of its area
the box of the circle includes its centre: False
EXPECTED
