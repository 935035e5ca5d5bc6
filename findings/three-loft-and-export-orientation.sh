#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, three 0.187.0 (LoftGeometry; the exporters of STL, OBJ and PLY).
# Input:    a loft of two circles of radius 1 (64 points) with both caps, upwards and downwards; a box of 1 x 2 x 3, plain
#           and mirrored by the scale -1; three instances of a unit box.
# Expected: A loft has one orientation: all its triangles point outwards or all inwards, so the volume is 9.41 or -9.41.
#           A mirrored box is exported with the volume 6. Three instances have the volume 3.
# Seen:     Downwards, the side of the loft points inwards and its caps outwards: the volume is -3.14. All exporters write
#           the mirrored box inside out and only one of the three instances, without a message. The upward loft and the
#           plain box are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  three@0.187.0 >/dev/null

cat >check.mjs <<'JS'
import * as THREE from 'three';
import { OBJExporter } from 'three/addons/exporters/OBJExporter.js';
import { PLYExporter } from 'three/addons/exporters/PLYExporter.js';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';
import { LoftGeometry } from 'three/addons/geometries/LoftGeometry.js';

const volume = (triangles) => triangles.reduce((sum, [a, b, c]) => sum + a.dot(b.clone().cross(c)) / 6, 0).toFixed(2);
const point = (words) => new THREE.Vector3(...words.map(Number));
const triples = (list) => list.flatMap((_, i) => (i % 3 ? [] : [list.slice(i, i + 3)]));

const circle = (z) =>
  Array.from({ length: 64 }, (_, i) => new THREE.Vector3(Math.cos((i * Math.PI) / 32), Math.sin((i * Math.PI) / 32), z));
for (const [name, heights] of [['upwards', [0, 3]], ['downwards', [3, 0]]]) {
  const loft = new LoftGeometry(heights.map(circle), { closed: true, capStart: true, capEnd: true }).toNonIndexed();
  const positions = loft.attributes.position;
  const points = Array.from({ length: positions.count }, (_, i) => new THREE.Vector3().fromBufferAttribute(positions, i));
  const caps = triples(points).filter((t) => t.every((p) => p.z === t[0].z));
  console.log(`loft ${name}: volume ${volume(triples(points))}, caps ${volume(caps)}`);
}

const fromStl = (text) => triples([...text.matchAll(/vertex (\S+) (\S+) (\S+)/g)].map((m) => point(m.slice(1))));
const fromObj = (text) => {
  const points = [...text.matchAll(/^v (\S+) (\S+) (\S+)/gm)].map((m) => point(m.slice(1)));
  return [...text.matchAll(/^f (\d+)\S* (\d+)\S* (\d+)/gm)].map((m) => m.slice(1).map((i) => points[i - 1]));
};
const fromPly = (text) => {
  const lines = text.split('end_header\n')[1].trim().split('\n').map((line) => line.split(' '));
  const count = Number(text.match(/element vertex (\d+)/)[1]);
  const points = lines.slice(0, count).map((words) => point(words.slice(0, 3)));
  return lines.slice(count).map((words) => words.slice(1, 4).map((i) => points[i]));
};
const show = (name, object) => {
  object.updateMatrixWorld(true);
  const stl = new STLExporter().parse(object);
  const obj = new OBJExporter().parse(object);
  const ply = new PLYExporter().parse(object, null, {});
  console.log(`${name}: STL ${volume(fromStl(stl))}, OBJ ${volume(fromObj(obj))}, PLY ${volume(fromPly(ply))}`);
};
const box = () => new THREE.Mesh(new THREE.BoxGeometry(1, 2, 3));
show('box', box());
const mirrored = box();
mirrored.scale.x = -1;
show('mirrored box', mirrored);
const instances = new THREE.InstancedMesh(new THREE.BoxGeometry(1, 1, 1), null, 3);
for (let i = 0; i < 3; i++) instances.setMatrixAt(i, new THREE.Matrix4().makeTranslation(5 * i, 0, 0));
show('three instances', instances);
JS
node check.mjs 2>&1 | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
loft upwards: volume 9.41, caps 3.14
loft downwards: volume -3.14, caps 3.14
box: STL 6.00, OBJ 6.00, PLY 6.00
mirrored box: STL -6.00, OBJ -6.00, PLY -6.00
three instances: STL 1.00, OBJ 1.00, PLY 1.00
EXPECTED
