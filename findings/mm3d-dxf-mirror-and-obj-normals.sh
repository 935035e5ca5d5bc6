#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, mm3d 1.3.13-1 (Maverick Model 3D; option --convert, platform "offscreen" of Qt).
# Input:    OBJ: a closed tetrahedron 0,0,0 10,0,0 0,20,0 0,0,30 with outward triangles; a flat L of the area 300 as one face
#           with six vertices, once with the inner corner 10,10 first, once with the corner 20,0 first.
# Expected: The DXF file contains the tetrahedron, possibly with a different vertical axis, with the same handedness: if
#           0,20,0 becomes 0,0,20, then 0,0,30 becomes 0,-30,0. The volume is 1000. Normals in OBJ have length 1. The
#           triangles of the L have the area 300 in total.
# Seen:     DXF swaps Y and Z without a change of sign: 10,0,0 0,0,20 0,30,0. This is a reflection, and the order of the
#           vertices stays, so the part is mirrored and inside out. OBJ to OBJ writes 12 normals, none of length
#           1. The L has the area 300 if its inner corner is first, and 400 otherwise, with one
#           triangle upside down. No message appears. The vertices and the volume are right in OBJ.

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
fetch mm3d=1.3.13-1
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
QT_PLUGIN_PATH=$(dirname "$(find "$work/root/usr/lib" /usr/lib -path '*qt5/plugins/platforms' -print -quit)")
export LD_LIBRARY_PATH QT_PLUGIN_PATH QT_QPA_PLATFORM=offscreen HOME=$work

cat >part.obj <<'OBJ'
v 0 0 0
v 10 0 0
v 0 20 0
v 0 0 30
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
OBJ
corners=("10,10" "10,20" "0,20" "0,0" "20,0" "20,10")
for first in 0 4; do
  for i in 0 1 2 3 4 5; do
    corner=${corners[(first + i) % 6]}
    echo "v ${corner/,/ } 0"
  done >"l$first.obj"
  echo 'f 1 2 3 4 5 6' >>"l$first.obj"
done
cp part.obj copy.obj
root/usr/bin/mm3d --convert dxf part.obj 2>/dev/null
root/usr/bin/mm3d --convert obj copy.obj l0.obj l4.obj 2>/dev/null

cat >check.py <<'PY'
def volume(triangles):
    return sum(
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        for a, b, c in triangles
    ) / 6


def obj(name):
    points, triangles, normals = [], [], []
    for line in open(name):
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(float(w) for w in words[1:]))
        elif words[:1] == ["vn"]:
            normals.append([float(w) for w in words[1:]])
        elif words[:1] == ["f"]:
            triangles.append([points[int(w.split("/")[0]) - 1] for w in words[1:]])
    return triangles, normals


def dxf(name):
    lines = [line.strip() for line in open(name)]
    groups = list(zip(lines[::2], lines[1::2]))
    triangles = []
    for i, group in enumerate(groups):
        if group == ("0", "3DFACE"):
            values = {}
            for code, value in groups[i + 1:]:
                if code == "0":
                    break
                values[code] = value
            triangles.append([tuple(float(values[f"{10 * axis}"[:1] + k]) for axis in (1, 2, 3)) for k in "012"])
    return triangles


def points(triangles):
    corners = sorted({tuple(round(v, 3) + 0 for v in point) for triangle in triangles for point in triangle}, reverse=True)
    return " ".join(",".join(f"{v:g}" for v in corner) for corner in corners)


triangles, normals = obj("copy.obj")
unit = sum(abs(sum(v * v for v in normal) - 1) < 1e-3 for normal in normals)
print(f"OBJ: {points(triangles)}; volume {volume(triangles):.0f}; normals {len(normals)}, of length 1: {unit}")
triangles = dxf("part.dxf")
print(f"DXF: {points(triangles)}; volume {volume(triangles):.0f}")
for name, label in (("l0.obj", "inner corner first"), ("l4.obj", "20,0 first")):
    areas = [((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2 for a, b, c in obj(name)[0]]
    print(f"L, {label}: {' '.join(f'{abs(v):.0f}' for v in areas)}, total {sum(map(abs, areas)):.0f}, "
          f"upward {sum(v * areas[0] > 0 for v in areas)}")
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
OBJ: 10,0,0 0,20,0 0,0,30 0,0,0; volume 1000; normals 12, of length 1: 0
DXF: 10,0,0 0,30,0 0,0,20 0,0,0; volume -1000
L, inner corner first: 50 100 100 50, total 300, upward 4
L, 20,0 first: 50 50 100 200, total 400, upward 3
EXPECTED
