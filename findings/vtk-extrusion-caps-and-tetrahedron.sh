#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1 (vtkLinearExtrusionFilter,
#           vtkRotationalExtrusionFilter, vtkPlatonicSolidSource, vtkSTLWriter).
# Input:    a rectangle of 2 x 3 at Z 10, counter-clockwise, extruded by 1 upwards and downwards with caps; a square of
#           1 x 1 at radius 10 to 11, revolved by 90 degrees with caps; the five Platonic solids. All as written to STL.
# Expected: closed meshes with outward facets, as STL requires: no unmatched edges, volumes of 6, 6 and 16.49, positive
#           volumes of all solids.
# Seen:     Both caps point into the same direction, so one of them points inwards: four edges of this cap have no
#           opposite, and the signed volume is 46 or 34 instead of 6. The sides of the downward extrusion point inwards.
#           The start cap of the revolution is reversed, too; its plane contains the origin, so the volume is right.
#           The tetrahedron and the icosahedron are inside out, the other three solids are right. No message appears.

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
fetch python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1 python3-numpy=1:1.24.2-1+deb12u1
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries:$libraries/lapack:$libraries/blas HOME=$work
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
from collections import Counter

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter, vtkRotationalExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter


def polygon(*vertices):
    points, cells = vtkPoints(), vtkCellArray()
    for vertex in vertices:
        points.InsertNextPoint(*vertex)
    cells.InsertNextCell(len(vertices), range(len(vertices)))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    return data


def show(name, source):
    triangulated = vtkTriangleFilter()
    triangulated.SetInputConnection(source.GetOutputPort())
    writer = vtkSTLWriter()
    writer.SetInputConnection(triangulated.GetOutputPort())
    writer.SetFileName("out.stl")
    writer.Write()
    rows = [line.split()[1:] for line in open("out.stl") if line.split()[0] == "vertex"]
    vertices = [tuple(round(float(x), 3) for x in row) for row in rows]
    volume, edges = 0.0, Counter()
    for a, b, c in zip(vertices[::3], vertices[1::3], vertices[2::3]):
        volume += a[0] * (b[1] * c[2] - b[2] * c[1]) / 6
        volume += a[1] * (b[2] * c[0] - b[0] * c[2]) / 6
        volume += a[2] * (b[0] * c[1] - b[1] * c[0]) / 6
        edges.update([(a, b), (b, c), (c, a)])
    unmatched = sum(edges[a, b] != edges.get((b, a), 0) for a, b in edges)
    print(f"{name}: {len(vertices) // 3} facets, signed volume {volume:.2f}, {unmatched} unmatched edges")


for direction in (1, -1):
    extrusion = vtkLinearExtrusionFilter()
    extrusion.SetInputData(polygon((0, 0, 10), (2, 0, 10), (2, 3, 10), (0, 3, 10)))
    extrusion.SetExtrusionTypeToVectorExtrusion()
    extrusion.SetVector(0, 0, direction)
    extrusion.CappingOn()
    show(f"extrusion along Z by {direction}", extrusion)
revolution = vtkRotationalExtrusionFilter()
revolution.SetInputData(polygon((10, 0, 0), (11, 0, 0), (11, 0, 1), (10, 0, 1)))
revolution.SetResolution(36)
revolution.SetAngle(90)
revolution.CappingOn()
show("revolution by 90 degrees", revolution)
for name in ("Tetrahedron", "Cube", "Octahedron", "Icosahedron", "Dodecahedron"):
    solid = vtkPlatonicSolidSource()
    getattr(solid, f"SetSolidTypeTo{name}")()
    show(name, solid)
PY
/usr/bin/python3 check.py 2>&1 | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
extrusion along Z by 1: 12 facets, signed volume 46.00, 4 unmatched edges
extrusion along Z by -1: 12 facets, signed volume 34.00, 4 unmatched edges
revolution by 90 degrees: 292 facets, signed volume 16.49, 4 unmatched edges
Tetrahedron: 4 facets, signed volume -0.51, 0 unmatched edges
Cube: 12 facets, signed volume 1.54, 0 unmatched edges
Octahedron: 8 facets, signed volume 1.33, 0 unmatched edges
Icosahedron: 20 facets, signed volume -2.54, 0 unmatched edges
Dodecahedron: 36 facets, signed volume 2.78, 0 unmatched edges
EXPECTED
