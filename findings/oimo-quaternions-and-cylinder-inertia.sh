#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, oimo 1.0.9 (physics of rigid bodies).
# Input:    rotations by 0.5, 2 and 3 about X and about 1,2,3 as quaternion and as matrix; pairs of unit vectors; cylinders of the
#           height 4 and a box with the density 1. Source: names and comments of the library (Quat.setFromMat33 is the inverse of
#           Mat33.setQuat; setFromUnitVectors rotates its first vector to its second, as the method arc does; calculateMassInfo:
#           mass and inertia).
# Expected: A quaternion has length 1 and survives the conversion to a matrix and back. 1,0,0 is rotated to the second vector. The
#           moment of inertia of a cylinder about its axis is mass * radius^2 / 2, as in the plane of its ends mass * (radius^2 / 4
#           + height^2 / 12).
# Seen:     From the matrix comes a quaternion with the opposite axis and a wrong scalar part; its length is 0.36 to 0.96. If the
#           trace is negative (an angle above 120 degrees), setFromMat33 is a ReferenceError. setFromUnitVectors does nothing. The
#           moment about the axis of a cylinder omits the mass: 2 instead of 100.5 for the radius 2. The method arc, boxes and
#           Mat33.setQuat are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" oimo@1.0.9 >/dev/null

cat >check.cjs <<'JS'
const { Box, Cylinder, Mat33, Quat, ShapeConfig, Vec3 } = require('oimo');
const text = (...values) => values.map((v) => v.toFixed(3).replace(/^-(0\.0*)$/, '$1')).join(',');
const quaternion = (q) => `${text(q.x, q.y, q.z, q.w)} of length ${Math.hypot(q.x, q.y, q.z, q.w).toFixed(3)}`;
for (const axis of [[1, 0, 0], [1, 2, 3]]) {
  for (const angle of [0.5, 2, 3]) {
    const q = new Quat().setFromAxis(new Vec3(...axis).normalize(), angle);
    const matrix = new Mat33().setQuat(q);
    const [a, b] = [new Vec3(4, 5, 6).applyQuaternion(q), new Vec3(4, 5, 6).applyMatrix3(matrix, true)];
    let back;
    try {
      back = quaternion(new Quat().setFromMat33(matrix.elements));
    } catch (error) {
      back = error.name;
    }
    console.log(`${angle} about ${axis}: same rotation ${Math.hypot(a.x - b.x, a.y - b.y, a.z - b.z) < 1e-9}, ${quaternion(q)}; from its matrix ${back}`);
  }
}
for (const target of [[0, 1, 0], [0.6, 0, 0.8], [-1, 0, 0]]) {
  const ends = ['arc', 'setFromUnitVectors'].map((name) => {
    const v = new Vec3(1, 0, 0).applyQuaternion(new Quat()[name](new Vec3(1, 0, 0), new Vec3(...target)));
    return `${name} ${text(v.x, v.y, v.z)}`;
  });
  console.log(`1,0,0 to ${target}: ${ends.join(', ')}`);
}
const inertia = (name, shape) => {
  const info = { inertia: new Mat33() };
  shape.calculateMassInfo(info);
  console.log(`${name}: mass ${text(info.mass)}, inertia ${text(...[0, 4, 8].map((i) => info.inertia.elements[i]))}`);
};
const config = Object.assign(new ShapeConfig(), { density: 1 });
inertia('box of 1,2,3', new Box(config, 1, 2, 3));
for (const radius of [1, 2, 3]) {
  inertia(`cylinder of radius ${radius}`, new Cylinder(config, radius, 4));
  const mass = Math.PI * radius ** 2 * 4;
  const [across, along] = [mass * (radius ** 2 / 4 + 4 ** 2 / 12), mass * radius ** 2 / 2];
  console.log(`  expected: mass ${text(mass)}, inertia ${text(across, along, across)}`);
}
JS
node check.cjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
0.5 about 1,0,0: same rotation true, 0.247,0.000,0.000,0.969 of length 1.000; from its matrix -0.247,0.000,0.000,0.258 of length 0.357
2 about 1,0,0: same rotation true, 0.841,0.000,0.000,0.540 of length 1.000; from its matrix -0.841,0.000,0.000,0.463 of length 0.960
3 about 1,0,0: same rotation true, 0.997,0.000,0.000,0.071 of length 1.000; from its matrix ReferenceError
0.5 about 1,2,3: same rotation true, 0.066,0.132,0.198,0.969 of length 1.000; from its matrix -0.066,-0.132,-0.198,0.258 of length 0.357
2 about 1,2,3: same rotation true, 0.225,0.450,0.675,0.540 of length 1.000; from its matrix -0.225,-0.450,-0.675,0.463 of length 0.960
3 about 1,2,3: same rotation true, 0.267,0.533,0.800,0.071 of length 1.000; from its matrix ReferenceError
1,0,0 to 0,1,0: arc 0.000,1.000,0.000, setFromUnitVectors 1.000,0.000,0.000
1,0,0 to 0.6,0,0.8: arc 0.600,0.000,0.800, setFromUnitVectors 1.000,0.000,0.000
1,0,0 to -1,0,0: arc -1.000,0.000,0.000, setFromUnitVectors 1.000,0.000,0.000
box of 1,2,3: mass 6.000, inertia 6.500,5.000,2.500
cylinder of radius 1: mass 12.566, inertia 19.890,0.500,19.890
  expected: mass 12.566, inertia 19.897,6.283,19.897
cylinder of radius 2: mass 50.265, inertia 117.259,2.000,117.259
  expected: mass 50.265, inertia 117.286,100.531,117.286
cylinder of radius 3: mass 113.097, inertia 405.205,4.500,405.205
  expected: mass 113.097, inertia 405.265,508.938,405.265
EXPECTED
