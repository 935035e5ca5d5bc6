#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, python3-pymap3d 2.9.1-1; python3-geographiclib 2.0-2 for the true geodesics. Python 3.11.
# Input:    pairs of points on the same parallel; rhumb lines across the 180th meridian; pairs of almost opposite points. Source: docstrings
#           (loxodrome_inverse: "the arc length and azimuth of the loxodrome between two points", "like Matlab distance('rh',...)";
#           departure: "the distance along a specific parallel between two meridians"; vdist: "WGS-84 distance between points
#           within a few millimeters", with the warning "precision may be reduced slightly" for opposite points).
# Expected: 10 degrees of the equator are 1113195 m in both directions, as Matlab's distance returns. A rhumb line takes the short
#           way across the 180th meridian. The azimuth of vdist is a direction of the shortest line.
# Seen:     To the east, 10 degrees have the length of 170, 18924313 m; to the west, 10. Half of the equator has the length 0. The end of
#           loxodrome_direct over 500 km is 9544 km away. From 179 to -179 degrees, the line goes around the Earth, 28141 km
#           instead of 1123. From 0,0 to 0.5,179.5, vdist has the azimuth 0 instead of 25.7, and its distance is 35 m too
#           long; from 0,0 to 0,180, its distance is 33.6 km too short.

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
fetch python3-pymap3d=2.9.1-1 python3-geographiclib=2.0-2
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries:$libraries/lapack:$libraries/blas PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
import logging

from geographiclib.geodesic import Geodesic
from pymap3d.lox import departure, loxodrome_direct, loxodrome_inverse
from pymap3d.vincenty import vdist

logging.disable()


def text(result):
    return f"{result[0]:.0f} m, azimuth {result[1] % 360:.1f}"


for pair in [(0, 0, 0, 10), (0, 10, 0, 0), (0, -90, 0, 90), (60, 355, 60, 350), (60, 350, 60, 355)]:
    print("rhumb line", pair, text(loxodrome_inverse(*pair)))
# The length of the parallel is linear in the longitude.
degree = departure(1, 0, 60), departure(0, 1, 60)
print(f"one degree at latitude 60: {degree[0]:.0f} m to one side, {degree[1]:.0f} m to the other")
end = loxodrome_direct(60, 0, 500e3, 90)
print(f"500 km due east from 60,0: {end[0]:.3f},{end[1]:.3f}, back", text(loxodrome_inverse(60, 0, *map(float, end))))
for pair in [(40, 179, 50, -179), (40, 179, 50, 181)]:
    print("rhumb line", pair, text(loxodrome_inverse(*pair)))
for pair in [(10, 20, 30, 60), (0, 0, 0.5, 179.5), (0, 0, 0, 180)]:
    true = Geodesic.WGS84.Inverse(*pair)
    print("geodesic", pair, text(vdist(*pair)) + ", true", text((true["s12"], true["azi1"])))
PY
PYTHONWARNINGS=ignore /usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
rhumb line (0, 0, 0, 10) 18924313 m, azimuth 90.0
rhumb line (0, 10, 0, 0) 1113195 m, azimuth 270.0
rhumb line (0, -90, 0, 90) 0 m, azimuth 90.0
rhumb line (60, 355, 60, 350) 279000 m, azimuth 270.0
rhumb line (60, 350, 60, 355) 9765000 m, azimuth 90.0
one degree at latitude 60: 9988200 m to one side, 55800 m to the other
500 km due east from 60,0: 60.000,8.961, back 9544000 m, azimuth 90.0
rhumb line (40, 179, 50, -179) 28140790 m, azimuth 272.3
rhumb line (40, 179, 50, 181) 1122366 m, azimuth 8.0
geodesic (10, 20, 30, 60) 4699570 m, azimuth 56.0, true 4699570 m, azimuth 56.0
geodesic (0, 0, 0.5, 179.5) 19936324 m, azimuth 0.0, true 19936289 m, azimuth 25.7
geodesic (0, 0, 0, 180) 19970326 m, azimuth 90.0, true 20003931 m, azimuth 0.0
EXPECTED
