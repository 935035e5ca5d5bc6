#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, gcode-toolpath 3.0.0 with gcode-interpreter 3.0.0 and gcode-parser 2.2.0.
# Input:    blocks in the usual order of Fanuc posts: axis words after G54, a drilling cycle with two more holes.
# Expected: Word order in a block has no meaning: "G0 G90 G54 X10 Y5" moves to X10 Y5.
#           An unsupported G81 is ignored together with its repetitions.
# Seen:     The axis words belong to the last G or M word alone. "G90 G0 X10 Y5" moves; "G0 G90 X10 Y5" and
#           "G0 G90 G54 X10 Y5" give a move from 0,0 to 0,0. "G1 X1 G20 Y1" loses the unit and Y;
#           "G1 X5 F100 M8 Y3" loses Y3. The blocks after the ignored G81 become feed moves at Z-4, the depth before it.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  gcode-toolpath@3.0.0 gcode-interpreter@3.0.0 gcode-parser@2.2.0 >/dev/null

cat >check.js <<'JS'
const module_ = require('gcode-toolpath');
const Toolpath = module_.default || module_;
const point = (p) => `${p.x},${p.y},${p.z}`;
function moves(program) {
  const seen = [];
  new Toolpath({
    addLine: (modal, from, to) => seen.push(`${modal.motion} ${point(from)} -> ${point(to)}`),
    addArcCurve: (modal, from, to) => seen.push(`${modal.motion} ${point(from)} -> ${point(to)}`),
  }).loadFromStringSync(program.join('\n'));
  return seen.join('; ');
}
for (const program of [
  ['G90 G0 X10 Y5'],
  ['G0 G90 X10 Y5'],
  ['G0 G90 G54 X10 Y5'],
  ['G1 X1 G20 Y1'],
  ['G1 X5 F100 M8 Y3'],
  ['G1 X2 Y3 Z-4 F100', 'G81 X5 Y5 Z-3 R1', 'X20', 'X30 Y15', 'G80'],
]) console.log(`${program.join(' | ')}: ${moves(program)}`);
JS
node check.js | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
G90 G0 X10 Y5: G0 0,0,0 -> 10,5,0
G0 G90 X10 Y5: G0 0,0,0 -> 0,0,0
G0 G90 G54 X10 Y5: G0 0,0,0 -> 0,0,0
G1 X1 G20 Y1: G1 0,0,0 -> 1,0,0
G1 X5 F100 M8 Y3: G1 0,0,0 -> 5,0,0
G1 X2 Y3 Z-4 F100 | G81 X5 Y5 Z-3 R1 | X20 | X30 Y15 | G80: G1 0,0,0 -> 2,3,-4; G1 2,3,-4 -> 20,3,-4; G1 20,3,-4 -> 30,15,-4
EXPECTED
