#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, view3dscene 4.2.0-1 (tovrmlx3d, the converter of the Castle Game Engine).
# Input:    COLLADA files with one node: two triangles or a polygon with a hole; the unit inch and the up axis Z; the
#           transforms translate, matrix, skew and lookat from the eye 0,0,10 to the origin.
# Expected: X3D has the unit metre and the up axis Y: a scale of 0.0254 and a rotation about X by -90 degrees. skew is a
#           shear, lookat places its object at the eye. The polygon has a face, or a message says that it has none.
# Seen:     Unit and up axis are ignored: an inch becomes a metre, and the part lies on its side. skew is dropped. lookat
#           moves its object to the opposite side, to 0,0,-10. The polygon with a hole gives an empty shape, without a
#           message. Triangles, translate and matrix are right.

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
fetch view3dscene=4.2.0-1
mkdir -p root/usr/lib
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH HOME=$work

# Converts a node with the unit $2, the up axis $3, the mesh $4 and the transform $5. Prints all transforms and faces.
show() {
  cat >in.dae <<DAE
<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset>$2<up_axis>$3</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="18">0 0 0 4 0 0 4 4 0 1 1 0 2 1 0 2 2 0</float_array><technique_common>
<accessor source="#a" count="6" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
$4
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s">
<node>$5<instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
DAE
  root/usr/bin/tovrmlx3d in.dae >out.x3dv 2>messages </dev/null
  local words='(scale|rotation|translation|matrix) [-0-9. ]*[0-9]|coordIndex \[[^]]*[0-9]|IndexedFaceSet'
  echo "$1: $(tr -s ' \t\n' ' ' <out.x3dv | grep -oE "$words" | tr '\n' ';')$(grep -c . messages || true) messages"
}
metre='<unit name="meter" meter="1"/>'
triangles='<triangles count="2"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2 3 4 5</p></triangles>'
hole='<polygons count="1"><input semantic="VERTEX" source="#v" offset="0"/><ph><p>0 1 2</p><h>3 5 4</h></ph></polygons>'
{
  show 'triangles' "$metre" Y_UP "$triangles" ''
  show 'translate' "$metre" Y_UP "$triangles" '<translate>1 2 3</translate>'
  show 'matrix' "$metre" Y_UP "$triangles" '<matrix>0 -1 0 5 1 0 0 6 0 0 1 7 0 0 0 1</matrix>'
  show 'inch' '<unit name="inch" meter="0.0254"/>' Y_UP "$triangles" ''
  show 'up axis Z' "$metre" Z_UP "$triangles" ''
  show 'skew' "$metre" Y_UP "$triangles" '<skew>45 1 0 0 0 1 0</skew>'
  show 'lookat' "$metre" Y_UP "$triangles" '<lookat>0 0 10 0 0 0 0 1 0</lookat>'
  show 'polygon with a hole' "$metre" Y_UP "$hole" ''
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
triangles: IndexedFaceSet;coordIndex [ 0, 1, 2, -1, 3, 4, 5, -1;0 messages
translate: IndexedFaceSet;coordIndex [ 0, 1, 2, -1, 3, 4, 5, -1;translation 1 2 3;0 messages
matrix: IndexedFaceSet;coordIndex [ 0, 1, 2, -1, 3, 4, 5, -1;matrix 0 1 0 0 -1 0 0 0 0 0 1 0 5 6 7 1;0 messages
inch: IndexedFaceSet;coordIndex [ 0, 1, 2, -1, 3, 4, 5, -1;0 messages
up axis Z: IndexedFaceSet;coordIndex [ 0, 1, 2, -1, 3, 4, 5, -1;0 messages
skew: IndexedFaceSet;coordIndex [ 0, 1, 2, -1, 3, 4, 5, -1;0 messages
lookat: IndexedFaceSet;coordIndex [ 0, 1, 2, -1, 3, 4, 5, -1;matrix 1 0 0 0 0 1 0 0 0 0 1 0 0 0 -10 1;0 messages
polygon with a hole: IndexedFaceSet;0 messages
EXPECTED
