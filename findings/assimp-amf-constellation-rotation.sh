#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, assimp-utils 5.2.5~ds0-1+b1 (assimp export to STL).
# Input:    AMF: a bar of 4 x 1 x 1 and a constellation with two instances: deltax 10, and deltax 20 with rz 90.
# Expected: The element rz is a rotation about z in degrees. The second bar is 1 wide, 4 deep and 1 high.
# Seen:     The element rz overwrites deltaz: the second bar is not turned and is raised by 90. The element rx 90
#           replaces deltax 20 in the same way, and ry replaces deltay. Without rotations, the positions are right.

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
import re
import subprocess

corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 4)]
quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
triangles = [(q[0], q[i], q[i + 1]) for q in quads for i in (1, 2)]
vertices = "".join(f"<vertex><coordinates><x>{x}</x><y>{y}</y><z>{z}</z></coordinates></vertex>" for x, y, z in corners)
faces = "".join(f"<triangle><v1>{a}</v1><v2>{b}</v2><v3>{c}</v3></triangle>" for a, b, c in triangles)


def boxes(placement):
    instance = '<instance objectid="1">%s</instance>'
    with open("in.amf", "w") as amf:
        amf.write('<?xml version="1.0"?><amf unit="millimeter"><object id="1"><mesh>')
        amf.write(f"<vertices>{vertices}</vertices><volume>{faces}</volume></mesh></object>")
        amf.write('<constellation id="2">' + instance % "<deltax>10</deltax>" + instance % placement)
        amf.write("</constellation></amf>")
    subprocess.run(["root/usr/bin/assimp", "export", "in.amf", "out.stl"], check=True, stdout=subprocess.DEVNULL)
    points = [tuple(map(float, p)) for p in re.findall(r"vertex (\S+) (\S+) (\S+)", open("out.stl").read())]
    result = []
    for part in (points[:36], points[36:]):
        result.append(" ".join(f"{min(axis):.0f}..{max(axis):.0f}" for axis in zip(*part)))
    return ", ".join(result)


for placement in (
    "<deltax>20</deltax><deltaz>5</deltaz>",
    "<deltax>20</deltax><rz>90</rz>",
    "<deltax>20</deltax><rx>90</rx>",
    "<deltax>20</deltax><ry>90</ry>",
):
    print(placement, boxes(placement), sep=": ")
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
<deltax>20</deltax><deltaz>5</deltaz>: 10..14 0..1 0..1, 20..24 0..1 5..6
<deltax>20</deltax><rz>90</rz>: 10..14 0..1 0..1, 20..24 0..1 90..91
<deltax>20</deltax><rx>90</rx>: 10..14 0..1 0..1, 90..94 0..1 0..1
<deltax>20</deltax><ry>90</ry>: 10..14 0..1 0..1, 20..24 90..91 0..1
EXPECTED
