#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, p2-es 1.2.3 (2D physics of rigid bodies; hit tests and rays).
# Input:    bodies at 5,5 with a box of 2 x 8 at the local position 3,0, turned by 0, 30, 90 and 180 degrees; two boxes of
#           different areas; vertical rays at a circle and at a slot of length 10 and radius 2. Source: documentation of
#           Body.adjustCenterOfMass ("Moves the shape offsets so their center of mass becomes the body center of mass").
# Expected: The shapes keep their place in the world and only the origin of the body moves, so the bounding box remains. A ray
#           that touches a circle hits its side, at y 0, or misses; a ray through a slot hits its top at y 2.
# Seen:     adjustCenterOfMass adds the local offset to the position without the angle of the body: at 90 degrees the box jumps
#           from 1,7 to 4,4, at 180 degrees by 6 in X; only the angle 0 is right. A ray that is tangent to the end circle of a
#           slot, at x 3 and -3, hits at its own start, 20 instead of 2, with the normal -0.10,1; at 2.9 and 3.1 the hit is
#           right, and a circle alone is not hit by its tangent.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" p2-es@1.2.3 >/dev/null

cat >check.mjs <<'JS'
import { Body, Box, Capsule, Circle, Ray, RaycastResult, World } from 'p2-es';

const text = (values) => [...values].map((v) => (Math.abs(v) < 5e-3 ? 0 : v).toFixed(2)).join();
const bounds = (body) => {
  const { lowerBound, upperBound } = body.getAABB();
  return `${text(lowerBound)} to ${text(upperBound)}`;
};
const boxes = { 'one box': [[2, 8, 3]], 'two boxes': [[2, 8, 3], [4, 4, -4]] };
for (const [name, list] of Object.entries(boxes))
  for (const degrees of [0, 30, 90, 180]) {
    const body = new Body({ mass: 1, position: [5, 5], angle: degrees * Math.PI / 180 });
    for (const [width, height, x] of list)
      body.addShape(new Box({ width, height }), [x, 0]);
    const before = bounds(body);
    body.adjustCenterOfMass();
    body.aabbNeedsUpdate = true;
    console.log(`${name}, ${degrees} degrees: bounds ${before}, after adjustCenterOfMass ${bounds(body)}`);
  }

const shoot = (shape, x) => {
  const world = new World();
  const body = new Body();
  body.addShape(shape);
  world.addBody(body);
  const ray = new Ray({ from: [x, 20], to: [x, -20], mode: Ray.CLOSEST });
  const [result, point] = [new RaycastResult(), [0, 0]];
  world.raycast(result, ray);
  if (!result.hasHit())
    return 'no hit';
  result.getHitPoint(point, ray);
  return `${text(point)}, normal ${text(result.normal)}`;
};
for (const x of [0, 1.5, 2, 2.5])
  console.log(`ray at x ${x} to the circle: ${shoot(new Circle({ radius: 2 }), x)}`);
for (const x of [0, 2.9, 3, 3.1, -3, 6])
  console.log(`ray at x ${x} to the slot: ${shoot(new Capsule({ length: 10, radius: 2 }), x)}`);
JS
node check.mjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
one box, 0 degrees: bounds 7.00,1.00 to 9.00,9.00, after adjustCenterOfMass 7.00,1.00 to 9.00,9.00
one box, 30 degrees: bounds 4.73,2.54 to 10.46,10.46, after adjustCenterOfMass 5.13,1.04 to 10.87,8.96
one box, 90 degrees: bounds 1.00,7.00 to 9.00,9.00, after adjustCenterOfMass 4.00,4.00 to 12.00,6.00
one box, 180 degrees: bounds 1.00,1.00 to 3.00,9.00, after adjustCenterOfMass 7.00,1.00 to 9.00,9.00
two boxes, 0 degrees: bounds -1.00,1.00 to 9.00,9.00, after adjustCenterOfMass -1.00,1.00 to 9.00,9.00
two boxes, 30 degrees: bounds -1.20,0.27 to 10.46,10.46, after adjustCenterOfMass -1.26,0.52 to 10.40,10.71
two boxes, 90 degrees: bounds 1.00,-1.00 to 9.00,9.00, after adjustCenterOfMass 0.50,-0.50 to 8.50,9.50
two boxes, 180 degrees: bounds 1.00,1.00 to 11.00,9.00, after adjustCenterOfMass 0.00,1.00 to 10.00,9.00
ray at x 0 to the circle: 0.00,2.00, normal 0.00,1.00
ray at x 1.5 to the circle: 1.50,1.32, normal 0.75,0.66
ray at x 2 to the circle: no hit
ray at x 2.5 to the circle: no hit
ray at x 0 to the slot: 0.00,2.00, normal 0.00,1.00
ray at x 2.9 to the slot: 2.90,2.00, normal 0.00,1.00
ray at x 3 to the slot: 3.00,20.00, normal -0.10,1.00
ray at x 3.1 to the slot: 3.10,2.00, normal 0.00,1.00
ray at x -3 to the slot: -3.00,20.00, normal 0.10,1.00
ray at x 6 to the slot: 6.00,1.73, normal 0.50,0.87
EXPECTED
