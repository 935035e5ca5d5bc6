#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, circuit-json-to-gerber 0.0.122 with circuit-json 0.0.542, @tscircuit/circuit-json-util 0.0.128,
#           @tscircuit/math-utils 0.0.36, format-si-unit 0.0.14 and zod 3.24.2 (writer); gerber-parser 4.2.7 (reader).
# Input:    a board with slots of 2 x 1, 3 x 1.5 and 3 x 1.5 turned by 30 degrees, and a round hole. Source: Excellon,
#           slot command "X#Y#G85X#Y#", one block; readme.md of gerber-parser ("set mode", "int").
# Expected: Each slot is one block, and the reader returns a move and an interpolation from end to end.
# Seen:     The slot is written as two blocks: the start, which is a hole, and a block "G85X#Y#" without a start. The
#           reader returns two round holes for each slot, without a warning; connectors with flat tabs do not fit.
#           With the line break removed, it returns slots.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --legacy-peer-deps --prefix "$work" \
  circuit-json-to-gerber@0.0.122 circuit-json@0.0.542 @tscircuit/circuit-json-util@0.0.128 \
  @tscircuit/math-utils@0.0.36 format-si-unit@0.0.14 zod@3.24.2 gerber-parser@4.2.7 >/dev/null

cat >check.mjs <<'JS'
import { convertCircuitJsonToGerberFiles } from 'circuit-json-to-gerber';
import gerberParser from 'gerber-parser';
const layers = ['top', 'bottom'];
const files = convertCircuitJsonToGerberFiles([
  { type: 'pcb_board', pcb_board_id: 'board', center: { x: 0, y: 0 }, width: 40, height: 30, thickness: 1.6, num_layers: 2,
    material: 'fr4' },
  { type: 'pcb_plated_hole', pcb_plated_hole_id: 'round', shape: 'circle', x: 0, y: 5, hole_diameter: 1, outer_diameter: 2,
    layers },
  { type: 'pcb_plated_hole', pcb_plated_hole_id: 'slot', shape: 'pill', x: 0, y: -5, hole_width: 2, hole_height: 1,
    outer_width: 3, outer_height: 2, ccw_rotation: 0, layers },
  { type: 'pcb_hole', pcb_hole_id: 'pill', hole_shape: 'pill', x: -15, y: 10, hole_width: 3, hole_height: 1.5 },
  { type: 'pcb_hole', pcb_hole_id: 'turned', hole_shape: 'rotated_pill', x: -15, y: -8, hole_width: 3, hole_height: 1.5,
    ccw_rotation: 30 },
]);
const read = (text) => gerberParser({ filetype: 'drill', places: [3, 3], zero: 'L' }).parseSync(text)
  .filter((c) => c.type === 'op').map((c) => `${c.op} ${c.coord.x},${c.coord.y}`).join(', ');
for (const name of Object.keys(files).filter((name) => name.endsWith('.drl'))) {
  const blocks = files[name].split('\n').filter((line) => /^(G85)?X/.test(line));
  console.log(`${name}: ${blocks.join(' | ')}`);
  console.log(`  reader: ${read(files[name])}`);
  console.log(`  one block: ${read(files[name].replace(/\nG85/g, 'G85'))}`);
}
JS
node check.mjs 2>log | grep -v 'NOT IMPLEMENTED' | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
drill-L1-L2.drl: X0.0000Y5.0000 | X-0.5000Y-5.0000 | G85X0.500Y-5.000
  reader: flash 0,5, flash -0.5,-5, flash 0.5,-5
  one block: flash 0,5, move -0.5,-5, int 0.5,-5
drill_npth.drl: X-15.7500Y10.0000 | G85X-14.250Y10.000 | X-15.6495Y-8.3750 | G85X-14.350Y-7.625
  reader: flash -15.75,10, flash -14.25,10, flash -15.6495,-8.375, flash -14.35,-7.625
  one block: move -15.75,10, int -14.25,10, move -15.6495,-8.375, int -14.35,-7.625
EXPECTED
