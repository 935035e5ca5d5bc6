#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1 (vtkBooleanOperationPolyDataFilter).
# Input:    two closed boxes of 12 triangles with shared points and outward orientation. No face of one box is coplanar
#           with a face of the other, and no edge meets an edge: (0,0,0)-(2,2,2) with a box over one corner and with a
#           square bar through its middle. Also two spheres of 96 triangles.
# Expected: closed meshes; the volumes follow from the boxes. The intersection lies in both boxes.
# Seen:     Corner: the intersection has 1.18 instead of 0.72 and reaches from Z 0 to Z 3; the difference has 8.44, more
#           than the box that it is cut from (8). All results for boxes are open. The filter returns no error and prints
#           nothing. Spheres give closed results.

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

from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkBooleanOperationPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource


def triangles(source):
    triangulated = vtkTriangleFilter()
    triangulated.SetInputConnection(source.GetOutputPort())
    merged = vtkCleanPolyData()
    merged.SetInputConnection(triangulated.GetOutputPort())
    merged.Update()
    return merged.GetOutput()


def box(*bounds):
    source = vtkCubeSource()
    source.SetBounds(*bounds)
    return triangles(source)


def sphere(x, y, z):
    source = vtkSphereSource()
    source.SetCenter(x, y, z)
    return triangles(source)


def measure(mesh):
    volume, edges = 0.0, Counter()
    for i in range(mesh.GetNumberOfCells()):
        points = mesh.GetCell(i).GetPoints()
        a, b, c = (tuple(round(x, 6) for x in points.GetPoint(k)) for k in range(3))
        volume += a[0] * (b[1] * c[2] - b[2] * c[1]) / 6
        volume += a[1] * (b[2] * c[0] - b[0] * c[2]) / 6
        volume += a[2] * (b[0] * c[1] - b[1] * c[0]) / 6
        edges.update([(a, b), (b, c), (c, a)])
    unmatched = sum(edges[a, b] != edges.get((b, a), 0) for a, b in edges)
    low_z, high_z = mesh.GetBounds()[4:]
    return f"volume {volume:.2f}, {'closed' if unmatched == 0 else 'open'}, Z {low_z:.3g} to {high_z:.3g}"


def show(name, first, second, expected):
    print(f"{name}: {measure(first)}; {measure(second)}")
    for operation, label in enumerate(("union", "intersection", "difference")):
        boolean = vtkBooleanOperationPolyDataFilter()
        boolean.SetInputData(0, first)
        boolean.SetInputData(1, second)
        boolean.SetOperation(operation)
        boolean.Update()
        print(f"  {label}: {measure(boolean.GetOutput())}; expected {expected[operation]}; error {boolean.GetErrorCode()}")


base = box(0, 2, 0, 2, 0, 2)
show("corner", base, box(1, 3, 1.1, 3, 1.2, 3), ("14.12", "0.72", "7.28"))
show("bar", base, box(0.5, 1.3, 0.6, 1.4, -1, 3), ("9.28", "1.28", "6.72"))
show("spheres", sphere(0, 0, 0), sphere(0.31, 0.17, 0.23), ("closed", "closed", "closed"))
PY
/usr/bin/python3 check.py 2>&1 | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
corner: volume 8.00, closed, Z 0 to 2; volume 6.84, closed, Z 1.2 to 3
  union: volume 14.38, open, Z 0 to 3; expected 14.12; error 0
  intersection: volume 1.18, open, Z 0 to 3; expected 0.72; error 0
  difference: volume 8.44, open, Z 0 to 3; expected 7.28; error 0
bar: volume 8.00, closed, Z 0 to 2; volume 2.56, closed, Z -1 to 3
  union: volume 9.36, open, Z -1 to 3; expected 9.28; error 0
  intersection: volume 1.36, open, Z 0 to 2; expected 1.28; error 0
  difference: volume 6.80, open, Z 0 to 2; expected 6.72; error 0
spheres: volume 0.45, closed, Z -0.5 to 0.5; volume 0.45, closed, Z -0.27 to 0.73
  union: volume 0.73, closed, Z -0.5 to 0.73; expected closed; error 0
  intersection: volume 0.17, closed, Z -0.27 to 0.5; expected closed; error 0
  difference: volume 0.28, closed, Z -0.5 to 0.492; expected closed; error 0
EXPECTED
