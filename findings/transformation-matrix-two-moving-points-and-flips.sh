#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, transformation-matrix 3.1.0 (affine transformations in the plane).
# Input:    pairs of points that move to other pairs; products of a translation, a scale and a rotation by 20 or 90 degrees, with
#           and without a mirrored axis. Source: comments of the library (fromTwoMovingPoints: "Calculate a transformation matrix
#           about two points that move from positions A and B to A' and B'"; decomposeTSR: "it's only true for:
#           decomposeTSR(compose(T, S, R)) === { translate: T, rotation: R, scale: S }"; flipX, flipY: "Whether the matrix contains
#           vertical flip" or "horizontal flip").
# Expected: The matrix moves A to A' and B to B'. The composed parts of a decomposition are the matrix.
# Seen:     If A moves and the points are turned or scaled, both points miss their targets: A is at 20,0 instead of 5,5. A pure
#           translation and a fixed A are right. With the flag of the mirrored axis, the rotation has the wrong sign, so the
#           composed parts are a different matrix; without the flag, the parts are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" transformation-matrix@3.1.0 >/dev/null

cat >check.mjs <<'JS'
import { applyToPoint, compose, decomposeTSR, fromTwoMovingPoints, rotate, rotateDEG, scale, translate } from 'transformation-matrix';
const text = (values) => values.map((v) => v.toFixed(3).replace(/^-(0\.0*)$/, '$1')).join(',');
const point = ([x, y]) => ({ x, y });
const move = (from, to) => {
  const matrix = fromTwoMovingPoints(...from.map(point), ...to.map(point));
  const ends = from.map((p) => applyToPoint(matrix, point(p))).map(({ x, y }) => text([x, y]));
  console.log(`${from.join(' ')} to ${to.join(' ')}: moved to ${ends.join(' ')}`);
};
move([[0, 0], [10, 0]], [[3, 4], [13, 4]]);
move([[2, 0], [10, 0]], [[3, 4], [3, 12]]);
move([[2, 0], [10, 0]], [[2, 0], [2, 16]]);
move([[2, 3], [10, 3]], [[4, 3], [8, 3]]);
move([[0, 0], [1, 0]], [[5, 5], [5, 7]]);
const numbers = ({ a, b, c, d, e, f }) => text([a, b, c, d, e, f]);
const decompose = (sx, sy, degrees, ...flips) => {
  const matrix = compose(translate(4, 5), scale(sx, sy), rotateDEG(degrees));
  const parts = decomposeTSR(matrix, ...flips);
  const composed = compose(
    translate(parts.translate.tx, parts.translate.ty), scale(parts.scale.sx, parts.scale.sy), rotate(parts.rotation.angle));
  console.log(`scale ${sx},${sy} rotation ${degrees}, flags ${flips}: matrix ${numbers(matrix)}, parts ` +
    `scale ${text([parts.scale.sx, parts.scale.sy])} rotation ${text([parts.rotation.angle * 180 / Math.PI])}, composed ${numbers(composed)}`);
};
for (const degrees of [20, 90]) {
  decompose(2, 3, degrees, false, false);
  decompose(2, -3, degrees, false, false);
  decompose(2, -3, degrees, true, false);
  decompose(-2, 3, degrees, false, true);
}
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
0,0 10,0 to 3,4 13,4: moved to 3.000,4.000 13.000,4.000
2,0 10,0 to 3,4 3,12: moved to 8.000,7.000 8.000,15.000
2,0 10,0 to 2,0 2,16: moved to 2.000,0.000 2.000,16.000
2,3 10,3 to 4,3 8,3: moved to 5.000,3.000 9.000,3.000
0,0 1,0 to 5,5 5,7: moved to 20.000,0.000 20.000,2.000
scale 2,3 rotation 20, flags false,false: matrix 1.879,1.026,-0.684,2.819,4.000,5.000, parts scale 2.000,3.000 rotation 20.000, composed 1.879,1.026,-0.684,2.819,4.000,5.000
scale 2,-3 rotation 20, flags false,false: matrix 1.879,-1.026,-0.684,-2.819,4.000,5.000, parts scale 2.000,-3.000 rotation 20.000, composed 1.879,-1.026,-0.684,-2.819,4.000,5.000
scale 2,-3 rotation 20, flags true,false: matrix 1.879,-1.026,-0.684,-2.819,4.000,5.000, parts scale 2.000,-3.000 rotation -20.000, composed 1.879,1.026,0.684,-2.819,4.000,5.000
scale -2,3 rotation 20, flags false,true: matrix -1.879,1.026,0.684,2.819,4.000,5.000, parts scale -2.000,3.000 rotation -20.000, composed -1.879,-1.026,-0.684,2.819,4.000,5.000
scale 2,3 rotation 90, flags false,false: matrix 0.000,3.000,-2.000,0.000,4.000,5.000, parts scale 2.000,3.000 rotation 90.000, composed 0.000,3.000,-2.000,0.000,4.000,5.000
scale 2,-3 rotation 90, flags false,false: matrix 0.000,-3.000,-2.000,0.000,4.000,5.000, parts scale 2.000,-3.000 rotation 90.000, composed 0.000,-3.000,-2.000,0.000,4.000,5.000
scale 2,-3 rotation 90, flags true,false: matrix 0.000,-3.000,-2.000,0.000,4.000,5.000, parts scale 2.000,-3.000 rotation -90.000, composed 0.000,3.000,2.000,0.000,4.000,5.000
scale -2,3 rotation 90, flags false,true: matrix 0.000,3.000,2.000,0.000,4.000,5.000, parts scale -2.000,3.000 rotation -90.000, composed 0.000,-3.000,-2.000,0.000,4.000,5.000
EXPECTED
