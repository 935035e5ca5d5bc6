#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, openscenegraph 3.6.5+dfsg1-8+b2 (osgconv).
# Input:    STL of a block of 10 x 20 x 30, converted to DXF, OBJ, AC and 3DS and back to STL; DXF: one counter-clockwise 3DFACE; INSERT of
#           a line with the scale 2,1,1 and the angle 90; INSERT of 3 columns and 2 rows; POLYLINE with a half circle (bulge 1);
#           SOLID. Source: DXF reference (the scale is in the axes of the block, before the angle).
# Expected: osgconv reads its own files: the volume is 6000, the box is the same. The face is counter-clockwise. The inserted line is
#           20 long. There are 6 copies. The half circle is 15.71 long, the SOLID has the area 100.
# Seen:     After DXF, the block is inside out (volume -6000), because the reader reverses each 3DFACE and polyface mesh. After OBJ,
#           the block lies on its side: the reader exchanges Y and Z, the writer does not. After AC, it is empty: the reader
#           expects the line "mat", which the writer omits; the exit status is 0. The inserted line is 10 long, because the
#           scale is applied after the angle. There is one copy of the array. The half circle is a line of length 10. SOLID is missing.

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
fetch openscenegraph=3.6.5+dfsg1-8+b2
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu
export OSG_LIBRARY_PATH=$LD_LIBRARY_PATH/osgPlugins-3.6.5
PATH=$work/root/usr/bin:$PATH

cat >make.py <<'PY'
def pairs(*items):
    return "".join(f"{code}\n{value}\n" for code, value in items)


def points(*corners):
    return [(10 * (axis + 1) + i, value) for i, corner in enumerate(corners) for axis, value in enumerate(corner)]


def write(name, *entities):
    line = pairs((0, "LINE"), (8, 0), *points((0, 0, 0), (10, 0, 0)))
    block = pairs((0, "BLOCK"), (8, 0), (2, "B"), (70, 0), *points((0, 0, 0))) + line + pairs((0, "ENDBLK"))
    blocks = pairs((0, "SECTION"), (2, "BLOCKS")) + block + pairs((0, "ENDSEC"))
    end = pairs((0, "ENDSEC"), (0, "EOF"))
    open(name, "w").write(blocks + pairs((0, "SECTION"), (2, "ENTITIES"), *entities) + end)


corners = [(x, y, z) for z in (0, 30) for y in (0, 20) for x in (0, 10)]
with open("block.stl", "w") as file:
    file.write("solid block\n")
    for a, b, c, d in [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]:
        for triangle in ((a, b, c), (a, c, d)):
            lines = "".join("vertex %d %d %d\n" % corners[i] for i in triangle)
            file.write(f"facet normal 0 0 0\nouter loop\n{lines}endloop\nendfacet\n")
    file.write("endsolid block\n")
flat = [(0, 0, 0), (10, 0, 0), (10, 10, 0), (0, 10, 0)]
insert = [(0, "INSERT"), (8, 0), (2, "B"), *points((0, 0, 0))]
write("face.dxf", (0, "3DFACE"), (8, 0), *points(*flat))
write("solid.dxf", (0, "SOLID"), (8, 0), *points(flat[0], flat[1], flat[3], flat[2]))
write("scaled.dxf", *insert, (41, 2), (42, 1), (43, 1), (50, 90))
write("array.dxf", *insert, (70, 3), (71, 2), (44, 20), (45, 5))
arc = [(0, "VERTEX"), (8, 0), *points(flat[0]), (42, 1), (0, "VERTEX"), (8, 0), *points(flat[1]), (0, "SEQEND")]
write("arc.dxf", (0, "POLYLINE"), (8, 0), (66, 1), (70, 0), *points(flat[0]), *arc)
PY
cat >measure.py <<'PY'
import math
import sys

lines = [line.split() for line in open(sys.argv[1])]
if sys.argv[1].endswith("stl"):
    points = [tuple(map(float, words[1:])) for words in lines if words[0] == "vertex"]
    volume = normal = 0
    for a, b, c in zip(points[::3], points[1::3], points[2::3]):
        volume += sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3)) / 6
        normal += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
    axes = list(zip(*points))
    box = " x ".join(f"{min(axis) + 0:g}..{max(axis) + 0:g}" for axis in axes) or "no box"
    print(f"{len(points) // 3} triangles, area in XY {normal:g}, volume {volume:g}, {box}")
else:
    points = [tuple(map(float, words[1:])) for words in lines if words and words[0] == "v"]
    ends = [[int(word.split("/")[0]) - 1 for word in words[1:]] for words in lines if words and words[0] == "l"]
    print(f"{len(ends)} lines, length {sum(math.dist(points[i], points[j]) for i, j in ends):g}")
PY
/usr/bin/python3 make.py
{
  for type in stl 3ds dxf obj ac; do
    osgconv block.stl "own.$type" >log 2>&1
    osgconv "own.$type" "from_$type.stl" >log 2>&1
    echo "block, $type: $(/usr/bin/python3 measure.py "from_$type.stl")"
  done
  for name in face solid; do
    osgconv "$name.dxf" "$name.stl" >log 2>&1
    echo "$name: $(/usr/bin/python3 measure.py "$name.stl")"
  done
  for name in scaled array arc; do
    osgconv "$name.dxf" "$name.obj" >log 2>&1
    echo "$name: $(/usr/bin/python3 measure.py "$name.obj")"
  done
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
block, stl: 12 triangles, area in XY 0, volume 6000, 0..10 x 0..20 x 0..30
block, 3ds: 12 triangles, area in XY 0, volume 6000, 0..10 x 0..20 x 0..30
block, dxf: 24 triangles, area in XY 0, volume -6000, 0..10 x 0..20 x 0..30
block, obj: 12 triangles, area in XY 0, volume 6000, 0..10 x -30..0 x 0..20
block, ac: 0 triangles, area in XY 0, volume 0, no box
face: 2 triangles, area in XY -100, volume 0, 0..10 x 0..10 x 0..0
solid: 0 triangles, area in XY 0, volume 0, no box
scaled: 1 lines, length 10
array: 1 lines, length 10
arc: 1 lines, length 10
EXPECTED
