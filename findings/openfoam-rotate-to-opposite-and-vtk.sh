#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, openfoam 1912.200626-1+b1 (its tools for triangle surfaces; about 70 MB are downloaded).
# Input:    STL of a box of 1 x 2 x 3; a legacy VTK file (POLYDATA) with the box as 6 quadrilaterals, with one triangle strip of
#           4 triangles. Source: help of surfaceTransformPoints ("-rotate: Rotate from <vectorA> to <vectorB>"), of
#           surfaceMeshConvert ("Convert between surface formats"); VTK file formats: each second triangle of a strip has the
#           reverse order of points.
# Expected: A rotation from 0,0,1 to 0,0,-1 keeps the volume 6. surfaceMeshConvert writes the 12 triangles or 6 faces of the
#           box. The 4 triangles of the strip, all in one plane, have the vector area 0,0,200.
# Seen:     -rotate mirrors the part if the vectors are opposite: the volume is -6, so the part is inside out, and an L becomes
#           its mirror image. 179 degrees give 6. surfaceMeshConvert reports 6 faces of VTK and writes STL and OBJ without any
#           face, with the exit status 0; VTK to VTK keeps them, and OBJ gives 12 triangles. The file of surfaceConvert itself
#           gives none either. surfaceConvert reads the faces, but each second triangle of the strip points downwards.

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
fetch openfoam=1912.200626-1+b1
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH WM_PROJECT_DIR=$work/root/usr/share/openfoam FOAM_ETC=$work/root/usr/share/openfoam/etc HOME=$work

cat >make.py <<'PY'
corners = [(x, y, z) for x in (0, 1) for y in (0, 2) for z in (0, 3)]
faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def vtk(points, kind, cells):
    numbers = " ".join("%g" % v for p in points for v in p)
    size = sum(1 + len(c) for c in cells)
    return ("# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS %d float\n%s\n%s %d %d\n" % (
        len(points), numbers, kind, len(cells), size)
            + "".join("%d %s\n" % (len(c), " ".join(map(str, c))) for c in cells))


with open("box.stl", "w") as out:
    out.write("solid box\n")
    for a, b, c, d in faces:
        for triangle in ((a, b, c), (a, c, d)):
            out.write("facet normal 0 0 0\nouter loop\n")
            out.write("".join("vertex %g %g %g\n" % corners[i] for i in triangle))
            out.write("endloop\nendfacet\n")
    out.write("endsolid box\n")
open("box.vtk", "w").write(vtk(corners, "POLYGONS", faces))
open("strip.vtk", "w").write(vtk([(x, y, 0) for y in (0, 10, 20) for x in (0, 10)], "TRIANGLE_STRIPS", [range(6)]))
PY
python3 make.py

cat >measure.py <<'PY'
import re
import sys

text = open(sys.argv[1]).read()
v = [tuple(map(float, m)) for m in re.findall(r"vertex\s+(\S+)\s+(\S+)\s+(\S+)", text)]
volume, area = 0, [0, 0, 0]
for a, b, c in zip(v[::3], v[1::3], v[2::3]):
    u, w = [[p[i] - a[i] for i in range(3)] for p in (b, c)]
    normal = [u[i - 2] * w[i - 1] - u[i - 1] * w[i - 2] for i in range(3)]
    area = [s + n / 2 for s, n in zip(area, normal)]
    volume += sum(n * p for n, p in zip(normal, a)) / 6
print("%d triangles, volume %.2f, vector area %s" % (len(v) // 3, volume, ",".join("%.2f" % (s + 0.0) for s in area)))
PY

run() {
  tool=$1
  shift
  status=0
  "root/usr/bin/$tool" "$@" >log 2>&1 || status=$?
}

for vectors in '((0 0 1) (0 0 -1))' '((1 0 0) (-1 0 0))' '((0 0 1) (0.01745 0 -0.99985))' '((0 0 1) (1 0 0))'; do
  run surfaceTransformPoints -rotate "$vectors" box.stl turned.stl
  echo "-rotate $vectors: $(python3 measure.py turned.stl)"
done | tee seen
run surfaceConvert box.stl own.vtk
run surfaceConvert box.stl box.obj
for input in box.vtk own.vtk strip.vtk box.obj; do
  run surfaceConvert "$input" read.stl
  echo "surfaceConvert $input: $(python3 measure.py read.stl)"
  for output in stl obj vtk; do
    run surfaceMeshConvert "$input" "written.$output"
    faces=$(grep -c -e '^ *facet' -e '^f ' "written.$output" || true)
    [ "$output" = vtk ] && faces=$(sed -n 's/^POLYGONS \([0-9]*\) .*/\1/p' written.vtk)
    echo "  surfaceMeshConvert to $output: exit status $status, $(sed -n 's/.* faces:\([0-9]*\) .*/reads \1, /p' log)writes ${faces:-0} faces"
  done
done | tee -a seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
-rotate ((0 0 1) (0 0 -1)): 12 triangles, volume -6.00, vector area 0.00,0.00,0.00
-rotate ((1 0 0) (-1 0 0)): 12 triangles, volume -6.00, vector area 0.00,0.00,0.00
-rotate ((0 0 1) (0.01745 0 -0.99985)): 12 triangles, volume 6.00, vector area 0.00,0.00,0.00
-rotate ((0 0 1) (1 0 0)): 12 triangles, volume 6.00, vector area 0.00,0.00,0.00
surfaceConvert box.vtk: 12 triangles, volume 6.00, vector area 0.00,0.00,0.00
  surfaceMeshConvert to stl: exit status 0, reads 6, writes 0 faces
  surfaceMeshConvert to obj: exit status 0, reads 6, writes 0 faces
  surfaceMeshConvert to vtk: exit status 0, reads 6, writes 6 faces
surfaceConvert own.vtk: 12 triangles, volume 6.00, vector area 0.00,0.00,0.00
  surfaceMeshConvert to stl: exit status 0, reads 12, writes 0 faces
  surfaceMeshConvert to obj: exit status 0, reads 12, writes 0 faces
  surfaceMeshConvert to vtk: exit status 0, reads 12, writes 12 faces
surfaceConvert strip.vtk: 4 triangles, volume 0.00, vector area 0.00,0.00,100.00
  surfaceMeshConvert to stl: exit status 0, reads 4, writes 0 faces
  surfaceMeshConvert to obj: exit status 0, reads 4, writes 0 faces
  surfaceMeshConvert to vtk: exit status 0, reads 4, writes 4 faces
surfaceConvert box.obj: 12 triangles, volume 6.00, vector area 0.00,0.00,0.00
  surfaceMeshConvert to stl: exit status 0, writes 12 faces
  surfaceMeshConvert to obj: exit status 0, writes 12 faces
  surfaceMeshConvert to vtk: exit status 0, writes 12 faces
EXPECTED
