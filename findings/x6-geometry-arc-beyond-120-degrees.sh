#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @antv/x6-geometry 2.0.5 (paths, curves and intersections in the plane).
# Input:    SVG paths of one arc with radius 5 about the origin: 90, 120, 180 and 270 degrees; a circle of two halves; an arc
#           of an ellipse with the rotation 30.
# Expected: Each path ends where its arc ends: at 0,5 -2.5,4.33 -5,0 0,-5 and, for the ellipse, at 0,3. The lengths are
#           7.85, 10.47, 15.71, 23.56 and 31.42. The line Y -1 meets the circle at two points.
# Seen:     An arc is cut after a multiple of 120 degrees: the half circle ends at -2.5,4.33, and its length is 10.48.
#           The two halves of the circle have the length 20.95, and the line has no point. The turned ellipse ends at
#           0.57,3.24. Arcs of 90 and 120 degrees are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @antv/x6-geometry@2.0.5 >/dev/null

cat >check.mjs <<'JS'
import { Line, Path } from '@antv/x6-geometry';
const show = (name, text) => {
  const path = Path.parse(text);
  const points = path.intersectsWithLine(new Line(-10, -1, 10, -1)) ?? [];
  const end = path.serialize().replace(/ Z$/, '').split(' ').slice(-2);
  console.log(`${name}: ends at ${end.join(',')}, length ${path.length().toFixed(2)}, points on Y -1: ${points.length}`);
};
show('90 degrees', 'M5 0A5 5 0 0 1 0 5');
show('120 degrees', 'M5 0A5 5 0 0 1 -2.5 4.3301');
show('180 degrees', 'M5 0A5 5 0 0 1 -5 0');
show('270 degrees', 'M5 0A5 5 0 1 1 0 -5');
show('circle', 'M5 0A5 5 0 0 1 -5 0A5 5 0 0 1 5 0Z');
show('ellipse, 0 degrees', 'M5 0A5 3 0 0 1 0 3');
show('ellipse, 30 degrees', 'M5 0A5 3 30 0 1 0 3');
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
90 degrees: ends at 0,5, length 7.85, points on Y -1: 0
120 degrees: ends at -2.5,4.33, length 10.48, points on Y -1: 0
180 degrees: ends at -2.5,4.33, length 10.48, points on Y -1: 0
270 degrees: ends at -2.5,-4.33, length 20.95, points on Y -1: 1
circle: ends at 5,0, length 20.95, points on Y -1: 0
ellipse, 0 degrees: ends at 0,3, length 6.38, points on Y -1: 0
ellipse, 30 degrees: ends at 0.57,3.24, length 7.78, points on Y -1: 0
EXPECTED
