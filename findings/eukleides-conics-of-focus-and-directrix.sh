#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, eukleides 1.5.4-5 (language for plane geometry).
# Input:    conics of the focus 0,0 with a vertical directrix at x 4 (directions 90 and -90 degrees) and at x -4, and with the
#           eccentricities 0.5, 1 and 2; conics of the foci 0,0 and 8,0; bisectors of two lines through 0,0. Source: manual
#           ("conic(A, l, x): Conic of focus A, directrix l and eccentricity x"; "conic(A, B, x): Conic of foci A and B and
#           eccentricity x").
# Expected: For each point of the conic, the distance to the focus divided by the distance to the directrix is the eccentricity. The
#           ellipse of 0.5 has its vertices at x 1.33 and -4. The second conic has the foci 0,0 and 8,0, so its major axis is 4 / x:
#           8 for 0.5 and 2 for 2. The line of 350 degrees is the line of -10 degrees.
# Seen:     If the directrix at x 4 has the direction 90, the ellipse and the hyperbola lie on the wrong side of the focus: the
#           ellipse touches its directrix at 4,0. With the direction -90, they are right. The parabola is right with both. The conic
#           of two foci has the foci -4,0 and 12,0, and x is its major axis instead of its eccentricity: 0.5 gives a hyperbola. The
#           bisector of lines of 10 and -10 degrees has 0 degrees, of 10 and 350 degrees -90.

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
fetch eukleides=1.5.4-5

# The degree sign of the language is one byte, 0xB0.
degree=$(printf '\260')
show_conic() { # coordinate of the directrix, its direction, eccentricity
  cat <<EUK
l = line(point($1, 0), $2 $degree)
c = conic(F, l, $3)
P = point(c, 60 $degree)
Q = point(c, 90 $degree)
R = point(c, 150 $degree)
print "directrix at x $1, direction $2, eccentricity $3: ratios ", distance(P, F) / max(distance(P, l), 0.0001), " ", \
distance(Q, F) / max(distance(Q, l), 0.0001), " ", distance(R, F) / max(distance(R, l), 0.0001)
EUK
}
{
  echo 'F = point(0, 0)'
  for eccentricity in 0.5 1 2; do
    for directrix in '4 90' '4 -90' '-4 90' '-4 -90'; do
      show_conic $directrix "$eccentricity"
    done
  done
  cat <<EUK
c = conic(F, line(point(4, 0), 90 $degree), 0.5)
print "ellipse: vertices", point(c, 0 $degree), point(c, 180 $degree)
c = conic(F, line(point(4, 0), -90 $degree), 0.5)
print "ellipse, opposite direction: vertices", point(c, 0 $degree), point(c, 180 $degree)
c = conic(F, point(8, 0), 0.5)
print "foci 0,0 and 8,0, eccentricity 0.5: foci", foci(c), ", major axis ", major(c), ", eccentricity ", eccentricity(c)
c = conic(F, point(8, 0), 2)
print "foci 0,0 and 8,0, eccentricity 2: foci", foci(c), ", major axis ", major(c), ", eccentricity ", eccentricity(c)
a = bisector(line(F, 10 $degree), line(F, -10 $degree))
b = bisector(line(F, 10 $degree), line(F, 350 $degree))
print "bisectors: ", arg(a), " and ", arg(b)
EUK
} | sed -e ':a' -e '/\\$/N; s/\\\n//; ta' >check.euk
root/usr/bin/eukleides check.euk 2>&1 | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
directrix at x 4, direction 90, eccentricity 0.5: ratios 0.5 1 10.6962
directrix at x 4, direction -90, eccentricity 0.5: ratios 0.5 0.5 0.5
directrix at x -4, direction 90, eccentricity 0.5: ratios 0.5 0.5 0.5
directrix at x -4, direction -90, eccentricity 0.5: ratios 0.5 1 10.6962
directrix at x 4, direction 90, eccentricity 1: ratios 1 1 1
directrix at x 4, direction -90, eccentricity 1: ratios 1 1 1
directrix at x -4, direction 90, eccentricity 1: ratios 1 1 1
directrix at x -4, direction -90, eccentricity 1: ratios 1 1 1
directrix at x 4, direction 90, eccentricity 2: ratios 0.71098 0.666667 0.909091
directrix at x 4, direction -90, eccentricity 2: ratios 2 2 2
directrix at x -4, direction 90, eccentricity 2: ratios 2 2 2
directrix at x -4, direction -90, eccentricity 2: ratios 0.71098 0.666667 0.909091
ellipse: vertices-1.3333  0.0000 4.0000 -0.0000
ellipse, opposite direction: vertices-4.0000  0.0000 1.3333 -0.0000
foci 0,0 and 8,0, eccentricity 0.5: foci12.0000  0.0000 -4.0000  0.0000, major axis 0.5, eccentricity 16
foci 0,0 and 8,0, eccentricity 2: foci12.0000  0.0000 -4.0000  0.0000, major axis 2, eccentricity 4
bisectors: 0 and -90
EXPECTED
