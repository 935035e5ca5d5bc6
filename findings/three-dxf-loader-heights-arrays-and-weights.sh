#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, three-dxf-loader 5.2.0, three 0.187.0.
# Input:    DXF files with one entity each: LINE and a 3D POLYLINE with different heights, LWPOLYLINE with the elevation 7, an
#           ARC with the extrusion 0,0,-1, an array of 3 x 2 inserts, a block with the base point 1,0, and a rational SPLINE
#           that is a quarter circle of radius 5. Source: DXF reference (LINE, VERTEX, group 38, INSERT 70/71, BLOCK 10, SPLINE 41).
# Expected: Heights 1, 7, 5, 9 remain. The mirrored arc has its centre at -10,0. The array has six lines. The block at 5,5 with the
#           base point 1,0 starts at 4,5. The middle of the spline is 5 from the centre.
# Seen:     LINE, 3D POLYLINE and LWPOLYLINE are flat, at Z 0; ARC and 3DFACE keep their heights, so they are apart from the lines.
#           The extrusion is ignored, one of six inserts appears, and the block starts at 5,5. The weights of the spline are ignored:
#           its middle is 5.30 from the centre. No error or warning appears.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --legacy-peer-deps --prefix "$work" \
  three-dxf-loader@5.2.0 three@0.187.0 >/dev/null

cat >check.mjs <<'JS'
import { Vector3 } from 'three';
import { DXFLoader } from 'three-dxf-loader';
const tags = (...items) => items.join('\n') + '\n';
const section = (name, content) => tags(0, 'SECTION', 2, name) + content + tags(0, 'ENDSEC');
const layer = tags(0, 'TABLE', 2, 'LAYER', 70, 1, 0, 'LAYER', 2, '0', 70, 0, 62, 7, 6, 'CONTINUOUS', 0, 'ENDTAB');
const header = section('HEADER', tags(9, '$ACADVER', 1, 'AC1015')) + section('TABLES', layer);

// Points of all objects of a file.
function objects(entity, block = '') {
  const text = header + section('BLOCKS', block) + section('ENTITIES', entity) + tags(0, 'EOF');
  const root = new DXFLoader().parse(text).entity;
  root.updateMatrixWorld(true);
  const result = [];
  root.traverse((object) => {
    const position = object.geometry?.attributes.position;
    if (!position) return;
    const points = Array.from({ length: position.count }, (_, i) => new Vector3().fromBufferAttribute(position, i));
    result.push(points.map((point) => point.applyMatrix4(object.matrixWorld)));
  });
  return result;
}
const text = (point) => point.toArray().map((x) => Math.round(x * 100) / 100 + 0).join(',');
const show = (name, lists) => console.log(`${name}: ${lists.map((points) => points.map(text).join(' ')).join(' | ')}`);
const ends = (lists) => lists.map((points) => [points[0], points[points.length - 1]]);
const vertex = (x, y, z) => tags(0, 'VERTEX', 8, 0, 10, x, 20, y, 30, z, 70, 32);
const arc = (...more) => tags(0, 'ARC', 8, 0, 10, 10, 20, 0, 30, 4, 40, 5, 50, 0, 51, 90, ...more);

show('LINE', objects(tags(0, 'LINE', 8, 0, 10, 0, 20, 0, 30, 1, 11, 10, 21, 5, 31, 7)));
show('POLYLINE', objects(tags(0, 'POLYLINE', 8, 0, 66, 1, 70, 8, 10, 0, 20, 0, 30, 0) + vertex(0, 0, 0) + vertex(10, 0, 5) +
  vertex(10, 10, 9) + tags(0, 'SEQEND')));
show('LWPOLYLINE', objects(tags(0, 'LWPOLYLINE', 8, 0, 90, 2, 70, 0, 38, 7, 10, 0, 20, 0, 10, 10, 20, 0)));
show('3DFACE', objects(tags(0, '3DFACE', 8, 0, 10, 0, 20, 0, 30, 0, 11, 10, 21, 0, 31, 1, 12, 10, 22, 10, 32, 2, 13, 0, 23, 10, 33, 3)));
show('ARC', ends(objects(arc())));
show('ARC with extrusion', ends(objects(arc(210, 0, 220, 0, 230, -1))));

const block = (x) => tags(0, 'BLOCK', 8, 0, 2, 'B', 70, 0, 10, x, 20, 0, 30, 0, 0, 'LINE', 8, 0, 10, 0, 20, 0, 30, 0,
  11, 1, 21, 0, 31, 0, 0, 'ENDBLK', 8, 0);
const insert = (...more) => tags(0, 'INSERT', 8, 0, 2, 'B', 10, 5, 20, 5, 30, 0, ...more);
show('INSERT, 90 degrees', objects(insert(50, 90), block(0)));
show('INSERT, base point 1,0', objects(insert(), block(1)));
show('INSERT, 3 x 2', objects(insert(70, 3, 71, 2, 44, 5, 45, 7), block(0)));

const knots = [0, 0, 0, 1, 1, 1].flatMap((knot) => [40, knot]);
const weights = [1, Math.SQRT1_2, 1].flatMap((weight) => [41, weight]);
const spline = objects(tags(0, 'SPLINE', 8, 0, 70, 12, 71, 2, 72, 6, 73, 3, ...knots, ...weights,
  10, 5, 20, 0, 30, 0, 10, 5, 20, 5, 30, 0, 10, 0, 20, 5, 30, 0))[0];
console.log(`SPLINE: middle ${text(spline[spline.length >> 1])}, ${spline[spline.length >> 1].length().toFixed(2)} from the centre`);
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
LINE: 0,0,0 10,5,0
POLYLINE: 0,0,0 10,0,0 10,10,0
LWPOLYLINE: 0,0,0 10,0,0
3DFACE: 0,0,0 10,0,1 10,10,2 0,0,0 10,10,2 0,10,3
ARC: 15,0,4 10,5,4
ARC with extrusion: 15,0,4 10,5,4
INSERT, 90 degrees: 5,5,0 5,6,0
INSERT, base point 1,0: 5,5,0 6,5,0
INSERT, 3 x 2: 5,5,0 6,5,0
SPLINE: middle 3.75,3.75,0, 5.30 from the centre
EXPECTED
