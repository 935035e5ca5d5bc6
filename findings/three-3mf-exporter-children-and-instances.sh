#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, three-3mf-exporter 45.2.0, three 0.187.0.
# Input:    a cube of 10 with a second cube as its child, at X 20, alone and in a group; the same cubes side by side in a group; an
#           InstancedMesh of three cubes; a cube of which the draw range shows one half. Source: README ("Preserves model names
#           and hierarchy", "Automatic model centering on print bed"); three.js: a Mesh can have children (Object3D.add).
# Expected: Each file has all cubes: 24 triangles for two, 36 for three, 6 for the half. The parts are in the middle of the
#           bed of 256 x 256, so the first cube of the pair is at X 118.
# Seen:     The child of a mesh is missing, without a warning: 12 triangles, and the bed is centred for the parent alone. In a
#           group, both cubes are written. Of three instances, one cube at the origin remains. The draw range is ignored: 12
#           triangles. Nested groups, rotation and scale are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --legacy-peer-deps --prefix "$work" \
  three-3mf-exporter@45.2.0 three@0.187.0 jszip@3.10.1 >/dev/null

cat >check.mjs <<'JS'
import JSZip from 'jszip';
import { BoxGeometry, Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial } from 'three';
import { exportTo3MF } from 'three-3mf-exporter';
const material = new MeshBasicMaterial();
const cube = (x) => {
  const mesh = new Mesh(new BoxGeometry(10, 10, 10), material);
  mesh.position.x = x;
  return mesh;
};
const group = (...parts) => new Group().add(...parts);
const show = async (name, object) => {
  const blob = await exportTo3MF(object);
  const archive = await JSZip.loadAsync(Buffer.from(await blob.arrayBuffer()));
  const model = await archive.file('3D/3dmodel.model').async('string');
  const places = (tag) => [...model.matchAll(new RegExp(`<${tag} [^>]*transform="([^"]*)"`, 'g'))]
    .map((found) => found[1].split(' ').slice(9).map(Number).join(','));
  console.log(`${name}: ${model.match(/<triangle /g).length} triangles, items at ${places('item').join(' ')}` +
    `, components at ${places('component').join(' ') || '-'}`);
};

const parent = () => {
  const mesh = cube(0);
  mesh.add(cube(20));
  return mesh;
};
await show('two cubes in a group', group(cube(0), cube(20)));
await show('two cubes in nested groups', group(cube(0), group(cube(20))));
await show('cube with a child', parent());
await show('cube with a child, in a group', group(parent()));
const instances = new InstancedMesh(new BoxGeometry(10, 10, 10), material, 3);
for (let i = 0; i < 3; i++) instances.setMatrixAt(i, new Matrix4().makeTranslation(20 * i, 0, 0));
await show('three instances', instances);
const half = cube(0);
half.geometry.setDrawRange(0, 18);
await show('draw range of 6 triangles', half);
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
two cubes in a group: 24 triangles, items at 118,128,5, components at 0,0,0 20,0,0
two cubes in nested groups: 24 triangles, items at 118,128,5, components at 20,0,0 0,0,0 0,0,0
cube with a child: 12 triangles, items at 128,128,5, components at -
cube with a child, in a group: 12 triangles, items at 128,128,5, components at 0,0,0
three instances: 12 triangles, items at 128,128,5, components at -
draw range of 6 triangles: 12 triangles, items at 128,128,5, components at -
EXPECTED
