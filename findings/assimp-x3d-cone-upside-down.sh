#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, assimp-utils 5.2.5~ds0-1+b1 (assimp export to STL).
# Input:    X3D shapes: Cone (radius 2, height 3), Cylinder (the same), Extrusion of the standard cross section
#           (a square of 2 x 2) along 3 units, and a cube as IndexedFaceSet with ccw "true" and with ccw "false".
# Expected: The specification has the apex of the cone at +Y. The signed volumes are about 12.6, 37.7, 12, 1 and 1
#           (the second cube has reversed indices), because all faces point outwards.
# Seen:     The cone stands upside down: radius 2 at y = 1.5. The cylinder has the volume 25.8: its top points inwards.
#           The extrusion has -4: its sides point inwards, its ends do not. ccw "false" is ignored: the volume is -1.
#           The cone and the cylinder have 31 segments of 12 degrees, so the last segment overlaps the first.

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
fetch assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 libminizip1=1.1-8+deb12u1
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu

cat >check.py <<'PY'
import math
import re
import subprocess

points = " ".join(f"{x} {y} {z}" for z in (0, 1) for y in (0, 1) for x in (0, 1))
quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def cube(attribute, faces):
    indices = " ".join(" ".join(map(str, face)) + " -1" for face in faces)
    return f'<IndexedFaceSet {attribute} coordIndex="{indices}"><Coordinate point="{points}"/></IndexedFaceSet>'


def show(name, shape):
    with open("in.x3d", "w") as x3d:
        x3d.write('<?xml version="1.0"?><X3D profile="Interchange" version="3.0"><Scene><Shape>')
        x3d.write(shape + "</Shape></Scene></X3D>")
    subprocess.run(["root/usr/bin/assimp", "export", "in.x3d", "out.stl"], check=True, stdout=subprocess.DEVNULL)
    found = [tuple(map(float, p)) for p in re.findall(r"vertex (\S+) (\S+) (\S+)", open("out.stl").read())]
    volume = 0.0
    for a, b, c in zip(found[0::3], found[1::3], found[2::3]):
        volume += a[0] * (b[1] * c[2] - b[2] * c[1]) / 6
        volume += a[1] * (b[2] * c[0] - b[0] * c[2]) / 6
        volume += a[2] * (b[0] * c[1] - b[1] * c[0]) / 6
    top = max(p[1] for p in found)
    radius = max(math.hypot(p[0], p[2]) for p in found if p[1] == top)
    print(f"{name}: volume {volume:.1f}, largest radius {radius:.1f} at y = {top:.1f}")


show("Cone", '<Cone bottomRadius="2" height="3"/>')
show("Cylinder", '<Cylinder radius="2" height="3"/>')
show("Extrusion", '<Extrusion crossSection="1 1 1 -1 -1 -1 -1 1 1 1" spine="0 0 0 0 3 0"/>')
show("IndexedFaceSet ccw true", cube('ccw="true"', quads))
show("IndexedFaceSet ccw false", cube('ccw="false"', [face[::-1] for face in quads]))
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
Cone: volume 12.9, largest radius 2.0 at y = 1.5
Cylinder: volume 25.8, largest radius 2.0 at y = 1.5
Extrusion: volume -4.0, largest radius 1.4 at y = 3.0
IndexedFaceSet ccw true: volume 1.0, largest radius 1.4 at y = 1.0
IndexedFaceSet ccw false: volume -1.0, largest radius 1.4 at y = 1.0
EXPECTED
