#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @thi.ng/geom 8.0.1.
# Input:    SVG paths: a triangle without repeated command letters, as Inkscape writes; a triangle and a small one
#           after "zm"; a wave of C and S. Shapes `arc`: half a circle and half an ellipse, turned by 30 degrees.
#           Source: SVG 2, 9.3.3 (further pairs after a moveto are lineto), 9.3.4 (after closepath, the current point
#           is the start of the subpath), 9.3.6 (S: reflection of the second control point); documentation of
#           `bounds`.
# Expected: Both triangles have three edges. The second triangle starts at 11,1. The wave is symmetric: y -7.5 to 7.5,
#           length 40. The bounds of an arc contain its points: y up to 3.61, or 5 for the half circle.
# Seen:     Each further pair is a moveto: a path without edges and bounds, and no error. The second triangle starts
#           at 16,6, the end of the last line. The control point of S is its start point: the lower half is missing in
#           the bounds, and the length is 34.55. The bounds of a turned arc omit its extremes: y up to 2.60 and 4.33.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @thi.ng/geom@8.0.1 >/dev/null

cat >check.mjs <<'JS'
import { arc, arcLength, asSvg, bounds, pathFromSvg, vertices } from '@thi.ng/geom';
const extents = (xs, ys) => `x ${Math.min(...xs).toFixed(2)} to ${Math.max(...xs).toFixed(2)}, ` +
  `y ${Math.min(...ys).toFixed(2)} to ${Math.max(...ys).toFixed(2)}`;
const boundsOf = (shape) => {
  const box = bounds(shape);
  return box ? extents([box.pos[0], box.pos[0] + box.size[0]], [box.pos[1], box.pos[1] + box.size[1]]) : 'none';
};
const show = (name, text) => {
  const path = pathFromSvg(text);
  console.log(`${name}: ${asSvg(path).match(/d="(.*)"/)[1]}, bounds ${boundsOf(path)}` +
    (bounds(path) ? `, length ${arcLength(path).toFixed(2)}` : ''));
};
show('triangle, all letters', 'M1 1L6 1L6 6Z');
show('triangle, M once', 'M1 1 6 1 6 6Z');
show('triangle, m once', 'm1 1 5 0 0 5z');
show('M after z', 'M1 1h5v5zM11 1h2v2z');
show('m after z', 'M1 1h5v5zm10 0h2v2z');
show('two C', 'M0 0C0 10 10 10 10 0C10 -10 20 -10 20 0');
show('C and S', 'M0 0C0 10 10 10 10 0S20 -10 20 0');

for (const [name, radii, turn] of [['circle', [5, 5], 30], ['ellipse', [5, 3], 0], ['ellipse', [5, 3], 30]]) {
  const half = arc([0, 0], radii, (turn * Math.PI) / 180, 0, Math.PI);
  const points = vertices(half, 1000);
  console.log(`half ${name}, turned by ${turn}: points ${extents(points.map((p) => p[0]), points.map((p) => p[1]))}; ` +
    `bounds ${boundsOf(half)}`);
}
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
triangle, all letters: M1,1H6V6L1,1z, bounds x 1.00 to 6.00, y 1.00 to 6.00, length 17.07
triangle, M once: M6,1M6,6z, bounds none
triangle, m once: M6,1M6,6z, bounds none
M after z: M1,1H6V6L1,1zM11,1H13V3L11,1z, bounds x 1.00 to 13.00, y 1.00 to 6.00, length 23.90
m after z: M1,1H6V6L1,1zM16,6H18V8L16,6z, bounds x 1.00 to 18.00, y 1.00 to 8.00, length 23.90
two C: M0,0C0,10,10,10,10,0C10,-10,20,-10,20,0, bounds x 0.00 to 20.00, y -7.50 to 7.50, length 39.96
C and S: M0,0C0,10,10,10,10,0C10,0,20,-10,20,0, bounds x 0.00 to 20.00, y 0.00 to 7.50, length 34.55
half circle, turned by 30: points x -5.00 to 4.33, y -2.50 to 5.00; bounds x -4.33 to 4.33, y -2.50 to 4.33
half ellipse, turned by 0: points x -5.00 to 5.00, y 0.00 to 3.00; bounds x -5.00 to 5.00, y 0.00 to 3.00
half ellipse, turned by 30: points x -4.58 to 4.33, y -2.50 to 3.61; bounds x -4.33 to 4.33, y -2.50 to 2.60
EXPECTED
