#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, nurbs 1.1.1 (evaluator of a first derivative).
# Input:    a quarter of a cylinder, radius 1 and height 2, as a rational surface of the degrees 2 and 1 with the weights
#           1, 1/sqrt 2, 1; the same surface with the parameters exchanged; the control points without weights.
# Expected: The derivatives agree with difference quotients. The derivative along the axis is 0,0,2 everywhere.
# Seen:     The derivative for the first parameter is right. The derivative for the second parameter, along the axis,
#           has -0.14 in X and Y: it leaves the cylinder. The points are right, and no message appears.
#           With exchanged parameters or without weights both derivatives are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" nurbs@1.1.1 >/dev/null

cat >check.js <<'JS'
const nurbs = require('nurbs');
const half = Math.SQRT1_2;
const ring = [[1, 0], [1, 1], [0, 1]];
const around = {
  points: ring.map(([x, y]) => [[x, y, 0], [x, y, 2]]), weights: [[1, 1], [half, half], [1, 1]], degree: [2, 1],
};
const along = {
  points: [0, 2].map((z) => ring.map(([x, y]) => [x, y, z])), weights: [[1, half, 1], [1, half, 1]], degree: [1, 2],
};
const plain = { points: around.points, degree: [2, 1] };

const text = (vector) => vector.map((x) => (Math.round(x * 1000) / 1000 + 0).toFixed(3)).join(',');
for (const [name, surface, place] of [
  ['circle in parameter 1', around, [0.3, 0.6]],
  ['circle in parameter 2', along, [0.6, 0.3]],
  ['without weights', plain, [0.3, 0.6]],
]) {
  const s = nurbs({ ...surface, boundary: 'clamped' });
  const at = s.domain.map(([low, high], i) => low + place[i] * (high - low));
  console.log(`${name}: point ${text(s.evaluate([], ...at))}`);
  for (const k of [0, 1]) {
    const shifted = (step) => s.evaluate([], ...at.map((t, i) => (i === k ? t + step : t)));
    const [above, below] = [shifted(1e-5), shifted(-1e-5)];
    const quotient = above.map((x, i) => (x - below[i]) / 2e-5);
    const derivative = s.evaluator(k === 0 ? [1, 0] : [0, 1])([], ...at);
    console.log(`  derivative ${k + 1}: ${text(derivative)}, difference quotient ${text(quotient)}`);
  }
}
JS
node check.js | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
circle in parameter 1: point 0.897,0.441,1.200
  derivative 1: -0.712,1.447,0.000, difference quotient -0.712,1.447,0.000
  derivative 2: -0.140,-0.140,2.000, difference quotient 0.000,0.000,2.000
circle in parameter 2: point 0.897,0.441,1.200
  derivative 1: 0.000,0.000,2.000, difference quotient 0.000,0.000,2.000
  derivative 2: -0.712,1.447,0.000, difference quotient -0.712,1.447,0.000
without weights: point 0.910,0.510,1.200
  derivative 1: -0.600,1.400,0.000, difference quotient -0.600,1.400,0.000
  derivative 2: 0.000,0.000,2.000, difference quotient 0.000,0.000,2.000
EXPECTED
