#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @math.gl/culling and @math.gl/core 4.1.0.
# Input:    boxes of half sizes 2,1,0.5 and 1,2,3 that are moved by 10 in X, turned by 90 degrees about Z and scaled by 2 in X; the
#           corners of a box of half sizes 4,1,2, turned by 0 to 1.2 about Z; a symmetric matrix. Source: comments of the library
#           (transform: "Applies a 4x4 affine transformation matrix"; "Computes an instance of an OrientedBoundingBox of the given
#           positions"; computeEigenDecomposition: "unitary and diagonal matrices", whose product "is now equal to a").
# Expected: A movement keeps the half sizes, and a point outside remains outside. The minimum of a box is below its maximum. The
#           corners get the box of half sizes 4,1,2. The matrix 2,1,0 1,3,0 0,0,4 has the eigenvalues 1.382, 3.618 and 4.
# Seen:     The movement by 10 adds 10 to each half axis of an OrientedBoundingBox, so that its half sizes are 12,10.05,10.01, and
#           distances of points up to 10 away are 0. The half diagonal of an AxisAlignedBoundingBox becomes its centre; after a
#           turn, its minimum is above its maximum. The box of the turned corners is up to three times too large. The diagonal
#           matrix of the eigenvalues is not diagonal.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" @math.gl/culling@4.1.0 @math.gl/core@4.1.0 >/dev/null

cat >check.mjs <<'JS'
import { Matrix3, Matrix4, Quaternion, Vector3 } from '@math.gl/core';
import {
  AxisAlignedBoundingBox, computeEigenDecomposition, makeOrientedBoundingBoxFromPoints, OrientedBoundingBox } from '@math.gl/culling';
const text = (values) => [...values].map((v) => v.toFixed(2).replace(/^-(0\.0*)$/, '$1')).join(',');
const motions = {
  'not moved': new Matrix4(),
  'moved by 10': new Matrix4().translate([10, 0, 0]),
  'turned by 90 degrees': new Matrix4().rotateZ(Math.PI / 2),
  'scaled by 2': new Matrix4().scale([2, 1, 1]),
};
for (const [name, motion] of Object.entries(motions)) {
  const box = new OrientedBoundingBox([0, 0, 0], new Matrix3([2, 0, 0, 0, 1, 0, 0, 0, 0.5])).transform(motion);
  console.log(`oriented box, ${name}: centre ${text(box.center)}, half sizes ${text(box.halfSize)}, ` +
    `distance of 5 above the centre ${box.distanceTo([box.center[0], 5, 0]).toFixed(2)}`);
}
for (const [name, motion] of Object.entries(motions)) {
  const box = new AxisAlignedBoundingBox([0, 0, 0], [2, 4, 6]).transform(motion);
  console.log(`box, ${name}: ${text(box.minimum)} to ${text(box.maximum)}, centre ${text(box.center)}, half diagonal ${text(box.halfDiagonal)}`);
}
for (const angle of [0, 0.1, 0.5, 0.8, 1.2]) {
  const quaternion = new Quaternion().rotateZ(angle);
  const corners = [-4, 4].flatMap((x) => [-1, 1].flatMap((y) => [-2, 2].map(
    (z) => new Vector3(x, y, z).transformByQuaternion(quaternion).add([5, 6, 7]))));
  const [a, b, c] = [...makeOrientedBoundingBoxFromPoints(corners).halfSize].sort((p, q) => q - p);
  console.log(`corners turned by ${angle}: half sizes ${text([a, b, c])}, volume ${(8 * a * b * c).toFixed(1)} instead of 64.0`);
}
const { diagonal } = computeEigenDecomposition(new Matrix3([2, 1, 0, 1, 3, 0, 0, 0, 4]));
console.log(`diagonal matrix: ${text(diagonal)}`);
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
oriented box, not moved: centre 0.00,0.00,0.00, half sizes 2.00,1.00,0.50, distance of 5 above the centre 4.00
oriented box, moved by 10: centre 10.00,0.00,0.00, half sizes 12.00,10.05,10.01, distance of 5 above the centre 0.00
oriented box, turned by 90 degrees: centre 0.00,0.00,0.00, half sizes 2.00,1.00,0.50, distance of 5 above the centre 3.00
oriented box, scaled by 2: centre 0.00,0.00,0.00, half sizes 4.00,1.00,0.50, distance of 5 above the centre 4.00
box, not moved: 0.00,0.00,0.00 to 2.00,4.00,6.00, centre 1.00,2.00,3.00, half diagonal 1.00,2.00,3.00
box, moved by 10: 10.00,0.00,0.00 to 12.00,4.00,6.00, centre 11.00,2.00,3.00, half diagonal 11.00,2.00,3.00
box, turned by 90 degrees: 0.00,0.00,0.00 to -4.00,2.00,6.00, centre -2.00,1.00,3.00, half diagonal -2.00,1.00,3.00
box, scaled by 2: 0.00,0.00,0.00 to 4.00,4.00,6.00, centre 2.00,2.00,3.00, half diagonal 2.00,2.00,3.00
corners turned by 0: half sizes 4.00,2.00,1.00, volume 64.0 instead of 64.0
corners turned by 0.1: half sizes 3.71,3.33,2.00, volume 197.8 instead of 64.0
corners turned by 0.5: half sizes 4.11,2.25,2.00, volume 148.0 instead of 64.0
corners turned by 0.8: half sizes 3.66,3.40,2.00, volume 199.0 instead of 64.0
corners turned by 1.2: half sizes 4.01,2.75,2.00, volume 176.1 instead of 64.0
diagonal matrix: 1.58,0.63,0.00,0.63,3.42,0.00,0.00,0.00,4.00
EXPECTED
