#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @itwin/core-geometry 5.13.3 with @itwin/core-bentley 5.13.3 (CAD kernel of iTwin.js).
# Input:    a square of 10 x 10, swept by 5 up and down; the square with a hole of 6 x 6 as ParityRegion, both loops
#           counter-clockwise or the hole clockwise; a capped cylinder of radius 5 and height 10 with different angle
#           tolerances; a capped ring, turned by 90 and 360 degrees. Source: LinearSweep.create sets no condition for
#           the direction, and ParityRegion ("in" an odd number of loops) none for the loops; capped cones are closed
#           solids.
# Expected: Closed meshes. The volumes are 500 and 320, about 785 for the cylinder, about 188 and 753 for the ring.
# Seen:     Downwards, the caps point outwards and the sides inwards: open, -166.67. Two loops of the same direction:
#           560. If a circle has more than 64 chords, the caps of a cylinder still have 64: gaps of 4 times the
#           circumference. With 360 degrees, both caps of the ring remain inside. RotationalSweep is right for both
#           directions.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @itwin/core-geometry@5.13.3 @itwin/core-bentley@5.13.3 >/dev/null

cat >check.cjs <<'JS'
const { Angle, Cone, LinearSweep, LineString3d, Loop, ParityRegion, Point3d, PolyfaceBuilder, PolyfaceQuery, Ray3d,
  RotationalSweep, StrokeOptions, Vector3d } = require('@itwin/core-geometry');
const at = (x, y, z = 0) => Point3d.create(x, y, z);
const square = (x, y, size, clockwise = false) => {
  const points = [at(x, y), at(x + size, y), at(x + size, y + size), at(x, y + size), at(x, y)];
  return Loop.create(LineString3d.create(clockwise ? points.reverse() : points));
};
const show = (name, solid, degrees) => {
  const options = StrokeOptions.createForFacets();
  if (degrees) options.angleTol = Angle.createDegrees(degrees);
  const builder = PolyfaceBuilder.create(options);
  builder.addGeometryQuery(solid);
  const mesh = builder.claimPolyface();
  const edges = PolyfaceQuery.boundaryEdges(mesh);
  const closed = PolyfaceQuery.isPolyfaceClosedByEdgePairing(mesh);
  const open = edges ? edges.children.reduce((sum, edge) => sum + edge.curveLength(), 0) : 0;
  const volume = PolyfaceQuery.sumTetrahedralVolumes(mesh);
  console.log(`${name}: closed ${closed}, boundary ${open.toFixed(1)}, volume ${volume.toFixed(2)}`);
};
const up = Vector3d.create(0, 0, 5);
const down = Vector3d.create(0, 0, -5);
show('square up', LinearSweep.create(square(0, 0, 10), up, true));
show('square down', LinearSweep.create(square(0, 0, 10), down, true));
show('hole clockwise', LinearSweep.create(ParityRegion.create(square(0, 0, 10), square(2, 2, 6, true)), up, true));
show('hole counter-clockwise', LinearSweep.create(ParityRegion.create(square(0, 0, 10), square(2, 2, 6)), up, true));
for (const degrees of [10, 6, 5, 2]) {
  show(`cylinder, ${degrees} degrees`, Cone.createAxisPoints(at(0, 0, 0), at(0, 0, 10), 5, 5, true), degrees);
}
const profile = () => Loop.create(LineString3d.create(at(5, 0), at(7, 0), at(7, 10), at(5, 10), at(5, 0)));
const axis = () => Ray3d.create(at(0, 0), Vector3d.unitY());
for (const angle of [90, -90, 360]) {
  show(`ring, ${angle} degrees`, RotationalSweep.create(profile(), axis(), Angle.createDegrees(angle), true), 5);
}
JS
node check.cjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
square up: closed true, boundary 0.0, volume 500.00
square down: closed false, boundary 80.0, volume -166.67
hole clockwise: closed true, boundary 0.0, volume 320.00
hole counter-clockwise: closed false, boundary 48.0, volume 560.00
cylinder, 10 degrees: closed true, boundary 0.0, volume 781.42
cylinder, 6 degrees: closed true, boundary 0.0, volume 783.96
cylinder, 5 degrees: closed false, boundary 125.6, volume 784.31
cylinder, 2 degrees: closed false, boundary 125.6, volume 784.64
ring, 90 degrees: closed true, boundary 0.0, volume 188.26
ring, -90 degrees: closed true, boundary 0.0, volume 188.26
ring, 360 degrees: closed false, boundary 34.2, volume 753.03
EXPECTED
