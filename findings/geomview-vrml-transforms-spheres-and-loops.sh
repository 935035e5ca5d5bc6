#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, geomview 1.9.5-4+b1 (oogl2vrml, oogl2vrml2 and anytooff).
# Input:    a box of 10 x 20 x 5 in an INST with one of six transforms; VECT with an open and a closed polyline; a sphere of radius 5
#           at 10,0,0. Source: manual of Geomview, file formats INST, VECT ("if negative, the vertices are closed") and SPHERE.
# Expected: The Transform node places the box where anytooff places it, or the converter refuses a transform that the node
#           cannot express. VRML contains both polylines and the centre of the sphere.
# Seen:     oogl2vrml2: a turn by 90 degrees about X becomes no turn, and so does a half turn about X. The turn x to y to z to x
#           becomes a turn about 1,-1,-1. The scale 2,3,4 becomes 2.8845 and a turn by 29.9 degrees. A mirrored box has
#           the scale nan. Only turns about Z are right. Both converters: the closed polyline is missing, and the sphere is at
#           the origin.

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
fetch geomview=1.9.5-4+b1
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu
tools=$work/root/usr/bin

cat >box.off <<'END'
OFF
8 6 12
0 0 0  10 0 0  10 20 0  0 20 0
0 0 5  10 0 5  10 20 5  0 20 5
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
END

cat >extent.py <<'PY'
import math
import re
import sys


# Applies the fields of a VRML Transform node without center and scaleOrientation.
def placed(point, scale, rotation, translation):
    point = [p * s for p, s in zip(point, scale)]
    length = math.hypot(*rotation[:3])
    axis, angle = [a / length for a in rotation[:3]], rotation[3]
    along = sum(a * p for a, p in zip(axis, point))
    cross = [axis[i - 2] * point[i - 1] - axis[i - 1] * point[i - 2] for i in range(3)]
    turned = [p * math.cos(angle) + c * math.sin(angle) + a * along * (1 - math.cos(angle))
              for p, c, a in zip(point, cross, axis)]
    return [t + m for t, m in zip(turned, translation)]


def extent(points):
    return " ".join(f"{round(min(c), 2) + 0:g}..{round(max(c), 2) + 0:g}" for c in zip(*points))


text = open(sys.argv[1]).read()
if text.startswith("#VRML"):
    fields = [[float(x) for x in re.search(name + r" (.*)", text)[1].split()] for name in ("scale", "rotation", "translation")]
    box = [(x, y, z) for x in (0, 10) for y in (0, 20) for z in (0, 5)]
    print("  oogl2vrml2:", extent([placed(point, *fields) for point in box]))
    scale, rotation = [" ".join(f"{x + 0:g}" for x in field) for field in fields[:2]]
    # The axis of no turn is different in each run.
    print(f"    scale {scale}, rotation {rotation if fields[1][3] else 'by 0'}")
else:
    numbers = [float(x) for x in re.findall(r"-?[\d.]+(?:e-?\d+)?", text.split("OFF")[1])]
    print("  anytooff:  ", extent([numbers[3 + 3 * i:6 + 3 * i] for i in range(8)]))
PY

place() {
  echo "$1"
  echo "{ = INST geom { < box.off } transform { $2  7 0 0 1 } }" >box.list
  "$tools/anytooff" box.list >out.off
  "$tools/oogl2vrml2" box.list >out.wrl
  python3 extent.py out.off
  python3 extent.py out.wrl
}
{
  place '90 about Z' '0 1 0 0  -1 0 0 0  0 0 1 0'
  place '90 about X' '1 0 0 0  0 0 1 0  0 -1 0 0'
  place '180 about X' '1 0 0 0  0 -1 0 0  0 0 -1 0'
  place 'x to y to z to x' '0 1 0 0  0 0 1 0  1 0 0 0'
  place 'scale 2,3,4' '2 0 0 0  0 3 0 0  0 0 4 0'
  place 'mirror x' '-1 0 0 0  0 1 0 0  0 0 1 0'

  printf 'VECT\n2 6 0\n2 -4\n0 0\n0 0 5 10 0 5\n0 0 0 10 0 0 10 10 0 0 10 0\n' >lines.vect
  echo 'SPHERE 5 10 0 0' >ball.list
  for converter in oogl2vrml oogl2vrml2; do
    echo "$converter, lines: $("$tools/$converter" lines.vect | sed -n '/coordIndex/,/\]/p' | tr -s ' \n' ' ')"
    echo "$converter, sphere: $("$tools/$converter" ball.list | tr -s ' \n' ' ')"
  done
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
90 about Z
  anytooff:   -13..7 0..10 0..5
  oogl2vrml2: -13..7 0..10 0..5
    scale 1 1 1, rotation 0 0 1 1.5708
90 about X
  anytooff:   7..17 -5..0 0..20
  oogl2vrml2: 7..17 0..20 0..5
    scale 1 1 1, rotation by 0
180 about X
  anytooff:   7..17 -20..0 -5..0
  oogl2vrml2: 7..17 0..20 0..5
    scale 1 1 1, rotation by 0
x to y to z to x
  anytooff:   7..12 0..10 0..20
  oogl2vrml2: 2..7 -10..0 0..20
    scale 1 1 1, rotation 1 -1 -1 2.0944
scale 2,3,4
  anytooff:   7..27 0..60 0..20
  oogl2vrml2: -21.78..32 0..64.39 0..14.42
    scale 2.8845 2.8845 2.8845, rotation 0 0 1 0.522245
mirror x
  anytooff:   -3..7 0..20 0..5
  oogl2vrml2: nan..nan nan..nan nan..nan
    scale nan nan nan, rotation by 0
oogl2vrml, lines:  coordIndex [ 0, 1, -1, -1, ] # end coordIndex 
oogl2vrml, sphere: #VRML V1.0 ascii Separator { ShapeHints {vertexOrdering COUNTERCLOCKWISE faceType CONVEX} Sphere { radius 5 } } # end final Separator 
oogl2vrml2, lines:  coordIndex [ 0, 1, -1, -1, ] # end coordIndex 
oogl2vrml2, sphere: #VRML V2.0 utf8 Group { children [ Sphere { radius 5 } ] # children } # Group 
EXPECTED
