#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @math.gl/core 4.1.0.
# Input:    Euler angles of one turn each and of 0.3, 0.4, 0.5; the vector 1,2,3; spherical coordinates and vectors along the axes.
#           Source: names of the methods of Euler (getRotationMatrix, getQuaternion, toQuaternion, fromQuaternion) and of
#           SphericalCoordinates (toVector3, fromVector3).
# Expected: The matrix and both quaternions turn the vector in the same way, and fromQuaternion returns the angles. fromVector3 is
#           the inverse of toVector3.
# Seen:     The quaternion of getQuaternion exchanges the turns about X and Z: 0.3 about X is 0.3 about Z. The matrix and
#           toQuaternion agree. Of the vectors, only those along X and along Z return from spherical coordinates; 0,1,0 becomes
#           0,0,1, and 3,0,4 becomes 3,-4,0. The angles do not return either: phi and theta are exchanged, and theta is supplemented
#           to 180 degrees.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" @math.gl/core@4.1.0 >/dev/null

cat >check.mjs <<'JS'
import { Euler, Matrix4, SphericalCoordinates, Vector3 } from '@math.gl/core';
const text = (values) => [...values].slice(0, 3).map((v) => v.toFixed(3).replace(/^-(0\.0*)$/, '$1')).join(',');
for (const angles of [[0.3, 0, 0], [0, 0.4, 0], [0, 0, 0.5], [0.3, 0.4, 0.5]]) {
  const euler = new Euler(...angles);
  const turned = (quaternion) => text(new Vector3(1, 2, 3).transformByQuaternion(quaternion));
  console.log(`angles ${angles}: by the matrix ${text(new Matrix4(euler.getRotationMatrix([])).transform([1, 2, 3]))}, ` +
    `by toQuaternion ${turned(euler.toQuaternion())}, by getQuaternion ${turned(euler.getQuaternion())}`);
  console.log(`  angles of toQuaternion ${text(new Euler().fromQuaternion(euler.toQuaternion()))}, ` +
    `of getQuaternion ${text(new Euler().fromQuaternion(euler.getQuaternion()))}`);
}
for (const vector of [[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [3, 0, 4], [1, 2, 3]]) {
  const spherical = new SphericalCoordinates().fromVector3(vector);
  console.log(`vector ${vector}: back ${text(spherical.toVector3())}`);
}
for (const [phi, theta] of [[0, 1], [0.3, 0.4], [1, 0.5]]) {
  const spherical = new SphericalCoordinates({ phi, theta, radius: 2 });
  const back = new SphericalCoordinates().fromVector3(spherical.toVector3());
  console.log(`phi ${phi}, theta ${theta}: back phi ${back.phi.toFixed(3)}, theta ${back.theta.toFixed(3)}, radius ${back.radius.toFixed(3)}`);
}
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
angles 0.3,0,0: by the matrix 1.000,1.024,3.457, by toQuaternion 1.000,1.024,3.457, by getQuaternion 0.364,2.206,3.000
  angles of toQuaternion 0.300,0.000,0.000, of getQuaternion 0.000,0.000,0.300
angles 0,0.4,0: by the matrix 2.089,2.000,2.374, by toQuaternion 2.089,2.000,2.374, by getQuaternion 2.089,2.000,2.374
  angles of toQuaternion 0.000,0.400,0.000, of getQuaternion 0.000,0.400,0.000
angles 0,0,0.5: by the matrix -0.081,2.235,3.000, by toQuaternion -0.081,2.235,3.000, by getQuaternion 1.000,0.317,3.592
  angles of toQuaternion 0.000,0.000,0.500, of getQuaternion 0.500,0.000,0.000
angles 0.3,0.4,0.5: by the matrix 1.499,1.986,2.795, by toQuaternion 1.499,1.986,2.795, by getQuaternion 2.122,0.988,2.919
  angles of toQuaternion 0.300,0.400,0.500, of getQuaternion 0.500,0.400,0.300
vector 1,0,0: back 1.000,0.000,0.000
vector 0,1,0: back 0.000,0.000,1.000
vector 0,0,1: back 0.000,0.000,1.000
vector -1,0,0: back -1.000,0.000,0.000
vector 3,0,4: back 3.000,-4.000,0.000
vector 1,2,3: back 1.000,-1.342,3.347
phi 0, theta 1: back phi 1.000, theta 3.142, radius 2.000
phi 0.3, theta 0.4: back phi 0.400, theta 2.842, radius 2.000
phi 1, theta 0.5: back phi 0.500, theta 2.142, radius 2.000
EXPECTED
