#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, freecad-python3 0.20.2+dfsg1-4+deb12u1 (installed; module Mesh).
# Input:    a prism over a pentagon (area 2.375, height 1): two pentagons and five quadrilaterals, as OBJ, PLY and OFF;
#           the same prism with triangles alone.
# Expected: All files give a closed mesh with 16 triangles and the volume 4.75.
# Seen:     OFF is right. OBJ drops the pentagons: 10 triangles, open. PLY drops all faces with more than three
#           corners: the mesh is empty, and isSolid() is True. No error is raised.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

version=0.20.2+dfsg1-4+deb12u1
[ "$(dpkg-query -W -f '${Version}' freecad-python3 2>/dev/null)" = "$version" ] ||
  { echo "freecad-python3 $version is not installed" >&2; exit 2; }
export HOME=$work

cat >write.py <<'PY'
outline = [(0, 0), (2, 0), (3, 1), (1.5, 2.5), (0, 1)]
points = [(x, y, z) for z in (0, 1) for x, y in outline]
faces = [(4, 3, 2, 1, 0), (5, 6, 7, 8, 9)] + [(i, (i + 1) % 5, (i + 1) % 5 + 5, i + 5) for i in range(5)]
triangles = [(f[0], f[i], f[i + 1]) for f in faces for i in range(1, len(f) - 1)]


def write(name, faces):
    rows = ["%g %g %g" % p for p in points]
    lists = [" ".join(map(str, (len(f), *f))) for f in faces]
    with open(name + ".obj", "w") as obj:
        obj.writelines("v " + row + "\n" for row in rows)
        obj.writelines("f " + " ".join(str(i + 1) for i in f) + "\n" for f in faces)
    with open(name + ".off", "w") as off:
        off.write(f"OFF\n{len(rows)} {len(faces)} 0\n" + "\n".join(rows + lists) + "\n")
    with open(name + ".ply", "w") as ply:
        ply.write(f"ply\nformat ascii 1.0\nelement vertex {len(rows)}\n")
        ply.write("property float x\nproperty float y\nproperty float z\n")
        ply.write(f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
        ply.write("\n".join(rows + lists) + "\n")


write("polygons", faces)
write("triangles", triangles)
PY
/usr/bin/python3 write.py
cat >read.py <<'PY'
import Mesh

with open("seen", "w") as seen:
    for name in ("triangles", "polygons"):
        for kind in ("off", "obj", "ply"):
            mesh = Mesh.Mesh(f"{name}.{kind}")
            size = f"{mesh.CountFacets} triangles, volume {mesh.Volume:.3f}"
            seen.write(f"{name}.{kind}: {size}, solid {mesh.isSolid()}\n")
PY
freecadcmd read.py </dev/null >log 2>&1 || true
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
triangles.off: 16 triangles, volume 4.750, solid True
triangles.obj: 16 triangles, volume 4.750, solid True
triangles.ply: 16 triangles, volume 4.750, solid True
polygons.off: 16 triangles, volume 4.750, solid True
polygons.obj: 10 triangles, volume 3.167, solid False
polygons.ply: 0 triangles, volume 0.000, solid True
EXPECTED
