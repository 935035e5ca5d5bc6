#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, three 0.187.0 (VRMLLoader) with jsdom 29.1.1.
# Input:    VRML 2.0: a unit box turned by 90 degrees about the centre 1,0,0; an ElevationGrid of 3 x 2 points with the
#           spacing 2 in x and 4 in z; an Extrusion of the standard square along the x axis; an L-shaped face (area 5)
#           with convex FALSE.
# Expected: Box at x 0.5..1.5, y -1.5..-0.5. Grid x 0..4, z 0..4. Extrusion: volume 12, x 0..3. Face: area 5.
# Seen:     The centre is ignored: the box is at x -0.5..0.5. The grid is x 0..2, z 0..8: the dimensions change
#           places. The extrusion is flat, with the volume 0, because the cross section is not turned into the spine;
#           along the y axis the volume is 12. The face is a fan with the area 9. No message appears.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" three@0.187.0 jsdom@29.1.1 >/dev/null

cat >check.mjs <<'JS'
import { JSDOM } from 'jsdom';
globalThis.document = new JSDOM('').window.document;
const { Box3, Vector3 } = await import('three');
const { VRMLLoader } = await import('three/addons/loaders/VRMLLoader.js');
function show(name, body) {
  const scene = new VRMLLoader().parse(`#VRML V2.0 utf8\n${body}`);
  scene.updateMatrixWorld(true);
  const [box, a, b, c] = [new Box3(), new Vector3(), new Vector3(), new Vector3()];
  let [volume, area] = [0, 0];
  scene.traverse((mesh) => {
    if (!mesh.isMesh) return;
    const plain = mesh.geometry.index ? mesh.geometry.toNonIndexed() : mesh.geometry;
    const points = plain.attributes.position;
    for (let i = 0; i < points.count; i += 3) {
      [a, b, c].forEach((p, k) => {
        box.expandByPoint(p.fromBufferAttribute(points, i + k).applyMatrix4(mesh.matrixWorld));
      });
      volume += a.dot(b.clone().cross(c)) / 6;
      area += b.sub(a).cross(c.sub(a)).length() / 2;
    }
  });
  const spans = ['x', 'y', 'z'].map((k) => `${k} ${(+box.min[k].toFixed(2))}..${(+box.max[k].toFixed(2))}`);
  console.log(`${name}: ${spans.join(' ')}; volume ${Math.abs(volume).toFixed(1)} area ${area.toFixed(1)}`);
}
const square = 'crossSection [ 1 1, 1 -1, -1 -1, -1 1, 1 1 ]';
const corner = '0 0 0, 3 0 0, 3 1 0, 1 1 0, 1 3 0, 0 3 0';
show('box', `Transform { center 1 0 0 rotation 0 0 1 1.5707963 children [ Shape { geometry Box { size 1 1 1 } } ] }`);
show('grid', `Shape { geometry ElevationGrid {
  xDimension 3 zDimension 2 xSpacing 2 zSpacing 4 height [ 0 0 0 1 1 1 ] } }`);
show('extrusion along y', `Shape { geometry Extrusion { ${square} spine [ 0 0 0, 0 3 0 ] } }`);
show('extrusion along x', `Shape { geometry Extrusion { ${square} spine [ 0 0 0, 3 0 0 ] } }`);
show('concave face', `Shape { geometry IndexedFaceSet { convex FALSE
  coord Coordinate { point [ ${corner} ] } coordIndex [ 2 3 4 5 0 1 -1 ] } }`);
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
box: x -0.5..0.5 y -0.5..0.5 z -0.5..0.5; volume 1.0 area 6.0
grid: x 0..2 y 0..1 z 0..8; volume 0.0 area 17.9
extrusion along y: x -1..1 y 0..3 z -1..1; volume 12.0 area 32.0
extrusion along x: x -1..4 y 0..0 z -1..1; volume 0.0 area 20.0
concave face: x 0..3 y 0..3 z 0..0; volume 0.0 area 9.0
EXPECTED
