#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, kicad 6.0.11+dfsg-1 (dxf2idf, which "takes line, arc, and circle segments from a DXF file").
# Input:    DXF outlines in mm: a rectangle of LINE, a CIRCLE, and a quarter disc of two LINE and an ARC of 0 to 90
#           degrees (DXF reference, ARC: groups 50 and 51 are degrees). Two orders of the
#           entities: the ARC is the second or the first.
# Expected: IDF 3.0, outline records: x, y and the included angle in degrees. The quarter disc has the points 5,0 and
#           0,5 with the angle 90 and returns to 0,0.
# Seen:     The angle is 5156.62 = 90 x 57.2958, the end point is -2.240,4.470, and both lines are missing. dxf2idf
#           converts degrees as if the file had radians. Exit status 0, no message. Lines and circles are right.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# dxf2idf needs no dependency of kicad.
mkdir deb
(cd deb && apt-get download kicad=6.0.11+dfsg-1 >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
dpkg --fsys-tarfile deb/kicad_*.deb | tar -x ./usr/bin/dxf2idf

line() { printf '0\nLINE\n8\n0\n10\n%s\n20\n%s\n11\n%s\n21\n%s\n' "$@"; }
arc() { printf '0\nARC\n8\n0\n10\n%s\n20\n%s\n40\n%s\n50\n%s\n51\n%s\n' "$@"; }
circle() { printf '0\nCIRCLE\n8\n0\n10\n%s\n20\n%s\n40\n%s\n' "$@"; }
show() {
  echo "$1:"
  {
    printf '0\nSECTION\n2\nENTITIES\n'
    cat
    printf '0\nENDSEC\n0\nEOF\n'
  } >in.dxf
  # The answers: DXF file, unit, geometry name, part name, height, end of comments, IDF file.
  printf '%s\n' in.dxf mm GEO PART 2.5 '' out.idf | timeout 60 usr/bin/dxf2idf >log 2>&1 || echo "exit status $?"
  sed -n '/^\./d; /^"/d; p' out.idf
}
{
  { line 0 0 20 0; line 20 0 20 10; line 20 10 0 10; line 0 10 0 0; } | show 'rectangle'
  circle 5 6 4 | show 'circle'
  { line 0 0 5 0; arc 0 0 5 0 90; line 0 5 0 0; } | show 'quarter disc, line first'
  { arc 0 0 5 0 90; line 0 5 0 0; line 0 0 5 0; } | show 'quarter disc, arc first'
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
rectangle:
0 0.000 0.000 0
0 20.000 0.000 0
0 20.00000 10.00000 0
0 0.00000 10.00000 0
0 0.00000 0.00000 0
circle:
0 5.000 6.000 0
0 9.000 6.000 360
quarter disc, line first:
0 5.000 0.000 0
0 -2.240 4.470 5156.62
0 5.00000 0.00000 0
quarter disc, arc first:
0 5.000 0.000 0
0 -2.240 4.470 5156.62
0 5.00000 0.00000 0
EXPECTED
