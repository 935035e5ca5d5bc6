#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: npm, @flatten-js/polygon-offset 1.1.4, which declares the peer range "^1.4.2" of @flatten-js/core;
#           here with @flatten-js/core 1.4.2, 1.4.8, 1.5.6 and 1.6.15.
# Input:    a square of 10 x 10, counter-clockwise and clockwise, offset by +1 and -1.
# Expected: All versions of the range: areas 100 + 40 + pi = 143.14 and 64, for both directions.
# Seen:     1.4.2 and 1.4.8: right for the clockwise square. Counter-clockwise: +1 gives 62.71 without an error,
#           -1 gives an empty polygon. 1.5.6 and 1.6.15: "edge.isSegment is not a function" for every polygon.
#           A plain npm install selects the newest version of the range.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

cat >check.js <<'JS'
const core = require('@flatten-js/core');
const offsetModule = require('@flatten-js/polygon-offset');
const flatten = core.default?.point ? core.default : core;
const offset = offsetModule.default || offsetModule;
const square = [[0, 0], [10, 0], [10, 10], [0, 10]];
for (const [name, points] of [['ccw', square], ['cw', [...square].reverse()]])
  for (const distance of [1, -1]) {
    let result;
    try {
      result = offset(new flatten.Polygon([points.map((p) => flatten.point(...p))]), distance).area().toFixed(2);
    } catch (error) {
      result = error.message;
    }
    console.log(`${process.argv[2]} ${name} ${distance}: ${result}`);
  }
JS
for version in 1.4.2 1.4.8 1.5.6 1.6.15; do
  mkdir "$version"
  cp check.js "$version"
  npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work/$version" \
    @flatten-js/polygon-offset@1.1.4 "@flatten-js/core@$version" >/dev/null
  node "$version/check.js" "$version"
done | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
1.4.2 ccw 1: 62.71
1.4.2 ccw -1: 0.00
1.4.2 cw 1: 143.14
1.4.2 cw -1: 64.00
1.4.8 ccw 1: 62.71
1.4.8 ccw -1: 0.00
1.4.8 cw 1: 143.14
1.4.8 cw -1: 64.00
1.5.6 ccw 1: edge.isSegment is not a function
1.5.6 ccw -1: edge.isSegment is not a function
1.5.6 cw 1: edge.isSegment is not a function
1.5.6 cw -1: edge.isSegment is not a function
1.6.15 ccw 1: edge.isSegment is not a function
1.6.15 ccw -1: edge.isSegment is not a function
1.6.15 cw 1: edge.isSegment is not a function
1.6.15 cw -1: edge.isSegment is not a function
EXPECTED
