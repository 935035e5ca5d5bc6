#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-ignition-math and libignition-math6-6 6.10.0+ds3-7+b4 (geometry of the simulator Gazebo).
# Input:    the triangle 0,0,0 10,0,0 0,10,0 with vertical segments from z 5 to -5 or to 1, at 1681 places from -20 to 20; all pairs
#           of seven segments with the length 3.5 to 10. Source: documentation of the Python module (Triangle3d.intersects: "Get
#           whether the given line intersects this triangle"; contains: "Get whether this triangle contains the given
#           point"; Line3d.distance: "Get the shortest line between this line and the provided line").
# Expected: intersects is true if the segment passes through the triangle, which contains decides for the point in the plane.
#           The shortest line is as short as the least distance of 1001 points of the first segment from the second.
# Seen:     Each segment that passes through the plane of the triangle intersects it: 1626 of 1681 answers are wrong, also for
#           20.5,20.25, and the point returned is outside of the triangle. The segment that ends above the plane is right.
#           In 7 of 21 pairs, the shortest line is too long: 4.24 instead of 2.18 for two skew segments, 3.74 instead of 3.61 for
#           two parallel ones.

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
fetch python3-ignition-math=6.10.0+ds3-7+b4 libignition-math6-6=6.10.0+ds3-7+b4
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu

cat >check.py <<'PY'
import itertools
import math

from ignition.math import Line3d, Triangle3d, Vector3d


def line(start, end):
    return Line3d(Vector3d(*start), Vector3d(*end))


triangle = Triangle3d(Vector3d(0, 0, 0), Vector3d(10, 0, 0), Vector3d(0, 10, 0))
for bottom in (1, -5):
    wrong = 0
    for x, y in itertools.product(range(-20, 21), repeat=2):
        hit = triangle.intersects(line((x + 0.5, y + 0.25, 5), (x + 0.5, y + 0.25, bottom)), Vector3d())
        wrong += hit != (bottom < 0 and triangle.contains(Vector3d(x + 0.5, y + 0.25, 0)))
    print("segments to z %d: %d of 1681 answers are wrong" % (bottom, wrong))
point = Vector3d()
print("at 20.5,20.25: %s, at %s; contains: %s" % (
    triangle.intersects(line((20.5, 20.25, 5), (20.5, 20.25, -5)), point), point, triangle.contains(point)))


def sampled(first, second):
    (a, b), (c, d) = first, second
    side = [q - p for p, q in zip(c, d)]
    least = math.inf
    for i in range(1001):
        p = [s + (e - s) * i / 1000 for s, e in zip(a, b)]
        t = sum((p[k] - c[k]) * side[k] for k in range(3)) / sum(v * v for v in side)
        t = min(1, max(0, t))
        least = min(least, math.dist(p, [c[k] + t * side[k] for k in range(3)]))
    return least


segments = [((4, 4, 9), (2, 4, 1)), ((5, 3, 5), (5, 3, 1)), ((7, 0, 4), (7, 0, 0)), ((2, 3, 3), (0, 5, 1)),
            ((0, 0, 0), (10, 0, 0)), ((5, -5, 2), (5, 5, 2)), ((12, 2, 0), (20, 2, 0))]
wrong = pairs = 0
for first, second in itertools.combinations(segments, 2):
    shortest = Line3d()
    line(*first).distance(line(*second), shortest)
    expected = sampled(first, second)
    pairs += 1
    if abs(shortest.length() - expected) > 0.01:
        wrong += 1
        print("%s and %s: %.2f, sampled %.2f" % (first, second, shortest.length(), expected))
print("wrong distances: %d of %d" % (wrong, pairs))
PY
python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
segments to z 1: 0 of 1681 answers are wrong
segments to z -5: 1626 of 1681 answers are wrong
at 20.5,20.25: True, at 20.5 20.25 0; contains: False
((4, 4, 9), (2, 4, 1)) and ((5, 3, 5), (5, 3, 1)): 4.24, sampled 2.18
((4, 4, 9), (2, 4, 1)) and ((7, 0, 4), (7, 0, 0)): 7.07, sampled 5.74
((4, 4, 9), (2, 4, 1)) and ((12, 2, 0), (20, 2, 0)): 10.25, sampled 10.14
((5, 3, 5), (5, 3, 1)) and ((7, 0, 4), (7, 0, 0)): 3.74, sampled 3.61
((5, 3, 5), (5, 3, 1)) and ((2, 3, 3), (0, 5, 1)): 3.35, sampled 3.00
((7, 0, 4), (7, 0, 0)) and ((2, 3, 3), (0, 5, 1)): 5.92, sampled 5.83
((2, 3, 3), (0, 5, 1)) and ((12, 2, 0), (20, 2, 0)): 11.36, sampled 10.49
wrong distances: 7 of 21
EXPECTED
