#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, math3d 0.2.2 (vectors, quaternions and transforms with parents, with the conventions of Unity).
# Input:    a base, an arm at 10,0,0 and a tip at 20,0,0, each the child of the one before; Euler angles with x = 90 and x =
#           -90; 1000 rotations and their angle to themselves. Source: README of the package (localRotation: "Rotation in local
#           coordinate system", eulerAngles, angleTo).
# Expected: A tip follows its arm, as it follows its base. The Euler angles of a rotation give the same rotation again, at x =
#           90, too, where a sum or a difference of y and z is free. The angle of a rotation to itself is 0.
# Seen:     localRotation and localPosition leave the children in place: the arm turns and moves, and the tip stays at 0,20,0
#           instead of -10,5,0, until the position of the arm is assigned to itself. At x = 90 and -90, y and z are read as 0:
#           the angles 90,30,20 become 90,0,0. The angle of a rotation to itself is NaN for hundreds of 1000 rotations.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" math3d@0.2.2 >/dev/null

cat >check.cjs <<'JS'
const { Vector3, Quaternion, Transform } = require('math3d');
const text = (v) => [v.x, v.y, v.z].map((c) => (Math.abs(c) < 5e-3 ? 0 : c).toFixed(2)).join();

const [base, arm, tip] = [0, 10, 20].map((x) => new Transform(new Vector3(x, 0, 0)));
arm.parent = base;
tip.parent = arm;
const show = (name) =>
  console.log(`${name}: arm ${text(arm.position)}, tip ${text(tip.position)}, origin of the tip by the arm ${
    text(arm.transformPosition(tip.localPosition))}`);
show('start');
base.localRotation = Quaternion.Euler(0, 0, 90);
show('base turned by localRotation');
base.rotation = Quaternion.Euler(0, 0, 90);
show('base turned by rotation');
arm.localRotation = Quaternion.Euler(0, 0, 90);
show('arm turned by localRotation');
arm.localPosition = new Vector3(5, 0, 0);
show('arm moved by localPosition');
arm.position = arm.position;
show('position of the arm assigned to itself');

for (const angles of [[20, 30, 40], [89.9, 30, 20], [90, 30, 0], [90, 30, 20], [-90, 45, 10]]) {
  const turn = Quaternion.Euler(...angles);
  const { x, y, z } = turn.eulerAngles;
  const [point, again] = [turn, Quaternion.Euler(x, y, z)].map((q) => q.mulVector3(new Vector3(1, 2, 3)));
  console.log(`angles ${angles}: read as ${text({ x, y, z })}, 1,2,3 at ${text(point)}, again ${text(again)}`);
}
const turns = [...Array(1000).keys()].map((i) => Quaternion.Euler(i, 2 * i, 3 * i));
console.log(`angle to itself is NaN: ${turns.filter((turn) => Number.isNaN(turn.angleTo(turn))).length > 100 ? 'more' : 'less'} than 100 of 1000`);
JS
node check.cjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
start: arm 10.00,0.00,0.00, tip 20.00,0.00,0.00, origin of the tip by the arm 20.00,0.00,0.00
base turned by localRotation: arm 10.00,0.00,0.00, tip 20.00,0.00,0.00, origin of the tip by the arm 20.00,0.00,0.00
base turned by rotation: arm 0.00,10.00,0.00, tip 0.00,20.00,0.00, origin of the tip by the arm 0.00,20.00,0.00
arm turned by localRotation: arm 0.00,10.00,0.00, tip 0.00,20.00,0.00, origin of the tip by the arm -10.00,10.00,0.00
arm moved by localPosition: arm 0.00,5.00,0.00, tip 0.00,20.00,0.00, origin of the tip by the arm -10.00,5.00,0.00
position of the arm assigned to itself: arm 0.00,5.00,0.00, tip -10.00,5.00,0.00, origin of the tip by the arm -10.00,5.00,0.00
angles 20,30,40: read as 20.00,30.00,40.00, 1,2,3 at 1.33,1.02,3.35, again 1.33,1.02,3.35
angles 89.9,30,20: read as 89.90,30.00,20.00, 1,2,3 at 1.33,-3.00,1.80, again 1.33,-3.00,1.80
angles 90,30,0: read as 90.00,0.00,0.00, 1,2,3 at 1.87,-3.00,1.23, again 1.00,-3.00,2.00
angles 90,30,20: read as 90.00,0.00,0.00, 1,2,3 at 1.33,-3.00,1.80, again 1.00,-3.00,2.00
angles -90,45,10: read as -90.00,0.00,0.00, 1,2,3 at -1.06,3.00,-1.97, again 1.00,3.00,-2.00
angle to itself is NaN: more than 100 of 1000
EXPECTED
