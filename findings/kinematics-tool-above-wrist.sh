#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, kinematics 1.0.2 (forward and inverse kinematics of robots with six axes).
# Input:    a robot of the links 1,1,0 0,10,0 5,0,0 3,0,0 0,b,0 with the tool below (b = -3) and above the wrist (b = 3); four
#           sets of joint angles. Source: comments and errors of the package ("geo[4] = [0,b,0]"; forward and inverse: x, y, z
#           and three Euler angles; calculateTCP: calculates the position of the tool).
# Expected: inverse(forward(angles)) gives joint angles with the same place and the same direction of the tool, because the
#           poses are within reach by construction. calculateTCP returns the pose.
# Seen:     With the tool below the wrist, all is right. With the tool above, which the constructor accepts, the joint angles of
#           inverse put the end at the right place with the tool in the opposite direction, or are NaN: only the length of the
#           last link enters the inverse, not its sign. calculateTCP is a TypeError for each robot.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" kinematics@1.0.2 >/dev/null

cat >check.cjs <<'JS'
const Kinematics = require('kinematics').default;

const text = (values) => values.map((v) => (Math.abs(v) < 5e-3 ? 0 : v).toFixed(2)).join();
const tool = (joints) => [0, 1, 2].map((i) => (joints[5][i] - joints[4][i]) / 3);
const sets = [[0, 0, 0, 0, 0, 0], [0.3, 0.2, 0.1, 0.4, 0.5, 0.6], [0, -0.4, -0.3, 0, 0, 0], [1, 0.5, 0.3, 0.2, -0.3, 0.4]];
for (const b of [-3, 3]) {
  const robot = new Kinematics([[1, 1, 0], [0, 10, 0], [5, 0, 0], [3, 0, 0], [0, b, 0]]);
  console.log(`tool ${b < 0 ? 'below' : 'above'} the wrist:`);
  for (const angles of sets) {
    const before = robot.forward(...angles);
    const after = robot.forward(...robot.inverse(...before[5]));
    console.log(`  angles ${angles}: end ${text(before[5].slice(0, 3))}, tool ${text(tool(before))}; again end ${
      text(after[5].slice(0, 3))}, tool ${text(tool(after))}`);
  }
}
const robot = new Kinematics([[1, 1, 0], [0, 10, 0], [5, 0, 0], [3, 0, 0], [0, -3, 0]]);
try {
  const pose = [];
  robot.calculateTCP(0, 0, 0, 0, 0, 0, pose);
  console.log(`calculateTCP: ${text(pose)}`);
} catch (error) {
  console.log(`calculateTCP: ${error.message}`);
}
JS
node check.cjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
tool below the wrist:
  angles 0,0,0,0,0,0: end 9.00,8.00,0.00, tool 0.00,-1.00,0.00; again end 9.00,8.00,0.00, tool 0.00,-1.00,0.00
  angles 0.3,0.2,0.1,0.4,0.5,0.6: end 8.05,11.27,-3.56, tool 0.56,-0.63,-0.53; again end 8.05,11.27,-3.56, tool 0.56,-0.63,-0.53
  angles 0,-0.4,-0.3,0,0,0: end 9.08,2.76,0.00, tool -0.64,-0.76,0.00; again end 9.08,2.76,0.00, tool -0.64,-0.76,0.00
  angles 1,0.5,0.3,0.2,-0.3,0.4: end 1.24,12.92,-2.98, tool 0.09,-0.86,-0.49; again end 1.24,12.92,-2.98, tool 0.09,-0.86,-0.49
tool above the wrist:
  angles 0,0,0,0,0,0: end 9.00,14.00,0.00, tool 0.00,1.00,0.00; again end 9.00,14.00,0.00, tool 0.00,-1.00,0.00
  angles 0.3,0.2,0.1,0.4,0.5,0.6: end 4.66,15.06,-0.37, tool -0.56,0.63,0.53; again end 4.66,15.06,-0.37, tool 0.56,-0.63,-0.53
  angles 0,-0.4,-0.3,0,0,0: end 12.95,7.35,0.00, tool 0.64,0.76,0.00; again end 12.95,7.35,0.00, tool -0.64,-0.76,0.00
  angles 1,0.5,0.3,0.2,-0.3,0.4: end 0.69,18.11,-0.01, tool -0.09,0.86,0.49; again end NaN,NaN,NaN, tool NaN,NaN,NaN
calculateTCP: this.calculateCoordinates is not a function
EXPECTED
