#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @adaskothebeast/splines 4.0.0.
# Input:    points on the line y = x; the points 0,0 1,1 2,0; the points 0,0 1,1 3,2 6,1 7,0. Source: readme.md
#           ("Natural Cubic Spline: a piece-wise cubic polynomial that is twice continuously differentiable").
# Expected: NaturalSpline reproduces the line. At 0.5, the three points give 0.6875: second derivatives 0, -3, 0. The
#           spline passes through its points, and its slope has no jump.
# Seen:     The first interval is 0, and the last one NaN, also at the last point. In between, the spline is a
#           polyline: the slope jumps from 0.50 to -0.33 at x = 3. MonotoneCubicHermitInterpolation of the same
#           package is right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @adaskothebeast/splines@4.0.0 >/dev/null

cat >check.mjs <<'JS'
import { MonotoneCubicHermitInterpolation, NaturalSpline } from '@adaskothebeast/splines';
const show = (name, points, positions) => {
  for (const [kind, Spline] of [['natural', NaturalSpline], ['monotone', MonotoneCubicHermitInterpolation]]) {
    const spline = new Spline(points);
    console.log(`${name}, ${kind}: ${positions.map((x) => `${x}: ${spline.interpolate(x).toFixed(4)}`).join(', ')}`);
  }
};
show('line', [[0, 0], [1, 1], [2, 2], [3, 3]], [0.5, 1.5, 2.5, 3]);
show('three points', [[0, 0], [1, 1], [2, 0]], [0.5, 1, 1.5]);
const points = [[0, 0], [1, 1], [3, 2], [6, 1], [7, 0]];
show('five points', points, [0.5, 1.5, 2, 2.5, 4, 5, 6.5]);
const spline = new NaturalSpline(points);
const slope = (from, to) => ((spline.interpolate(to) - spline.interpolate(from)) / (to - from)).toFixed(2);
console.log(`slope at 3: ${slope(2.999, 3)} before, ${slope(3, 3.001)} after`);
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
line, natural: 0.5: 0.0000, 1.5: 1.5000, 2.5: NaN, 3: NaN
line, monotone: 0.5: 0.5000, 1.5: 1.5000, 2.5: 2.5000, 3: 3.0000
three points, natural: 0.5: 0.0000, 1: 0.0000, 1.5: NaN
three points, monotone: 0.5: 0.6250, 1: 1.0000, 1.5: 0.6250
five points, natural: 0.5: 0.0000, 1.5: 1.2500, 2: 1.5000, 2.5: 1.7500, 4: 1.6667, 5: 1.3333, 6.5: NaN
five points, monotone: 0.5: 0.5385, 1.5: 1.3510, 2: 1.6731, 2.5: 1.9087, 4: 1.8620, 5: 1.5017, 6.5: 0.5568
slope at 3: 0.50 before, -0.33 after
EXPECTED
