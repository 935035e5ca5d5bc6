#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, linuxcnc-uspace 2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 (Python module rs274.author, the
#           writer of G-code for image-to-gcode and for user scripts).
# Input:    Gcode.cut for the corners of a square of 10 x 10 at Z-1, then Gcode.flush. Tolerance 0.01.
# Expected: The closed square has four cutting moves. The documentation of `douglas` promises that the simplified
#           path is never farther than the tolerance from the input path.
# Seen:     If the last point is equal to the first point, the complete contour is missing: only the move to
#           the first point remains. With a last point that is 0.000001 off, all four moves are there.
#           A flat-topped closed path that goes up and down again (X and Z) is also missing.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Extracts pinned Debian 12 packages into ./root, without installation.
fetch() {
  mkdir -p deb root
  (cd deb && apt-get download "$@" >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch linuxcnc-uspace=2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2
cp -r root/usr/lib/python3/dist-packages/rs274 .

cat >check.py <<'PY'
from rs274.author import Gcode


def show(name, points, plane=None):
    blocks = []
    program = Gcode(units="G21", tolerance=0.01, target=blocks.append)
    if plane:
        program.set_plane(plane)
    for point in points:
        program.cut(*point)
    program.flush()
    print(f"{name}: {' | '.join(block.strip() for block in blocks)}")


square = [(0, 0, -1), (10, 0, -1), (10, 10, -1), (0, 10, -1)]
show("open", square)
show("almost closed", square + [(0, 1e-6, -1)])
show("closed", square + [(0, 0, -1)])
show("closed, G17", square + [(0, 0, -1)], 17)
show("over a ridge and back", [(0, 0, -3), (10, 0, -3), (10, 0, 2), (0, 0, 2), (0, 0, -3)], 18)
PY
PYTHONPATH=$work /usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
open: G1 X0.0000 Y0.0000 Z-1.0000 | X10.0000 | Y10.0000 | X0.0000
almost closed: G1 X0.0000 Y0.0000 Z-1.0000 | X10.0000 | Y10.0000 | X0.0000 | Y0.0000
closed: G1 X0.0000 Y0.0000 Z-1.0000
closed, G17: G17 | G1 X0.0000 Y0.0000 Z-1.0000
over a ridge and back: G18 | G1 X0.0000 Y0.0000 Z-3.0000
EXPECTED
