#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @tracespace/parser 5.0.0-next.0 (the version of the tag "latest").
# Input:    an Excellon file with two holes. The header ends with "%", as KiCad writes it, or with M95.
# Expected: Both ends of the header have the same meaning: the tree has the tool change, two holes and the end.
# Seen:     After M95 the tree is complete. After "%" all blocks are missing: no tool, no hole, and done is false.
#           No error is raised. A Gerber file with "%" is right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" @tracespace/parser@5.0.0-next.0 >/dev/null

cat >check.js <<'JS'
const { createParser } = require('@tracespace/parser');
const body = ['G90', 'G05', 'T1', 'X1.0Y1.0', 'X2.0Y2.0', 'T0', 'M30', ''];
const files = {
  'M95': ['M48', 'METRIC,TZ', 'T1C1.000', 'M95', ...body],
  '%': ['M48', 'METRIC,TZ', 'T1C1.000', '%', ...body],
  'Gerber': ['%FSLAX46Y46*%', '%MOMM*%', '%ADD10C,1*%', 'D10*', 'X1000000Y1000000D03*', 'M02*', ''],
};
for (const [name, lines] of Object.entries(files)) {
  const parser = createParser();
  parser.feed(lines.join('\n'));
  const tree = parser.results();
  console.log(`${name}: ${tree.children.map((node) => node.type).join(' ')}; done ${tree.done}`);
}
JS
node check.js | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
M95: units coordinateFormat toolDefinition interpolateMode toolChange graphic graphic toolChange done; done true
%: units coordinateFormat toolDefinition; done false
Gerber: coordinateFormat units toolDefinition toolChange graphic done; done true
EXPECTED
