#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, polygon-offset 0.3.2 with martinez-polygon-clipping 0.1.5.
# Input:    an L, a T, a U and a plus with arms of the width 10; margins of 4.99, 5 and 5.01, and paddings of the same distances; an
#           open path. Source: readme (margin is the offset outwards, padding inwards; offsetLine is the offset of a path).
# Expected: The area of the margin is a little larger for each larger distance, in one ring. The arrays of the caller do not change.
# Seen:     At 5, half of the width of the arms, the margin of the L has a second ring of 8.27 in the direction of a hole, and the
#           margin of the U two; the T is a ReferenceError. At 4.99 and 5.01, all margins are right. Paddings of 5 contain rings
#           without an area, and one of two rings of the U is larger than at 4.99. After the call, the array of a counter-clockwise
#           polygon or of a path is in the reverse order.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  polygon-offset@0.3.2 martinez-polygon-clipping@0.1.5 >/dev/null

cat >check.cjs <<'JS'
const Offset = require('polygon-offset');
const area = (ring) => ring.reduce((sum, p, i) => {
  const q = ring[(i + 1) % ring.length];
  return sum + (p[0] * q[1] - q[0] * p[1]) / 2;
}, 0);
const rings = (nested) => (typeof (nested[0] || [])[0] === 'number' ? [nested] : nested.flatMap(rings));
const shapes = {
  L: [[0, 0], [20, 0], [20, 10], [10, 10], [10, 20], [0, 20]],
  T: [[0, 0], [30, 0], [30, 10], [20, 10], [20, 30], [10, 30], [10, 10], [0, 10]],
  U: [[0, 0], [30, 0], [30, 20], [20, 20], [20, 10], [10, 10], [10, 20], [0, 20]],
  plus: [[10, 0], [20, 0], [20, 10], [30, 10], [30, 20], [20, 20], [20, 30], [10, 30], [10, 20], [0, 20], [0, 10], [10, 10]],
};
const lines = [];
const log = console.log;
console.log = () => {}; // The package writes messages about overlapping edges.
for (const method of ['margin', 'padding']) {
  for (const [name, corners] of Object.entries(shapes)) {
    const results = [4.99, 5, 5.01].map((distance) => {
      try {
        const closed = [...corners, corners[0]].map((p) => [...p]);
        return `${distance}: ${rings(new Offset().data(closed)[method](distance)).map((ring) => area(ring).toFixed(2)).join(' ')}`;
      } catch (error) {
        return `${distance}: ${error.name}`;
      }
    });
    lines.push(`${method} of the ${name}: ${results.join(', ')}`);
  }
}
const square = [[0, 0], [20, 0], [20, 20], [0, 20], [0, 0]];
const path = [[0, 0], [20, 0], [20, 20]];
new Offset().data(square).margin(1);
new Offset().data(path).offsetLine(1);
lines.push(`after the call: square ${square.join(' ')}, path ${path.join(' ')}`);
log(lines.join('\n'));
JS
node check.cjs 2>/dev/null | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
margin of the L: 4.99: -768.07, 5: -769.15 8.27, 5.01: -770.22
margin of the T: 4.99: -1161.52, 5: ReferenceError, 5.01: -1164.43
margin of the U: 4.99: -1161.52, 5: -1162.97 8.27 50.15, 5.01: -1164.33
margin of the plus: 4.99: -1149.23, 5: -1150.63 8.27, 5.01: -1152.04
padding of the L: 4.99: -6.55, 5: -6.17 0.00 0.00, 5.01: -6.00
padding of the T: 4.99: -13.09, 5: ReferenceError, 5.01: -12.09
padding of the U: 4.99: -13.09, 5: -6.17 0.00 11.21, 5.01: -6.00 6.00
padding of the plus: 4.99: -25.39, 5: -24.68 0.00 0.00, 5.01: -24.38
after the call: square 0,0 0,20 20,20 20,0 0,0, path 20,20 20,0 0,0
EXPECTED
