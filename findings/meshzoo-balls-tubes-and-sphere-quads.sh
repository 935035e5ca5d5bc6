#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-meshzoo 0.9.4-1 (meshes of simple shapes for finite elements).
# Input:    disks, balls and spheres without a radius, geo_sphere with 20 points on 10 circles, tubes of the radius 1 with 30 points
#           and lengths from 0.1 to 2. Source: README of the package (disk, disk_quad, "Ball (solid)", spheres: "All cells are
#           oriented such that its normals point outwards"), the parameters length and radius of tube.
# Expected: Disk and ball have the radius 1 for each shape of the cells, as disk and icosa_sphere have. All cells of a sphere
#           point outwards. A tube of the length 0.1 has cells, and its points are 0.1 apart.
# Seen:     A disk of quadrilaterals has the radius 1/sqrt(2) and the area 1.57 instead of 3.14; a ball has the radius
#           1/sqrt(3) and the volume 0.80 instead of 4.19. geo_sphere: the triangles at the poles point outwards, all quadrilaterals
#           inwards. A tube of the length 0.1 has no points; with 0.3, all points are in one plane, without a cell.

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
fetch python3-meshzoo=0.9.4-1 python3-numpy=1:1.24.2-1+deb12u1
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries:$libraries/lapack:$libraries/blas PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import math
import meshzoo
import numpy


def volume(points, faces):
    triangles = numpy.vstack([faces[:, [0, i, i + 1]] for i in range(1, faces.shape[1] - 1)])
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6


def area(points, cells):
    x, y = points[cells, 0], points[cells, 1]
    return ((x * numpy.roll(y, -1, 1) - numpy.roll(x, -1, 1) * y).sum(1) / 2).sum()


def tetrahedra(points, cells):
    a, b, c, d = (points[cells[:, i]] for i in range(4))
    return numpy.einsum("ij,ij->i", b - a, numpy.cross(c - a, d - a)).sum() / 6


def radius(points):
    return numpy.linalg.norm(points, axis=1).max()


print(f"expected: disk {math.pi:.2f}, ball {4 * math.pi / 3:.2f}")
points, cells = meshzoo.disk(6, 40)
print(f"disk of triangles: radius {radius(points):.4f}, area {area(points, cells):.2f}")
points, cells = meshzoo.disk_quad(40)
print(f"disk of quadrilaterals: radius {radius(points):.4f}, area {area(points, cells):.2f}")
points, cells = meshzoo.ball_tetra(20)
print(f"ball of tetrahedra: radius {radius(points):.4f}, volume {tetrahedra(points, cells):.2f}")
points, cells = meshzoo.ball_hexa(20)
print(f"ball of hexahedra: radius {radius(points):.4f}")
points, cells = meshzoo.icosa_sphere(20)
print(f"icosa_sphere: radius {radius(points):.4f}, volume {volume(points, cells):.2f}")
points, triangles, quadrilaterals = meshzoo.geo_sphere(num_points_per_circle=20, num_circles=10, radius=1.0)
print(f"geo_sphere: triangles {volume(points, triangles):.2f}, quadrilaterals {volume(points, quadrilaterals):.2f}")
for length in (0.1, 0.3, 0.5, 2.0):
    points, cells = meshzoo.tube(length=length, radius=1.0, n=30)
    extent = numpy.ptp(points[:, 2]) if len(points) else 0
    print(f"tube of length {length}: {len(points)} points, {len(cells)} triangles, extent in Z {extent:.2f}")
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
expected: disk 3.14, ball 4.19
disk of triangles: radius 1.0000, area 3.14
disk of quadrilaterals: radius 0.7071, area 1.57
ball of tetrahedra: radius 0.5774, volume 0.80
ball of hexahedra: radius 0.5774
icosa_sphere: radius 1.0000, volume 4.18
geo_sphere: triangles 0.24, quadrilaterals -3.75
tube of length 0.1: 0 points, 0 triangles, extent in Z 0.00
tube of length 0.3: 30 points, 0 triangles, extent in Z 0.00
tube of length 0.5: 60 points, 60 triangles, extent in Z 0.50
tube of length 2.0: 300 points, 540 triangles, extent in Z 2.00
EXPECTED
