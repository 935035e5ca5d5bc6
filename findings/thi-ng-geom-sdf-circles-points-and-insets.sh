#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @thi.ng/geom-sdf 0.4.3 with @thi.ng/geom 8.0.1 (signed distance fields of shapes of the plane).
# Input:    ellipses, one with equal radii; the point 0,0; a square with offsets; a straight quadratic curve; a frame of 40 x 40
#           with a window of 4 x 4 as a difference of two polygons, with and without the attribute bounds. Source: documentation
#           of SDFAttribs (offset: "Subtracts given value from actual distance, thereby creating an offsetting effect"; bounds:
#           wrapped "with a bounding box pre-check", "only usable in some circumstances").
# Expected: An ellipse with equal radii is a circle. The distance of 3,4 to the point 0,0 is 5. A negative offset moves the
#           border inwards. A check of bounds changes the time and no sign, or the circumstances are named.
# Seen:     Each distance to an ellipse with equal radii is NaN, to an ellipse 4,5 it is 0 at the centre. The distance to a
#           point is squared: 25. A negative offset is ignored. The distance to a straight quadratic curve is NaN. With bounds,
#           the frame is outside of itself, 5 instead of -5 at 5,20, because a shape with a distant circle returns the smallest
#           distance before it, here of the first shape, and the difference takes its opposite; only union and points close to
#           the window are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" @thi.ng/geom-sdf@0.4.3 @thi.ng/geom@8.0.1 >/dev/null

cat >check.mjs <<'JS'
import { ellipse, group, points, polygon, quadratic, rect } from '@thi.ng/geom';
import { asSDF } from '@thi.ng/geom-sdf';

const text = (values) => values.map((value) => value.toFixed(2)).join(' ');
const square = (low, high, bounds) =>
  polygon([[low, low], [high, low], [high, high], [low, high]], { __sdf: { bounds } });
const samples = [[5, 20], [38, 38], [17, 20], [20, 20], [50, 20]];
console.log(`samples: ${samples.join(' ')}`);
for (const combine of ['diff', 'isec', 'union'])
  for (const bounds of [false, true]) {
    const field = asSDF(group({ __sdf: { combine } }, [square(0, 40, bounds), square(18, 22, bounds)]));
    console.log(`${combine}, bounds ${bounds}: ${text(samples.map((p) => field(p)))}`);
  }
const offset = (value) => asSDF(rect([0, 0], [10, 10], { __sdf: { offset: value } }));
for (const value of [2, 0, -2])
  console.log(`square of 10, offset ${value}: ${text([[5, 5], [1, 5], [11, 5]].map((p) => offset(value)(p)))}`);
for (const radii of [[5, 4], [4, 5], [5, 5]]) {
  const field = asSDF(ellipse([0, 0], radii));
  console.log(`ellipse ${radii} at 10,0 0,10 0,2 0,0: ${text([[10, 0], [0, 10], [0, 2], [0, 0]].map((p) => field(p)))}`);
}
console.log(`3,4 to the point 0,0: ${text([asSDF(points([[0, 0]]))([3, 4])])}`);
for (const y of [0, 0.01])
  console.log(`5,3 to the curve 0,0 5,${y} 10,0: ${text([asSDF(quadratic([0, 0], [5, y], [10, 0]))([5, 3])])}`);
JS
node check.mjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
samples: 5,20 38,38 17,20 20,20 50,20
diff, bounds false: -5.00 -2.00 -1.00 2.00 10.00
diff, bounds true: 5.00 2.00 -1.00 2.00 10.00
isec, bounds false: 13.00 22.63 1.00 -2.00 28.00
isec, bounds true: -5.00 -2.00 1.00 -2.00 10.00
union, bounds false: -5.00 -2.00 -17.00 -20.00 10.00
union, bounds true: -5.00 -2.00 -17.00 -20.00 10.00
square of 10, offset 2: -7.00 -3.00 -1.00
square of 10, offset 0: -5.00 -1.00 1.00
square of 10, offset -2: -5.00 -1.00 1.00
ellipse 5,4 at 10,0 0,10 0,2 0,0: 5.00 6.00 -2.00 -4.00
ellipse 4,5 at 10,0 0,10 0,2 0,0: 6.00 5.00 -3.00 0.00
ellipse 5,5 at 10,0 0,10 0,2 0,0: NaN NaN NaN NaN
3,4 to the point 0,0: 25.00
5,3 to the curve 0,0 5,0 10,0: NaN
5,3 to the curve 0,0 5,0.01 10,0: 3.00
EXPECTED
