#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @jscad/stl-deserializer 2.1.30.
# Input:    a unit cube with outward vertex order as STL: normals as calculated, and 0 0 0 (which many writers use,
#           because a reader can calculate the normal); an ASCII file with two solids.
# Expected: The normal is redundant: the volume is 1 in all cases. The file with two solids gives two cubes.
# Seen:     With the normals 0 0 0 each facet is reversed, so the volume is -1, in ASCII and in binary.
#           The file with two solids gives two shapes that each have both cubes: 48 triangles instead of 24.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @jscad/stl-deserializer@2.1.30 @jscad/modeling@2.13.0 >/dev/null

cat >check.js <<'JS'
const { deserialize } = require('@jscad/stl-deserializer');
const { measureVolume } = require('@jscad/modeling').measurements;
const corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
const quads = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
const normals = [[0, 0, -1], [0, 0, 1], [0, -1, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0]];
const facets = (normal, shift = 0) =>
  quads.flatMap(([a, b, c, d], i) =>
    [[a, b, c], [a, c, d]].map((face) => [
      normal || normals[i],
      ...face.map((k) => [corners[k][0] + shift, corners[k][1], corners[k][2]]),
    ]));
const ascii = (list) =>
  `solid part\n${list
    .map(([n, ...p]) => `facet normal ${n.join(' ')}\nouter loop\n${p
      .map((v) => `vertex ${v.join(' ')}\n`).join('')}endloop\nendfacet\n`)
    .join('')}endsolid part\n`;
function binary(list) {
  const data = Buffer.alloc(84 + 50 * list.length);
  data.writeUInt32LE(list.length, 80);
  list.forEach((facet, i) => facet.flat().forEach((v, k) => data.writeFloatLE(v, 84 + 50 * i + 4 * k)));
  return data;
}
function show(name, data) {
  const shapes = [].concat(deserialize({ output: 'geometry' }, data));
  const sizes = shapes.map((shape) => `${shape.polygons.length} triangles, volume ${measureVolume(shape).toFixed(2)}`);
  console.log(`${name}: ${sizes.join('; ')}`);
}
const zero = [0, 0, 0];
show('ascii, calculated normals', ascii(facets()));
show('binary, calculated normals', binary(facets()));
show('ascii, zero normals', ascii(facets(zero)));
show('binary, zero normals', binary(facets(zero)));
show('ascii, two solids', ascii(facets()) + ascii(facets(null, 5)));
JS
node check.js | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
ascii, calculated normals: 12 triangles, volume 1.00
binary, calculated normals: 12 triangles, volume 1.00
ascii, zero normals: 12 triangles, volume -1.00
binary, zero normals: 12 triangles, volume -1.00
ascii, two solids: 24 triangles, volume 2.00; 24 triangles, volume 2.00
EXPECTED
