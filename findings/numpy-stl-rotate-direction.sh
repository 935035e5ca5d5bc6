#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-stl 2.9.0-2+b3 (numpy-stl).
# Input:    a box of 4 x 2 x 1 at the origin; a rotation by +90 degrees about z in three ways: rotate(axis, angle),
#           rotate_using_matrix(rotation_matrix(axis, angle)) and transform(matrix with the same rotation).
# Expected: All three turn counter-clockwise: x -2..0, y 0..4. rotation_matrix gives the counter-clockwise matrix.
#           The area of the box is 28.
# Seen:     transform turns counter-clockwise. rotate and rotate_using_matrix apply the transposed matrix:
#           x 0..2, y -4..0. The property areas and update_areas() give 0 until update_normals() is called, because
#           the area is calculated from the stored normals.

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
fetch python3-stl=2.9.0-2+b3
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import math

import numpy
from stl.mesh import Mesh

corners = [(x, y, z) for z in (0, 1) for y in (0, 2) for x in (0, 4)]
quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
triangles = [(q[0], q[i], q[i + 1]) for q in quads for i in (1, 2)]
angle = math.radians(90)


def box():
    mesh = Mesh(numpy.zeros(len(triangles), dtype=Mesh.dtype))
    mesh.vectors[:] = numpy.array([[corners[i] for i in face] for face in triangles])
    return mesh


def show(name, mesh):
    points = mesh.vectors.reshape(-1, 3).round(3) + 0
    low, high = points.min(axis=0), points.max(axis=0)
    print(f"{name}: x {low[0]:.0f}..{high[0]:.0f} y {low[1]:.0f}..{high[1]:.0f}")


matrix = Mesh.rotation_matrix([0, 0, 1], angle)
print("rotation_matrix:", matrix.round(3).tolist())
mesh = box()
mesh.rotate([0, 0, 1], angle)
show("rotate", mesh)
mesh = box()
mesh.rotate_using_matrix(matrix)
show("rotate_using_matrix", mesh)
mesh = box()
full = numpy.eye(4)
full[:3, :3] = matrix
mesh.transform(full)
show("transform", mesh)
mesh = box()
areas = [mesh.areas.sum()]
mesh.update_areas()
areas.append(mesh.areas.sum())
mesh.update_normals()
mesh.update_areas()
areas.append(mesh.areas.sum())
print("areas: %.0f, after update_areas %.0f, after update_normals %.0f" % tuple(areas))
PY
/usr/bin/python3 -W ignore check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
rotation_matrix: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
rotate: x 0..2 y -4..0
rotate_using_matrix: x 0..2 y -4..0
transform: x -2..0 y 0..4
areas: 0, after update_areas 0, after update_normals 28
EXPECTED
