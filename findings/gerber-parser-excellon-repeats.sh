#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, gerber-parser 4.2.7 (filetype drill).
# Input:    Excellon: a hole at 1,1 repeated by R3X2 (three more holes, 2 apart); a pattern of two holes (M25 … M01)
#           that is repeated at an offset of 10,0 (M02X10Y0, M08); an incremental hole (G91).
# Expected: R3X2 gives holes at 3,1 5,1 7,1. The pattern gives holes at 11,1 and 12,1.
#           An unsupported code gives a warning.
# Seen:     R3X2 gives one hole at 2,1, and M02X10Y0 gives one hole at 10,0: positions where the file has no hole.
#           G91 is ignored: the second hole is at 2,0, not 3,1.
#           No warning appears.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" gerber-parser@4.2.7 >/dev/null

cat >check.js <<'JS'
const gerberParser = require('gerber-parser');
const header = ['M48', 'METRIC,TZ', 'T1C1.000', '%', 'G90', 'G05', 'T1'];
const programs = {
  repeat: ['X1.0Y1.0', 'R3X2.0', 'M30'],
  pattern: ['M25', 'X1.0Y1.0', 'X2.0Y1.0', 'M01', 'M02X10.0Y0', 'M08', 'M30'],
  incremental: ['X1.0Y1.0', 'G91', 'X2.0Y0.0', 'M30'],
};
for (const [name, lines] of Object.entries(programs)) {
  const parser = gerberParser({ filetype: 'drill' });
  const holes = [];
  const at = {};
  const warnings = [];
  parser.on('data', (node) => {
    if (node.op !== 'flash') return;
    Object.assign(at, node.coord);
    holes.push(`${at.x},${at.y}`);
  });
  parser.on('warning', (warning) => warnings.push(warning.message));
  parser.on('end', () => console.log(`${name}: holes ${holes.join(' ')}; ${warnings.length} warnings`));
  parser.end([...header, ...lines, ''].join('\n'));
}
JS
node check.js | sort | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
incremental: holes 1,1 2,0; 0 warnings
pattern: holes 1,1 2,1 10,0; 0 warnings
repeat: holes 1,1 2,1; 0 warnings
EXPECTED
