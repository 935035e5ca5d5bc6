#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, cannon-es 0.20.0 (physics of rigid bodies).
# Input:    boxes of half extents 1,2,3 and 10,20,30 as Box, as the convex polyhedron of the Box, and as triangles, also moved by
#           10; cylinders of 64 sides and a torus; all with the mass 12. Source: comments of the library (volume: "Get the volume of
#           this shape", "Get approximate convex volume"; calculateLocalInertia: "Calculates the inertia in the local frame for this
#           shape").
# Expected: The volume is that of the box, 48 and 48000, or an approximation that grows by 1000, too, and does not depend on the
#           position. The moments of inertia are those of the shape, or of its bounding box as an approximation: 52,40,20 for the
#           small box.
# Seen:     The volume of polyhedra, cylinders and triangles is 4/3 * pi * R, where R is the radius of a sphere about the origin,
#           without its third power: 15.67 and 156.73 for the boxes, 48.49 after the move, 50.27 instead of 789.57 for the torus.
#           The moments of inertia are four times those of the bounding box: 208,160,80; a cylinder of height 4 has 80,32,80 instead
#           of 19,6,19.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" cannon-es@0.20.0 >/dev/null

cat >check.mjs <<'JS'
import { Box, ConvexPolyhedron, Cylinder, Trimesh, Vec3 } from 'cannon-es';
const show = (name, shape) => {
  const inertia = new Vec3();
  shape.calculateLocalInertia(12, inertia);
  console.log(`${name}: volume ${shape.volume().toFixed(2)}, inertia ${inertia.toArray().map((v) => v.toFixed(2))}`);
};
const polyhedron = (box, shift) => {
  const { vertices, faces } = box.convexPolyhedronRepresentation;
  return new ConvexPolyhedron({ vertices: vertices.map((v) => new Vec3(v.x + shift, v.y, v.z)), faces });
};
const triangles = (box, shift) => {
  const { vertices, faces } = polyhedron(box, shift);
  return new Trimesh(
    vertices.flatMap((v) => v.toArray()),
    faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]));
};
for (const extents of [[1, 2, 3], [10, 20, 30]]) {
  const box = new Box(new Vec3(...extents));
  show(`box ${extents}`, box);
  show('  polyhedron', polyhedron(box, 0));
  show('  polyhedron, moved', polyhedron(box, 10));
  show('  triangles', triangles(box, 0));
  show('  triangles, moved', triangles(box, 10));
}
for (const height of [1, 4]) {
  show(`cylinder of radius 1 and height ${height}`, new Cylinder(1, 1, height, 64));
  const [volume, across] = [32 * Math.sin(Math.PI / 32) * height, 12 * (1 / 4 + height ** 2 / 12)];
  console.log(`  expected: volume ${volume.toFixed(2)}, inertia ${[across, 6, across].map((v) => v.toFixed(2))}`);
}
show('torus of radius 10 and 2', Trimesh.createTorus(10, 2, 64, 128));
console.log(`  expected: volume ${(2 * Math.PI ** 2 * 10 * 4).toFixed(2)}`);
JS
node check.mjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
box 1,2,3: volume 48.00, inertia 52.00,40.00,20.00
  polyhedron: volume 15.67, inertia 208.00,160.00,80.00
  polyhedron, moved: volume 48.49, inertia 208.00,160.00,80.00
  triangles: volume 15.67, inertia 208.00,160.00,80.00
  triangles, moved: volume 48.49, inertia 208.00,160.00,80.00
box 10,20,30: volume 48000.00, inertia 5200.00,4000.00,2000.00
  polyhedron: volume 156.73, inertia 20800.00,16000.00,8000.00
  polyhedron, moved: volume 172.71, inertia 20800.00,16000.00,8000.00
  triangles: volume 156.73, inertia 20800.00,16000.00,8000.00
  triangles, moved: volume 172.71, inertia 20800.00,16000.00,8000.00
cylinder of radius 1 and height 1: volume 4.68, inertia 20.00,32.00,20.00
  expected: volume 3.14, inertia 4.00,6.00,4.00
cylinder of radius 1 and height 4: volume 9.37, inertia 80.00,32.00,80.00
  expected: volume 12.55, inertia 19.00,6.00,19.00
torus of radius 10 and 2: volume 50.27, inertia 2368.00,2368.00,4608.00
  expected: volume 789.57
EXPECTED
