#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, printrun-common 2.0.0~rc8-2 (modules stltool and gcoder), python3-numpy 1:1.24.2-1+deb12u1.
# Input:    a box of 10 x 20 x 30, turned by 90 degrees about each axis and mirrored in X; a pyramid 10 x 10 x 10, cut at
#           z 5 and at x 2; programs at 600 mm/min with moves of 1000 mm in total: absolute, relative, full circles, a
#           slope, a dwell G4 S20 and G4 P20000. Source: gcoder.py, comments on move types (G2, G3) and duration.
# Expected: Each rotation is counter-clockwise about its axis. The lower half of the pyramid has the volume 291.67 and a
#           top of 5 x 5; its part beyond x 2 has 298.67. Each mirrored part has a positive volume. Each
#           program of 1000 mm lasts about 100 seconds, each dwell 20. Circles extend to x 10 and x -10.
# Seen:     Rotation about X and Z is right, about Y clockwise. A cut moves the vertices beyond the plane to the plane: the
#           half pyramid has its apex at z 5 and the volume 166.67, the part beyond x 2 has 266.67. The mirrored box is
#           inside out. 100 relative moves of 10 mm last 1 second, because equal coordinates count as no motion. Circles
#           add 0 seconds, and x stays 0. Ten slopes of 100 mm in z and 1 mm in x last 1 second; G4 S lasts 0. Absolute
#           moves, moves in z only and G4 P are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Extracts pinned Debian 12 packages into ./root, without installation; for numpy all that this machine has not installed.
fetch() {
  mkdir -p deb root
  apt-get install -s --no-install-recommends python3-numpy=1:1.24.2-1+deb12u1 2>log |
    sed -n 's/^Inst \([^ ]*\) .*(\([^ ]*\) .*/\1=\2/p' >list
  (cd deb && xargs apt-get download "$@" <../list >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch printrun-common=2.0.0~rc8-2
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import numpy
from printrun.gcoder import GCode
from printrun.stltool import genfacet, stl


def solid(points, faces):
    part = stl()
    for face in faces:
        for i in range(1, len(face) - 1):
            part.facets.append(genfacet([numpy.array(points[k], float) for k in (face[0], face[i], face[i + 1])]))
    return part


def show(name, part):
    volume = sum(numpy.dot(f[0], numpy.cross(f[1], f[2])) for _, f in part.facets) / 6
    bounds = " ".join(f"{a:.0f}..{b:.0f}" for a, b in numpy.reshape(numpy.round(part.dims, 3) + 0.0, (3, 2)))
    print(f"{name}: {bounds}, volume {volume:.2f}")


corners = [(x, y, z) for x in (0, 10) for y in (0, 20) for z in (0, 30)]
box = solid(corners, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])
show("box", box)
for axis, angles in (("X", (90, 0, 0)), ("Y", (0, 90, 0)), ("Z", (0, 0, 90))):
    show(f"turned about {axis}", box.rotate(angles))
show("mirrored", box.scale([-1, 1, 1]))
pyramid = solid([(0, 0, 0), (10, 0, 0), (10, 10, 0), (0, 10, 0), (5, 5, 10)],
                [(0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)])
show("pyramid", pyramid)
show("below z 5", pyramid.cut(2, 1, 5))
show("beyond x 2", pyramid.cut(0, -1, 2))

for name, blocks in (
    ("absolute", ["G90"] + [f"G1 X{10 * i}" for i in range(1, 101)]),
    ("relative", ["G91"] + ["G1 X10"] * 100),
    ("circles", ["G90", "G1 Y10"] + ["G2 X0 Y10 I0 J-10"] * 16),
    ("slope", ["G90"] + [f"G1 X{i % 2} Z{100 * (i % 2)}" for i in range(1, 11)]),
    ("vertical", ["G90"] + [f"G1 Z{100 * (i % 2)}" for i in range(1, 11)]),
    ("G4 S20", ["G4 S20"]),
    ("G4 P20000", ["G4 P20000"]),
):
    program = GCode(["G21", "G90", "G1 X0 Y0 Z0 F600"] + blocks)
    print(f"{name}: {program.duration.total_seconds():.0f} s, x {program.xmin:.0f}..{program.xmax:.0f}")
PY
/usr/bin/python3 -W ignore check.py 2>/dev/null | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
box: 0..10 0..20 0..30, volume 6000.00
turned about X: 0..10 -30..0 0..20, volume 6000.00
turned about Y: -30..0 0..20 0..10, volume 6000.00
turned about Z: -20..0 0..10 0..30, volume 6000.00
mirrored: -10..0 0..20 0..30, volume -6000.00
pyramid: 0..10 0..10 0..10, volume 333.33
below z 5: 0..10 0..10 0..5, volume 166.67
beyond x 2: 2..10 0..10 0..10, volume 266.67
absolute: 100 s, x 0..1000
relative: 1 s, x 0..1000
circles: 1 s, x 0..0
slope: 1 s, x 0..1
vertical: 100 s, x 0..0
G4 S20: 0 s, x 0..0
G4 P20000: 20 s, x 0..0
EXPECTED
