#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, jscad-to-gltf 0.0.5 with @jscad/modeling 2.13.0.
# Input:    a bracket (box of 2 x 4 x 6 with a groove), turned, mirrored, and mirrored twice; the mirrored bracket
#           after a union with a second box. Source: glTF 2.0, 3.7.2.1 (counter-clockwise triangles are front faces);
#           @jscad/modeling, geom3.toPolygons applies the transforms.
# Expected: The volume of the triangles is that of @jscad/modeling, and the normals of flat faces point outwards.
# Seen:     The converter applies the matrix of JSCAD to the corners, but keeps their order: mirrored parts are inside
#           out, with the volume -40 and all normals inwards. Viewers with back-face culling show the inside, and
#           slicers see a hole. After a boolean operation, which applies the matrix in JSCAD, the same part is right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --legacy-peer-deps --prefix "$work" \
  jscad-to-gltf@0.0.5 @jscad/modeling@2.13.0 >/dev/null

cat >check.mjs <<'JS'
import modeling from '@jscad/modeling';
import { convertJscadModelToGltf } from 'jscad-to-gltf';
const { booleans, measurements, primitives, transforms } = modeling;
const box = (size, center) => primitives.cuboid({ size, center });
const bracket = () => booleans.subtract(box([2, 4, 6], [1, 2, 3]), box([1, 4, 2], [0.5, 2, 5]));
const show = async (name, geom) => {
  const { data } = await convertJscadModelToGltf({ geometries: [{ geom }] }, { format: 'gltf' });
  const gltf = JSON.parse(data);
  const primitive = gltf.meshes[0].primitives[0];
  const read = (index) => {
    const { bufferView, byteOffset = 0, count } = gltf.accessors[index];
    const view = gltf.bufferViews[bufferView];
    const buffer = Buffer.from(gltf.buffers[view.buffer].uri.split(',')[1], 'base64');
    const start = (view.byteOffset ?? 0) + byteOffset;
    return Array.from({ length: count }, (_, i) => [0, 4, 8].map((k) => buffer.readFloatLE(start + 12 * i + k)));
  };
  const [points, normals] = [read(primitive.attributes.POSITION), read(primitive.attributes.NORMAL)];
  let [volume, flux] = [0, 0];
  for (let i = 0; i < points.length; i += 3) {
    const [a, b, c] = points.slice(i, i + 3);
    const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]));
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    volume += (a[0] * n[0] + a[1] * n[1] + a[2] * n[2]) / 6;
    flux += (Math.hypot(...n) * (a[0] * normals[i][0] + a[1] * normals[i][1] + a[2] * normals[i][2])) / 6;
  }
  console.log(`${name}: JSCAD ${measurements.measureVolume(geom).toFixed(2)}, glTF ${volume.toFixed(2)}, by normals ${flux.toFixed(2)}`);
};
await show('bracket', bracket());
await show('turned', transforms.rotateZ(Math.PI / 2, bracket()));
await show('mirrored', transforms.mirrorX(bracket()));
await show('mirrored twice', transforms.mirrorY(transforms.mirrorX(bracket())));
await show('mirrored, union', booleans.union(transforms.mirrorX(bracket()), box([1, 1, 1], [-1, 2, 1])));
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
bracket: JSCAD 40.00, glTF 40.00, by normals 40.00
turned: JSCAD 40.00, glTF 40.00, by normals 40.00
mirrored: JSCAD 40.00, glTF -40.00, by normals -40.00
mirrored twice: JSCAD 40.00, glTF 40.00, by normals 40.00
mirrored, union: JSCAD 40.00, glTF 40.00, by normals 40.00
EXPECTED
