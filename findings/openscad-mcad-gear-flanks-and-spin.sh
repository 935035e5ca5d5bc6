#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, openscad 2021.01-6 with its library openscad-mcad 2019.05-1 (gears.scad, screw.scad, multiply.scad,
#           regular_shapes.scad; involute_gears.scad for comparison).
# Input:    a gear with 20 teeth, module 2 and pressure angle 20; a ball groove of diameter 20; spin(4); an elliptical
#           prism with rx 8, ry 5.
# Expected: The tooth of an involute gear is 3.14 thick at the pitch circle and 1.615 at the radius 21.8. The centre line
#           of the groove has the radius 10. spin(4) gives four copies. The prism has the size 16 x 10.
# Seen:     gears.scad uses an angle in radians as degrees: the tooth becomes thicker outwards, 3.255, so two such gears
#           cannot mesh. involute_gears.scad is right within 0.002. The radius of the groove is 20; ball_groove2 has 10.
#           spin divides by the index instead of by the number: three copies coincide at 0 degrees, one is at 120.
#           oval_prism exchanges rx and ry, oval_tube does not. No warning about these appears.

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
fetch openscad=2021.01-6 openscad-mcad=2019.05-1
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu:$work/root/usr/lib HOME=$work
export OPENSCADPATH=$work/root/usr/share/openscad/libraries

cat >check.py <<'PY'
import math
import re
import subprocess


def render(library, body, path):
    with open("in.scad", "w") as program:
        program.write(f"use <MCAD/{library}>\n{body}\n")
    subprocess.run(["root/usr/bin/openscad", "-o", path, "in.scad"], check=True, capture_output=True)
    return open(path).read()


def loops(library, body):
    data = re.search(r' d="([^"]*)"', render(library, body, "out.svg")).group(1)
    found = [[tuple(map(float, pair.split(","))) for pair in re.findall(r"[-\d.e]+,[-\d.e]+", loop)] for loop in data.split("z")]
    return [loop for loop in found if loop]


def sizes(library, body):
    rows = [line.split() for line in render(library, body, "out.stl").splitlines()]
    vertices = [tuple(map(float, row[1:])) for row in rows if row[:1] == ["vertex"]]
    return [max(p[i] for p in vertices) - min(p[i] for p in vertices) for i in range(3)]


def thickness(loop, radius):
    """Returns the arc length of the tooth around the positive X axis at `radius`."""
    angles = []
    for (x0, y0), (x1, y1) in zip(loop, loop[1:] + loop[:1]):
        r0, r1 = math.hypot(x0, y0), math.hypot(x1, y1)
        if (r0 - radius) * (r1 - radius) < 0:
            t = (radius - r0) / (r1 - r0)
            angles.append(math.atan2(y0 + t * (y1 - y0), x0 + t * (x1 - x0)))
    first, second = sorted(angles, key=abs)[:2]
    return abs(first - second) * radius


def involute(angle):
    return math.tan(angle) - angle


radii = (18.9, 20, 21, 21.8)
base = 20 * math.cos(math.radians(20))
exact = [2 * r * (math.pi / 40 + involute(math.radians(20)) - involute(math.acos(base / r))) for r in radii]
print("tooth at the radii", *radii)
print("involute:            ", *(f"{value:.3f}" for value in exact))
for library, body in (
    ("involute_gears.scad", "$fn = 80; gear(20, diametral_pitch=0.5, pressure_angle=20, clearance=0, flat=true);"),
    ("gears.scad", "gear(20, diametral_pitch=0.5, pressure_angle=20);"),
):
    outline = max(loops(library, body), key=len)
    print(f"{library + ':':21}", *(f"{thickness(outline, r):.3f}" for r in radii))

for body in ("ball_groove(10, 10, 20, 1);", "ball_groove2(10, 10, 20, 1, slices=40);"):
    size = sizes("screw.scad", "$fn = 24; " + body)
    print(f"{body} centre line at radius {size[0] / 2 - 1:.1f}")

squares = loops("multiply.scad", "spin(4) translate([10, 0]) square(2, center=true);")
centres = [(sum(p[0] for p in square) / 4, sum(p[1] for p in square) / 4) for square in squares]
print("spin(4): copies at degrees", *sorted(round(math.degrees(math.atan2(-y, x))) % 360 for x, y in centres))

for body in ("oval_tube(10, rx=8, ry=5, wall=1);", "oval_prism(10, rx=8, ry=5);"):
    size = sizes("regular_shapes.scad", "$fn = 24; " + body)
    print(f"{body} size {size[0]:.1f} x {size[1]:.1f}")
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
tooth at the radii 18.9 20 21 21.8
involute:             3.517 3.142 2.410 1.615
involute_gears.scad:  3.517 3.141 2.408 1.613
gears.scad:           3.187 3.142 3.205 3.255
ball_groove(10, 10, 20, 1); centre line at radius 20.0
ball_groove2(10, 10, 20, 1, slices=40); centre line at radius 10.0
spin(4): copies at degrees 0 120
oval_tube(10, rx=8, ry=5, wall=1); size 16.0 x 10.0
oval_prism(10, rx=8, ry=5); size 10.0 x 16.0
EXPECTED
