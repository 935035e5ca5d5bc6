#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @vertexvis/geometry 1.1.0 (matrices, quaternions and Euler angles of a viewer for CAD models).
# Input:    a quaternion for 90 degrees about Z, as a matrix from makeRotation and from makeTRS without movement and scale; Euler
#           angles 0.3, 0.5, 0.7; the point 1,0,0. Source: the types of the package: makeRotation ("Creates a rotation matrix",
#           with its entries), transformMatrix ("m written in column-major form"), makeTRS, rotateAboutAxis, fromRotationMatrix.
# Expected: Both matrices are equal and take 1,0,0 to 0,1,0, as rotateAboutAxis does. The quaternion and the Euler angles of the
#           matrix are those of the input.
# Seen:     makeRotation takes 1,0,0 to 0,-1,0: its matrix is transposed and turns clockwise. The quaternion of this matrix is the
#           inverse; the Euler angles are -0.556, -0.161, -0.823. A hole at 10,0 of a part that is turned and moved by 100 is at
#           100,-10 instead of 100,10. makeTRS, rotateAboutAxis and the products of quaternions are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @vertexvis/geometry@1.1.0 >/dev/null

cat >check.mjs <<'JS'
import { Euler, Matrix4, Quaternion, Vector3 } from '@vertexvis/geometry';
const show = (...numbers) => numbers.map((n) => Math.round(n * 1000) / 1000 + 0).join(',');
const at = (p) => show(p.x, p.y, p.z);
const origin = Vector3.origin();
const one = Vector3.create(1, 1, 1);
const x = Vector3.create(1, 0, 0);
const z = Vector3.create(0, 0, 1);
const quarter = Quaternion.fromAxisAngle(z, Math.PI / 2);
console.log(`quaternion: ${show(quarter.x, quarter.y, quarter.z, quarter.w)}`);
console.log(`rotateAboutAxis: 1,0,0 to ${at(Vector3.rotateAboutAxis(Math.PI / 2, x, z, origin))}`);
const matrices = { makeRotation: Matrix4.makeRotation(quarter), makeTRS: Matrix4.makeTRS(origin, quarter, one) };
for (const [name, matrix] of Object.entries(matrices)) {
  const back = Quaternion.fromMatrixRotation(matrix);
  console.log(`${name}: 1,0,0 to ${at(Vector3.transformMatrix(x, matrix))}, quaternion ${show(back.x, back.y, back.z, back.w)}`);
  const moved = Matrix4.multiply(matrix, Matrix4.makeTranslation(Vector3.create(100, 0, 0)));
  console.log(`  turned and moved by 100: 10,0,0 to ${at(Vector3.transformMatrix(Vector3.create(10, 0, 0), moved))}`);
}
for (const order of ['xyz', 'zyx']) {
  const q = Quaternion.fromEuler(Euler.create({ x: 0.3, y: 0.5, z: 0.7, order }));
  const angles = [Matrix4.makeRotation(q), Matrix4.makeTRS(origin, q, one)].map((m) => at(Euler.fromRotationMatrix(m, order)));
  console.log(`Euler angles 0.3,0.5,0.7 ${order}: of makeRotation ${angles[0]}, of makeTRS ${angles[1]}`);
}
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
quaternion: 0,0,0.707,0.707
rotateAboutAxis: 1,0,0 to 0,1,0
makeRotation: 1,0,0 to 0,-1,0, quaternion 0,0,-0.707,0.707
  turned and moved by 100: 10,0,0 to 100,-10,0
makeTRS: 1,0,0 to 0,1,0, quaternion 0,0,0.707,0.707
  turned and moved by 100: 10,0,0 to 100,10,0
Euler angles 0.3,0.5,0.7 xyz: of makeRotation -0.556,-0.161,-0.823, of makeTRS 0.3,0.5,0.7
Euler angles 0.3,0.5,0.7 zyx: of makeRotation 0.082,-0.571,-0.647, of makeTRS 0.3,0.5,0.7
EXPECTED
