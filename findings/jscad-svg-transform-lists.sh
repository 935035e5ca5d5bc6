#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @jscad/svg-deserializer 2.5.14.
# Input:    a rectangle of 30 x 5 at 10,10 in a drawing of 100 mm with different transform attributes;
#           the path "M0 0 L10 0 L10 10 z l5 5 l5 0", which continues after a closed subpath.
# Expected: SVG applies a list from right to left: "scale(2) translate(10,0)" gives x 40..100 and
#           "translate(10,0) scale(2)" x 30..90. rotate(90,10,10) gives x 5..10. The matrix shifts and scales: x 30..90.
#           The path is valid. An invalid drawing has no influence on later drawings.
# Seen:     The order is ignored: x 30..90 for both lists. rotate with a centre gives NaN. matrix is ignored.
#           The path raises an error; after that, each later call in the same process raises the same error.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @jscad/svg-deserializer@2.5.14 @jscad/modeling@2.13.0 >/dev/null

cat >check.js <<'JS'
const { deserialize } = require('@jscad/svg-deserializer');
const { measureBoundingBox } = require('@jscad/modeling').measurements;
const size = 'width="100mm" height="100mm" viewBox="0 0 100 100"';
const head = `<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg" ${size}>`;
function show(name, body) {
  try {
    const [shape] = [].concat(deserialize({ output: 'geometry', target: 'path' }, `${head}${body}</svg>`));
    const [low, high] = measureBoundingBox(shape).map((p) => [p[0].toFixed(0), (-p[1]).toFixed(0)]);
    console.log(`${name}: x ${low[0]}..${high[0]} y ${high[1]}..${low[1]}`);
  } catch (error) {
    console.log(`${name}: ${error.message}`);
  }
}
const bar = '<rect x="10" y="10" width="30" height="5"';
show('no transform', `${bar}/>`);
for (const transform of [
  'translate(10,0) scale(2)',
  'scale(2) translate(10,0)',
  'rotate(90,10,10)',
  'matrix(2,0,0,2,10,0)',
]) show(transform, `${bar} transform="${transform}"/>`);
show('path', '<path d="M0 0 L10 0 L10 10 z l5 5 l5 0"/>');
show('no transform', `${bar}/>`);
JS
node check.js | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
no transform: x 10..40 y 10..15
translate(10,0) scale(2): x 30..90 y 20..30
scale(2) translate(10,0): x 30..90 y 20..30
rotate(90,10,10): x NaN..NaN y NaN..NaN
matrix(2,0,0,2,10,0): x 10..40 y 10..15
path: Cannot concatenate to a closed path; check the 1th path
no transform: Cannot concatenate to a closed path; check the 1th path
EXPECTED
