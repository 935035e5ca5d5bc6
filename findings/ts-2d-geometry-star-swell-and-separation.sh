#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, ts-2d-geometry 6.3.5 (polygons, segments and transforms of the plane).
# Input:    a square, an L and a star with five tips, each enlarged by 1; two regular octagons of radius r at a distance of r,
#           to be separated along -X; the point 1,0 turned by 90 degrees and by the vector 0,1. Source: README of the package
#           (positive y goes upwards, which matters for rotation) and names of the functions (swell, separationVector with a
#           direction).
# Expected: Each area grows. The first octagon moves by -r in X, because the corners of both octagons lie on the X axis. Both
#           turns have the same direction.
# Seen:     The star loses half of its area, 117.56 to 56.85, because the orientation is the sum of the cross products of
#           adjacent sides, so its reflex corners outweigh the convex ones. Octagons of radius 5 move by +5 to the far side, of
#           radius 20 by -8.28 into each other: the distances are sorted as text. withRotationDegrees turns clockwise,
#           withVectorRotation counter-clockwise.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" ts-2d-geometry@6.3.5 >/dev/null

cat >check.cjs <<'JS'
const { polygon, point, vector, Transformation } = require('ts-2d-geometry');
const number = (value) => (Math.abs(value) < 5e-3 ? 0 : value).toFixed(2);
const area = (shape) =>
  Math.abs(shape.points().reduce((sum, p, i, all) => {
    const q = all[(i + 1) % all.length];
    return sum + p.x * q.y - q.x * p.y;
  }, 0) / 2);
const star = [...Array(10).keys()].map((i) => [i, i % 2 ? 4 : 10])
  .map(([i, r]) => [r * Math.cos(i * Math.PI / 5), r * Math.sin(i * Math.PI / 5)]);
const shapes = {
  square: [[0, 0], [10, 0], [10, 10], [0, 10]],
  L: [[0, 0], [20, 0], [20, 5], [5, 5], [5, 20], [0, 20]],
  star,
  'star, clockwise': [...star].reverse(),
};
for (const [name, points] of Object.entries(shapes)) {
  const shape = polygon(points);
  console.log(`${name}: area ${number(area(shape))}, enlarged by 1: ${number(area(shape.swell(1)))}`);
}
const octagon = (radius, x) => polygon([...Array(8).keys()].map((i) => i * Math.PI / 4)
  .map((angle) => [x + radius * Math.cos(angle), radius * Math.sin(angle)]));
for (const radius of [2, 5, 20, 50]) {
  const move = octagon(radius, 0).separationVector(octagon(radius, radius), vector(-1, 0));
  console.log(`octagons of radius ${radius}: move by ${number(move.x)},${number(move.y)}`);
}
const turns = Transformation.builder();
for (const [name, turn] of [['90 degrees', turns.withRotationDegrees(90)], ['vector 0,1', turns.withVectorRotation(vector(0, 1))]]) {
  const end = turn.build().applyToPoint(point(1, 0));
  console.log(`1,0 turned by ${name}: ${number(end.x)},${number(end.y)}`);
}
JS
node check.cjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
square: area 100.00, enlarged by 1: 144.00
L: area 175.00, enlarged by 1: 259.00
star: area 117.56, enlarged by 1: 56.85
star, clockwise: area 117.56, enlarged by 1: 56.85
octagons of radius 2: move by -2.00,0.00
octagons of radius 5: move by 5.00,0.00
octagons of radius 20: move by -8.28,0.00
octagons of radius 50: move by -50.00,0.00
1,0 turned by 90 degrees: 0.00,-1.00
1,0 turned by vector 0,1: 0.00,1.00
EXPECTED
