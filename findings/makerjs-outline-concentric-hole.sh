#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, makerjs 0.19.2 (model.outline).
# Input:    a square of 10 x 10 with a square hole of 4 x 4; outline by 1, rounded corners.
# Expected: The outline outside of the material has two loops: the grown square (40 + 2 pi = 46.283) and the shrunk
#           hole (8). The outline inside has two loops: 32 and 22.283. The position of the hole has no influence.
# Seen:     With an off-centre hole the result is right. With a concentric hole, the outline outside has only
#           the loop of the hole; the grown square is missing. The outline inside has a third loop: the grown square.
#           With a concentric circular hole the result is right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" makerjs@0.19.2 >/dev/null

cat >check.js <<'JS'
const makerjs = require('makerjs');
const square = () => new makerjs.models.Rectangle(10, 10);
const frame = (x, y) => ({
  models: { square: square(), hole: makerjs.model.move(new makerjs.models.Rectangle(4, 4), [x, y]) },
});
const plate = () => ({ models: { square: square() }, paths: { hole: new makerjs.paths.Circle([5, 5], 2) } });
function loops(model, inside) {
  const chains = makerjs.model.findChains(makerjs.model.outline(model, 1, 0, inside));
  return chains.map((chain) => chain.pathLength.toFixed(3)).join(' ');
}
for (const [name, make] of [
  ['hole at 2.3,3.7', () => frame(2.3, 3.7)],
  ['concentric hole', () => frame(3, 3)],
  ['concentric circle', plate],
]) console.log(`${name}: outside ${loops(make(), false)}; inside ${loops(make(), true)}`);
JS
node check.js | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
hole at 2.3,3.7: outside 46.283 8.000; inside 32.000 22.283
concentric hole: outside 8.000; inside 46.283 32.000 22.283
concentric circle: outside 46.283 6.283; inside 32.000 18.850
EXPECTED
