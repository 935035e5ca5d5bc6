#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, sylvester 0.0.21 (vectors, lines and planes).
# Input:    two planes; the segment from 0,0,5 to 10,0,5 with segments, lines and planes; the corners of a square, of a star and of
#           a gear in a plane, counter-clockwise. Source: comments of the library (Plane.intersectionWith: "The result will be a
#           vector if a line is supplied, and a line if a plane is supplied"; Line.Segment.distanceFrom: "the distance between the
#           argument and the line segment's closest point to the argument"; Plane.fromPoints: "Returns the plane containing the
#           given points. If the points are not coplanar, returns null"; the points "form an anticlockwise list").
# Expected: The planes x = 1 and z = 0 intersect in a line. Parallel segments that are 3 apart have the distance 3, as parallel
#           lines have, and the distance from a plane is the same in both directions. All normals are 0,0,1.
# Seen:     The intersection of two planes is a TypeError, bisectingPlane a ReferenceError. The distance of a segment from a
#           parallel segment, line or plane is null; of the plane from the segment it is NaN. The plane of a star with five tips is
#           null, as if it was not flat; the normal of the gear points downwards, because it has more reflex than convex corners.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" sylvester@0.0.21 >/dev/null

cat >check.cjs <<'JS'
const { Line, Plane } = require('sylvester');
const show = (name, compute) => {
  let text;
  try {
    const result = compute();
    text = result && result.elements ? result.elements.map((v) => +v.toFixed(3)).join(',') : `${result}`;
  } catch (error) {
    text = `${error.name}: ${error.message}`;
  }
  console.log(`${name}: ${text}`);
};
const segment = Line.Segment.create([0, 0, 5], [10, 0, 5]);
const upright = Plane.create([1, 0, 0], [1, 0, 0]);
show('planes, intersects', () => Plane.XY.intersects(upright));
show('planes, intersectionWith', () => Plane.XY.intersectionWith(upright).direction);
show('bisecting plane', () => segment.bisectingPlane().normal);
show('crossing segment', () => segment.distanceFrom(Line.Segment.create([5, 3, 0], [5, 3, 9])));
show('parallel segment', () => segment.distanceFrom(Line.Segment.create([0, 3, 5], [10, 3, 5])));
show('segment ahead', () => segment.distanceFrom(Line.Segment.create([13, 0, 5], [20, 0, 5])));
show('parallel line', () => segment.distanceFrom(Line.create([0, 3, 5], [1, 0, 0])));
show('parallel lines', () => Line.X.distanceFrom(Line.create([0, 3, 0], [1, 0, 0])));
show('parallel plane', () => segment.distanceFrom(Plane.XY));
show('from the plane to the segment', () => Plane.XY.distanceFrom(segment));
show('from the plane to its line', () => Plane.XY.distanceFrom(segment.line));
const ring = (radii) =>
  radii.map((r, i) => [r * Math.cos(2 * Math.PI * i / radii.length), r * Math.sin(2 * Math.PI * i / radii.length), 0]);
const shapes = {
  square: [10, 10, 10, 10],
  'star with five tips': Array.from({ length: 10 }, (_, i) => i % 2 ? 4 : 10),
  // Each tooth has two convex corners at its tip and four reflex corners at the round root.
  'gear with eight teeth': Array.from({ length: 64 }, (_, i) => [10, 10, 7, 6.5, 6.3, 6.3, 6.5, 7][i % 8]),
};
for (const [name, radii] of Object.entries(shapes))
  show(`plane of a ${name}`, () => { const plane = Plane.fromPoints(ring(radii)); return plane && plane.normal; });
JS
node check.cjs 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
planes, intersects: true
planes, intersectionWith: TypeError: Line.create is not a function
bisecting plane: ReferenceError: Plane is not defined
crossing segment: 3.0000000000000013
parallel segment: null
segment ahead: null
parallel line: null
parallel lines: 3
parallel plane: null
from the plane to the segment: NaN
from the plane to its line: 5
plane of a square: 0,0,1
plane of a star with five tips: null
plane of a gear with eight teeth: 0,0,-1
EXPECTED
