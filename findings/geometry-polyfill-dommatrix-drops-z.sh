#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, geometry-polyfill 1.0.7 and geometry-interfaces 2.0.0 (two implementations of DOMMatrix and DOMPoint of the
#           W3C).
# Input:    turns about Y and moves in Z, then a further move, turn, scale or inverse; the point 1,2,0. Source: Geometry
#           Interfaces Module Level 1 (translate, rotate and scale post-multiply a copy of the matrix; is2D is false after a 3D
#           operation; DOMPoint: w is 1 by default).
# Expected: A chain of translate, rotate and scale gives the same matrix as the same chain of translateSelf, rotateSelf and
#           scaleSelf. A matrix that moves in x and y only is 2D. The default w is 1.
# Seen:     The first package: each method without "Self" starts from is2D true, so a later translate, rotate or scale makes a
#           3D matrix flat: the point loses its z, and the text is a 2D matrix. The inverse of a move by z 5 is the identity as
#           text. The second package: rotate(90) turns about X, and translate(1, 2) gives a 3D matrix; the default w of a point
#           is 0.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" geometry-polyfill@1.0.7 geometry-interfaces@2.0.0 >/dev/null

cat >check.mjs <<'JS'
import { DOMMatrix as Second, DOMPoint as SecondPoint } from 'geometry-interfaces/dist/index.js';

globalThis.window = globalThis;
for (const name of ['DOMMatrix', 'DOMPoint'])
  delete globalThis[name];
globalThis.SVGMatrix = class {};
await import('geometry-polyfill');
const { DOMMatrix: First, DOMPoint: FirstPoint } = window;

const round = (value) => Number(value.toFixed(2)) + 0;
const moved = ({ m11, m12, m13, m21, m22, m23, m31, m32, m33, m41, m42, m43 }, [x, y, z]) =>
  [m11 * x + m21 * y + m31 * z + m41, m12 * x + m22 * y + m32 * z + m42, m13 * x + m23 * y + m33 * z + m43].map(round);
const chains = {
  'rotate(0, 90, 0)': (m) => m.rotate(0, 90, 0),
  'rotate(0, 90, 0).translate(1, 0, 0)': (m) => m.rotate(0, 90, 0).translate(1, 0, 0),
  'rotateSelf(0, 90, 0).translateSelf(1, 0, 0)': (m) => m.rotateSelf(0, 90, 0).translateSelf(1, 0, 0),
  'translate(0, 0, 5).rotate(90)': (m) => m.translate(0, 0, 5).rotate(90),
  'translate(0, 0, 5).scale(2)': (m) => m.translate(0, 0, 5).scale(2),
};
for (const [name, chain] of Object.entries(chains)) {
  const matrix = chain(new First());
  const { x, y, z } = new FirstPoint(1, 2, 0).matrixTransform(matrix);
  console.log(`${name}: is2D ${matrix.is2D}, 1,2,0 to ${[x, y, z].map(round)}, by the second package ${
    moved(chain(new Second()), [1, 2, 0])}`);
  if (matrix.is2D)
    console.log(`  as text: ${matrix}`);
}
console.log(`inverse of a move by z 5: ${new First().translate(0, 0, 5).inverse()}`);
const flat = () => new Second().translate(1, 2);
console.log(`second package, translate(1, 2): ${flat()}`);
for (const turn of ['rotate', 'rotateSelf'])
  console.log(`  ${turn}(90): 1,2,0 to ${moved(new Second()[turn](90), [1, 2, 0])}, first package ${
    moved(new First()[turn](90), [1, 2, 0])}`);
console.log(`  w of the point 1,2,3: ${new SecondPoint(1, 2, 3).w}, first package ${new FirstPoint(1, 2, 3).w}`);
JS
node check.mjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
rotate(0, 90, 0): is2D false, 1,2,0 to 0,2,-1, by the second package 0,2,-1
rotate(0, 90, 0).translate(1, 0, 0): is2D true, 1,2,0 to 0,2,0, by the second package 0,2,-2
  as text: matrix(6.123233995736766e-17, 0, 0, 1, 6.123233995736766e-17, 0)
rotateSelf(0, 90, 0).translateSelf(1, 0, 0): is2D false, 1,2,0 to 0,2,-2, by the second package 0,2,-2
translate(0, 0, 5).rotate(90): is2D true, 1,2,0 to -2,1,0, by the second package 1,0,7
  as text: matrix(6.123233995736766e-17, 1, -1, 6.123233995736766e-17, 0, 0)
translate(0, 0, 5).scale(2): is2D true, 1,2,0 to 2,4,0, by the second package 2,4,5
  as text: matrix(2, 0, 0, 2, 0, 0)
inverse of a move by z 5: matrix(1, 0, 0, 1, 0, 0)
second package, translate(1, 2): matrix3d(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 0, 1)
  rotate(90): 1,2,0 to 1,0,2, first package -2,1,0
  rotateSelf(90): 1,2,0 to -2,1,0, first package -2,1,0
  w of the point 1,2,3: 0, first package 1
EXPECTED
