#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, kd-tree-javascript 1.0.3 (nearest points in a tree of two or three dimensions).
# Input:    500 trees of the points of a grid of 6 x 6, and 500 trees of 36 points without a pattern, in a random order; then one,
#           five or ten points are removed, and each point of the tree is asked for its nearest point. Source: the methods
#           remove(point) and nearest(point, count, maxDistance) of the package.
# Expected: The nearest point of a point of the tree is that point, at the distance 0. A removed point is not found.
# Seen:     Without removal, and with insert instead of the constructor, all answers are right. From a grid, one removed point of
#           four remains in the tree, without a message; after ten removals, 481 of 500 trees are wrong, and some lost points that
#           were not removed. The removal of points without equal coordinates is right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" kd-tree-javascript@1.0.3 >/dev/null

cat >check.cjs <<'JS'
const { kdTree } = require('kd-tree-javascript');
// Park and Miller's generator, so that the trees are the same everywhere.
let state = 1;
const random = () => (state = state * 16807 % 2147483647) / 2147483647;
const distance = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);
const shuffle = (points) => {
  for (let i = points.length - 1; i > 0; --i) {
    const j = Math.floor(random() * (i + 1));
    [points[i], points[j]] = [points[j], points[i]];
  }
  return points;
};
const sources = {
  grid: () => shuffle(Array.from({ length: 36 }, (_, i) => ({ x: i % 6, y: Math.floor(i / 6) }))),
  'no pattern': () => Array.from({ length: 36 }, () => ({ x: 6 * random(), y: 6 * random() })),
};
for (const [name, source] of Object.entries(sources)) {
  for (const [removed, inserted] of [[0, 0], [0, 30], [1, 0], [5, 0], [10, 0]]) {
    let [lost, kept, wrong] = [0, 0, 0];
    for (let tree = 0; tree < 500; ++tree) {
      const points = source();
      const index = new kdTree(points.slice(inserted), distance, ['x', 'y']);
      points.slice(0, inserted).forEach((point) => index.insert(point));
      points.slice(0, removed).forEach((point) => index.remove(point));
      const found = (point) => index.nearest(point, 1)[0][1] === 0;
      const l = points.slice(removed).filter((point) => !found(point)).length;
      const k = points.slice(0, removed).filter(found).length;
      [lost, kept, wrong] = [lost + l, kept + k, wrong + (l + k > 0)];
    }
    console.log(`${name}, ${inserted} inserted, ${removed} removed: ${wrong} of 500 trees are wrong; ` +
      `${lost} of ${500 * (36 - removed)} points are lost, ${kept} of ${500 * removed} removed points are found`);
  }
}
JS
node check.cjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
grid, 0 inserted, 0 removed: 0 of 500 trees are wrong; 0 of 18000 points are lost, 0 of 0 removed points are found
grid, 30 inserted, 0 removed: 0 of 500 trees are wrong; 0 of 18000 points are lost, 0 of 0 removed points are found
grid, 0 inserted, 1 removed: 133 of 500 trees are wrong; 0 of 17500 points are lost, 133 of 500 removed points are found
grid, 0 inserted, 5 removed: 387 of 500 trees are wrong; 3 of 15500 points are lost, 621 of 2500 removed points are found
grid, 0 inserted, 10 removed: 481 of 500 trees are wrong; 14 of 13000 points are lost, 1198 of 5000 removed points are found
no pattern, 0 inserted, 0 removed: 0 of 500 trees are wrong; 0 of 18000 points are lost, 0 of 0 removed points are found
no pattern, 30 inserted, 0 removed: 0 of 500 trees are wrong; 0 of 18000 points are lost, 0 of 0 removed points are found
no pattern, 0 inserted, 1 removed: 0 of 500 trees are wrong; 0 of 17500 points are lost, 0 of 500 removed points are found
no pattern, 0 inserted, 5 removed: 0 of 500 trees are wrong; 0 of 15500 points are lost, 0 of 2500 removed points are found
no pattern, 0 inserted, 10 removed: 0 of 500 trees are wrong; 0 of 13000 points are lost, 0 of 5000 removed points are found
EXPECTED
