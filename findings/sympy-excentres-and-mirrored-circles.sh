#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-sympy 1.11.1-1 (module geometry), python3-mpmath 1.2.1-2.
# Input:    the triangles 0,0 3,0 0,4 and 0,0 4,0 2,3.46; a circle of radius 3, reflected, scaled by -1 in Y and turned; an
#           ellipse, scaled by -1 in Y; a rectangle of 10 x 6, counter-clockwise and clockwise. Source: docstrings of
#           Triangle.excenters ("the center of a circle that is tangent to a side of the triangle and the extensions of
#           the other two sides"), encloses_point, second_moment_of_area and section_modulus. A signed area is documented
#           for polygons only.
# Expected: Each excentre has the distance exradius from all three lines: 2, 6 and 3 for the first triangle. Reflection
#           keeps the area 28.27, the circumference and the enclosed centre. The second moments about the
#           centroid are 180 and 500 for both directions.
# Seen:     No excentre has equal distances: 2.67, 11.20 and 15.00 instead of 2. The radii and the incentre are right. The
#           reflected circle has the radius -3, the area -28.27 and the circumference -18.85, does not enclose the point,
#           and its bounds are reversed; the scaled ellipse has the area -47.12. Clockwise, moments and section moduli are
#           negative. The turned and the scaled circle are right. No error is raised.

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
fetch python3-sympy=1.11.1-1 python3-mpmath=1.2.1-2

cat >check.py <<'PY'
from sympy import Rational, pi, sqrt
from sympy.geometry import Circle, Ellipse, Line, Point, Polygon, Triangle


def distance(line, point):
    (x1, y1), (x2, y2), (x, y) = [[float(v) for v in p] for p in (*line, point)]
    return abs((x2 - x1) * (y - y1) - (y2 - y1) * (x - x1)) / ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5


for triangle in (Triangle((0, 0), (3, 0), (0, 4)), Triangle((0, 0), (4, 0), (2, 2 * sqrt(3)))):
    lines = [side.points for side in triangle.sides]
    print(f"incentre: {', '.join(f'{distance(line, triangle.incenter):.2f}' for line in lines)}; "
          f"inradius {float(triangle.inradius):.2f}")
    for side in triangle.sides:
        centre = triangle.excenters[side]
        print(f"excentre {float(centre.x):.2f},{float(centre.y):.2f}: "
              f"{', '.join(f'{distance(line, centre):.2f}' for line in lines)}; "
              f"exradius {float(triangle.exradii[side]):.2f}")


def show(name, shape, inside):
    bounds = " ".join(f"{float(v):g}" for v in shape.bounds)
    print(f"{name}: radii {shape.hradius} {shape.vradius}, area {float(shape.area):.2f}, "
          f"circumference {float(shape.circumference):.2f}, encloses {inside}: "
          f"{shape.encloses_point(Point(*inside))}, bounds {bounds}")


circle = Circle((0, 4), 3)
near = Rational(1, 2)
show("circle", circle, (near, 4))
show("turned", circle.rotate(-pi / 2), (4, near))
show("reflected", circle.reflect(Line((0, 0), (1, 1))), (4, near))
show("scaled", circle.scale(1, -1), (near, -4))
ellipse = Ellipse((0, 0), 5, 3).scale(1, -1)
print(f"scaled ellipse: radii {ellipse.hradius} {ellipse.vradius}, area {float(ellipse.area):.2f}")

corners = [(0, 0), (10, 0), (10, 6), (0, 6)]
for name, polygon in (("counter-clockwise", Polygon(*corners)), ("clockwise", Polygon(*reversed(corners)))):
    print(f"{name}: second moments {polygon.second_moment_of_area()}, polar {polygon.polar_second_moment_of_area()}, "
          f"section moduli {polygon.section_modulus()}")
PY
PYTHONPATH=$work/root/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
incentre: 1.00, 1.00, 1.00; inradius 1.00
excentre 15.00,2.67: 2.67, 11.20, 15.00; exradius 2.00
excentre -15.00,8.00: 8.00, 9.60, 15.00; exradius 6.00
excentre 15.00,-4.00: 4.00, 7.20, 15.00; exradius 3.00
incentre: 1.15, 1.15, 1.15; inradius 1.15
excentre 18.00,3.46: 3.46, 13.86, 13.86; exradius 3.46
excentre -14.00,3.46: 3.46, 13.86, 13.86; exradius 3.46
excentre 14.00,-3.46: 3.46, 6.93, 13.86; exradius 3.46
circle: radii 3 3, area 28.27, circumference 18.85, encloses (1/2, 4): True, bounds -3 1 3 7
turned: radii 3 3, area 28.27, circumference 18.85, encloses (4, 1/2): True, bounds 1 -3 7 3
reflected: radii -3 3, area -28.27, circumference -18.85, encloses (4, 1/2): False, bounds 7 -3 1 3
scaled: radii 3 3, area 28.27, circumference 18.85, encloses (1/2, -4): True, bounds -3 -7 3 -1
scaled ellipse: radii 5 -3, area -47.12
counter-clockwise: second moments (180, 500, 0), polar 680, section moduli (60, 100)
clockwise: second moments (-180, -500, 0), polar -680, section moduli (-60, -100)
EXPECTED
