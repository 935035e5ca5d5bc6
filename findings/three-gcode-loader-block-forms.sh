#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, three 0.187.0 (GCodeLoader).
# Input:    a square of 10 x 10 in different notations; a half circle (G2) between two lines.
# Expected: G01, line numbers, lower case and blocks without spaces have the meaning of "G1 X10 E1".
#           An unsupported arc at least ends at its end point, so the line after it starts at 20,0.
# Seen:     "N10 G1 …", "G01 …" and "G1X10E1" draw nothing. Lower case is right.
#           G2 is ignored together with its end point: the line after it goes from 10,0 to 10,5. No message appears
#           for the missing lines.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" three@0.187.0 >/dev/null

cat >check.mjs <<'JS'
import { GCodeLoader } from 'three/addons/loaders/GCodeLoader.js';
console.warn = () => {};
function show(...blocks) {
  const lines = [];
  new GCodeLoader().parse(blocks.join('\n')).traverse((part) => {
    if (!part.isLineSegments) return;
    const points = Array.from(part.geometry.attributes.position.array);
    for (let i = 0; i < points.length; i += 6)
      lines.push(`${points.slice(i, i + 2)} -> ${points.slice(i + 3, i + 5)}`);
  });
  console.log(`${blocks.join(' | ')}: ${lines.join('; ') || 'nothing'}`);
}
show('G1 X10 E1', 'G1 Y10 E2');
show('g1 x10 e1', 'g1 y10 e2');
show('G01 X10 E1', 'G01 Y10 E2');
show('G1X10E1', 'G1Y10E2');
show('N10 G1 X10 E1', 'N20 G1 Y10 E2');
show('G1 X10 E1', 'G2 X20 Y0 I5 J0 E2', 'G1 Y5 E3');
JS
node check.mjs 2>/dev/null | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
G1 X10 E1 | G1 Y10 E2: 0,0 -> 10,0; 10,0 -> 10,10
g1 x10 e1 | g1 y10 e2: 0,0 -> 10,0; 10,0 -> 10,10
G01 X10 E1 | G01 Y10 E2: nothing
G1X10E1 | G1Y10E2: nothing
N10 G1 X10 E1 | N20 G1 Y10 E2: nothing
G1 X10 E1 | G2 X20 Y0 I5 J0 E2 | G1 Y5 E3: 0,0 -> 10,0; 10,0 -> 10,5
EXPECTED
