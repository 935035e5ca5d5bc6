#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, octave-matgeom 1.2.3-3 with octave 7.3.0-2.
# Input:    a box of 10 x 20 (x 30) and its copy, moved by 0.1,0.2(,0.3); triangles; parallel lines with distance 5.
# Expected: registerICP and registerPoints3dAffine map the box onto its copy: the matrix is this translation.
#           enclosingCircle contains all points; of the triangle 0,0 10,0 5,8 it is the circumcircle 5,2.4375 r 5.5625.
#           distanceLines3d returns 5.
# Seen:     Both registrations compute each step in the opposite direction: after one step the corners have twice the
#           distance, after 10 steps more than 10 mm. The circle of an acute and of an obtuse triangle leaves a corner
#           outside. Parallel lines have the distance 0. A single fit, a rectangle and skew lines are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Extracts Debian 12 packages into ./root, without installation: all that this machine has not installed.
fetch() {
  mkdir -p deb root
  apt-get install -s --no-install-recommends "$@" 2>log | sed -n 's/^Inst \([^ ]*\) .*(\([^ ]*\) .*/\1=\2/p' >list
  [ -s list ] || cat log >&2
  (cd deb && xargs apt-get download <../list >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch octave-matgeom=1.2.3-3 octave=7.3.0-2
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH HOME=$work OCTAVE_HOME=$work/root/usr OCTAVE_EXEC_HOME=$work/root/usr

cat >check.m <<'M'
warning("off", "all");
addpath(genpath("root/usr/share/octave/packages/matgeom-1.2.3"));

function show(name, points, copy)
  distance = max(sqrt(sum((points - copy) .^ 2, 2)));
  if distance > 10
    printf("%s: more than 10 apart\n", name);
  else
    printf("%s: corners within %.1f\n", name, distance);
  end
end

function circle(name, points)
  c = enclosingCircle(points);
  outside = max(hypot(points(:, 1) - c(1), points(:, 2) - c(2))) - c(3);
  printf("circle of the %s: %.4f,%.4f r %.4f, farthest corner %.3f outside\n", name, c, max(0, outside));
end

flat = [0 0; 10 0; 10 20; 0 20];
flat_copy = flat + [0.1 0.2];
show("2-D, single fit", transformPoint(flat, fitAffineTransform2d(flat_copy, flat)), flat_copy);
for steps = [1 10]
  [~, moved] = registerICP(flat, flat_copy, steps);
  show(sprintf("2-D, registration, steps: %d", steps), moved, flat_copy);
end
box = [flat zeros(4, 1); flat 30 * ones(4, 1)];
box_copy = box + [0.1 0.2 0.3];
show("3-D, single fit", transformPoint3d(box, fitAffineTransform3d(box_copy, box)), box_copy);
for steps = [1 10]
  [~, moved] = registerPoints3dAffine(box, box_copy, steps);
  show(sprintf("3-D, registration, steps: %d", steps), moved, box_copy);
end

circle("rectangle", [0 0; 10 0; 10 1; 0 1]);
circle("acute triangle", [0 0; 10 0; 5 8]);
circle("obtuse triangle", [0 0; 10 0; 5 1]);

printf("skew lines: %.1f\n", distanceLines3d([0 0 0 1 0 0], [0 0 5 0 1 0]));
printf("parallel lines: %.1f\n", distanceLines3d([0 0 0 0 0 1], [3 4 0 0 0 1]));
exit(0);
M
(root/usr/bin/octave-cli --no-init-file --no-gui check.m 2>/dev/null || true) | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
2-D, single fit: corners within 0.0
2-D, registration, steps: 1: corners within 0.4
2-D, registration, steps: 10: more than 10 apart
3-D, single fit: corners within 0.0
3-D, registration, steps: 1: corners within 0.7
3-D, registration, steps: 10: more than 10 apart
circle of the rectangle: 5.0000,0.5000 r 5.0249, farthest corner 0.000 outside
circle of the acute triangle: 7.5000,4.0000 r 4.7170, farthest corner 3.783 outside
circle of the obtuse triangle: 7.5000,0.5000 r 2.5495, farthest corner 4.967 outside
skew lines: 5.0
parallel lines: 0.0
EXPECTED
