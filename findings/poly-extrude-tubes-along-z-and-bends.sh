#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, poly-extrude 0.16.0 (solids from polygons, polylines and tubes).
# Input:    tubes of radius 1 along X, Y, Z and two inclined directions; tubes and flat ribbons of width 2 with one bend, in the
#           plane XY and in the plane XZ. Source: types of the package (expandTubes: paths with three coordinates, radius;
#           expandPaths: lineWidth).
# Expected: All points of a straight tube are at the distance 1 from its axis. At a bend of 90 degrees, a mitred tube is 1.41
#           wide in the plane of the bend and 1 across it. A ribbon is 2 wide.
# Seen:     A tube along Z collapses to its axis: all points are at the distance 0; 1,0,10 is right. At a bend, the tube is 1.41
#           in all directions, also across the plane, where it stays 1. A ribbon that bends upwards grows from 2 to 2.83 at the
#           bend, although its width lies in the direction Y.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" poly-extrude@0.16.0 >/dev/null

cat >check.cjs <<'JS'
const { expandPaths, expandTubes } = require('poly-extrude');

const points = ({ position }) => [...Array(position.length / 3).keys()].map((i) => [0, 1, 2].map((k) => position[3 * i + k]));
const toAxis = (p, d) => {
  const t = p.reduce((sum, v, k) => sum + v * d[k], 0) / d.reduce((sum, v) => sum + v * v, 0);
  return Math.hypot(...p.map((v, k) => v - t * d[k]));
};
const range = (values) => `${Math.min(...values).toFixed(2)} to ${Math.max(...values).toFixed(2)}`;
for (const end of [[10, 0, 0], [0, 10, 0], [6, 8, 0], [6, 0, 8], [1, 0, 10], [0, 0, 10]]) {
  const tube = expandTubes([[[0, 0, 0], end]], { radius: 1, radialSegments: 32 });
  console.log(`tube to ${end}: distance to the axis ${range(points(tube).map((p) => toAxis(p, end)))}`);
}
const bends = { XY: [[0, 0, 0], [10, 0, 0], [10, 10, 0]], XZ: [[0, 0, 0], [10, 0, 0], [10, 0, 10]] };
for (const [plane, path] of Object.entries(bends)) {
  const across = plane === 'XY' ? 2 : 1;
  const tube = points(expandTubes([path], { radius: 1, radialSegments: 32 }));
  console.log(`tube with a bend in ${plane}: across the plane ${range(tube.map((p) => p[across]))}`);
  const ribbon = points(expandPaths([path], { lineWidth: 2, cornerRadius: 0 }));
  const start = ribbon.filter((p) => p[0] < 1);
  console.log(`ribbon with a bend in ${plane}: X ${range(ribbon.map((p) => p[0]))}, Y ${range(ribbon.map((p) => p[1]))}, Z ${
    range(ribbon.map((p) => p[2]))}, Y at its start ${range(start.map((p) => p[1]))}`);
}
JS
node check.cjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
tube to 10,0,0: distance to the axis 1.00 to 1.00
tube to 0,10,0: distance to the axis 1.00 to 1.00
tube to 6,8,0: distance to the axis 1.00 to 1.00
tube to 6,0,8: distance to the axis 1.00 to 1.00
tube to 1,0,10: distance to the axis 1.00 to 1.00
tube to 0,0,10: distance to the axis 0.00 to 0.00
tube with a bend in XY: across the plane -1.41 to 1.41
ribbon with a bend in XY: X 0.00 to 11.00, Y -1.00 to 10.00, Z 0.00 to 0.00, Y at its start -1.00 to 1.00
tube with a bend in XZ: across the plane -1.41 to 1.41
ribbon with a bend in XZ: X 0.00 to 10.00, Y -1.41 to 1.41, Z 0.00 to 10.00, Y at its start -1.00 to 1.00
EXPECTED
