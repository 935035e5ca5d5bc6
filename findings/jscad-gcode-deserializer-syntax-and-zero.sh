#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @jscad/gcode-deserializer 0.2.1 (G-code of 3D printers to a program of JSCAD).
# Input:    a frame of four extruded lines in two layers, around 110,110; the same frame with its first corner at 0,0; with a
#           comment that contains a word; with an end directly after its last extrusion. Source: readme ("converts raw gcode data to
#           jscad code (that can be evaluated to CSG/CAG)"); coordinates of the result are shifted by -100, the centre of the bed of
#           the library.
# Expected: The program can be parsed. Both layers are closed frames of five points at z 0.3 and 0.6. A comment changes nothing.
# Seen:     No program can be parsed, because the bracket of its list is not closed. The layers have the heights 0.6 and 10 of the
#           moves after them; the first line of the first one is missing. Points with X 0 or Y 0 are missing, so the frames at 0,0
#           become one point twice. The comment "; fast to X900" moves a point to X 800. The last layer is missing if no block
#           without extrusion follows.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" @jscad/gcode-deserializer@0.2.1 >/dev/null

cat >check.cjs <<'JS'
const { deserialize } = require('@jscad/gcode-deserializer');
const frame = (from, z, start) => [
  `G1 Z${z} F600`, `G1 X${from} Y${from}`, `G1 X130 Y${from} E${start + 1}`, `G1 X130 Y130 E${start + 2}`,
  `G1 X${from} Y130 E${start + 3}`, `G1 X${from} Y${from} E${start + 4}`];
const program = (from, end) => ['G90', 'M82', 'G92 E0', ...frame(from, 0.3, 0), ...frame(from, 0.6, 4), ...end];
const end = ['G1 Z10 F600', 'G1 X150 Y150'];
const cases = {
  'frame at 110,110': program(110, end),
  'frame at 0,0': program(0, end),
  'with a comment': program(110, end).map((line) => line.replace('G1 X110 Y110 E4', 'G1 X110 Y110 E4 ; fast to X900')),
  'end after the last extrusion': program(110, []),
};
for (const [name, lines] of Object.entries(cases)) {
  const text = deserialize(lines.join('\n'), 'frame.gcode', { addMetaData: false });
  let parsed = 'parsed';
  try {
    new Function(text);
  } catch (error) {
    parsed = `${error.name}: ${error.message}`;
  }
  console.log(`${name}: ${parsed}`);
  for (const [, points, z] of text.matchAll(/EX\(\[(.*)\],\{.*translate\(\[0,0,(.*)\]\)/g))
    console.log(`  z ${z}: ${points}`);
}
JS
node check.cjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
frame at 110,110: SyntaxError: Unexpected token '}'
  z 0.6: [30,10], [30,30], [10,30], [10,10]
  z 10: [10,10], [30,10], [30,30], [10,30], [10,10]
frame at 0,0: SyntaxError: Unexpected token '}'
  z 10: [30,30], [30,30]
with a comment: SyntaxError: Unexpected token '}'
  z 0.6: [30,10], [30,30], [10,30], [800,10]
  z 10: [10,10], [30,10], [30,30], [10,30], [10,10]
end after the last extrusion: SyntaxError: Unexpected token '}'
  z 0.6: [30,10], [30,30], [10,30], [10,10]
EXPECTED
