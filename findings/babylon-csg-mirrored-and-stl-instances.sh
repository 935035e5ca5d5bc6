#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @babylonjs/core 9.35.0 (CSG, MeshBuilder, NullEngine) and @babylonjs/serializers 9.28.0 (STLExport).
# Input:    a cube of 2 minus, plus and intersected with a cube of 2 at 1,1,1: plain, mirrored by the scale -1 in X, and
#           mirrored with the transform baked into the vertices; a box of 4 x 2 x 1 with an instance and with a clone at
#           X 10. All as STL.
# Expected: The mirrored cube is the same solid, so all differences are 7, unions 15, intersections 1. The two boxes span
#           X -2 to 12.
# Seen:     With the mirrored cube, subtract returns the intersection (1), intersect returns the difference (7), and
#           union returns the other difference inside out (-7). The instance is written at the place of its source: X -2 to 2.
#           No error or warning appears. The mirrored cube alone is exported right, and the baked one is right in all
#           operations.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @babylonjs/core@9.35.0 @babylonjs/serializers@9.28.0 babylonjs-gltf2interface@9.28.0 >/dev/null

cat >check.mjs <<'JS'
import { CSG, MeshBuilder, NullEngine, Scene } from '@babylonjs/core/index.js';
import { STLExport } from '@babylonjs/serializers/stl/index.js';
const scene = new Scene(new NullEngine());
const show = (name, meshes) => {
  const stl = STLExport.CreateSTL(meshes, false, 'part', false);
  const points = [...stl.matchAll(/vertex (\S+) (\S+) (\S+)/g)].map((match) => match.slice(1).map(Number));
  let volume = 0;
  for (let i = 0; i < points.length; i += 3) {
    const [a, b, c] = points.slice(i, i + 3);
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  }
  const xs = points.map((point) => point[0]);
  console.log(`${name}: volume ${volume.toFixed(2)}, X ${Math.min(...xs).toFixed(0)} to ${Math.max(...xs).toFixed(0)}`);
};

const cube = CSG.FromMesh(MeshBuilder.CreateBox('cube', { size: 2 }, scene));
for (const kind of ['plain', 'mirrored', 'mirrored, baked']) {
  const other = MeshBuilder.CreateBox('other', { size: 2 }, scene);
  other.position.set(1, 1, 1);
  if (kind !== 'plain') other.scaling.x = -1;
  if (kind === 'mirrored, baked') other.bakeCurrentTransformIntoVertices();
  other.computeWorldMatrix(true);
  const tool = CSG.FromMesh(other);
  console.log(`${kind}:`);
  for (const operation of ['subtract', 'union', 'intersect']) {
    show(`  ${operation}`, [cube[operation](tool).toMesh('result', null, scene)]);
  }
  show('  exported alone', [other]);
}

const box = MeshBuilder.CreateBox('box', { width: 4, height: 2, depth: 1 }, scene);
const instance = box.createInstance('instance');
instance.position.x = 10;
instance.computeWorldMatrix(true);
console.log(`instance in the scene: X up to ${instance.getBoundingInfo().boundingBox.maximumWorld.x}`);
show('box and instance', [box, instance]);
const clone = box.clone('clone');
clone.position.x = 10;
clone.computeWorldMatrix(true);
show('box and clone', [box, clone]);
process.exit(0);
JS
node check.mjs | grep -v '^BJS' | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
plain:
  subtract: volume 7.00, X -1 to 1
  union: volume 15.00, X -1 to 2
  intersect: volume 1.00, X 0 to 1
  exported alone: volume 8.00, X 0 to 2
mirrored:
  subtract: volume 1.00, X 0 to 1
  union: volume -7.00, X 0 to 2
  intersect: volume 7.00, X -1 to 1
  exported alone: volume 8.00, X 0 to 2
mirrored, baked:
  subtract: volume 7.00, X -1 to 1
  union: volume 15.00, X -1 to 2
  intersect: volume 1.00, X 0 to 1
  exported alone: volume 8.00, X 0 to 2
instance in the scene: X up to 12
box and instance: volume 16.00, X -2 to 2
box and clone: volume 16.00, X -2 to 12
EXPECTED
