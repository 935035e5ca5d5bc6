#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libmath-vector-real-perl 0.18-3 (vectors in Perl).
# Input:    pairs of line segments in the plane and in space, each in both directions; points near the square from 0,0 to
#           10,10. Source: POD of Math::Vector::Real (dist2_between_segments: "Returns the square of the distance between the line
#           segment defined by the vertices $a0 and $a1 and the one defined by the vertices $b0 and $b1"; chebyshev_dist_to_box:
#           "Calculates the minimal distance between the vector $v and the minimal axis-aligned box", "using the Chebyshev metric").
# Expected: Segments that cross have the distance 0; the distance does not depend on the direction of a segment. The point
#           12,5 has the distance 2 from the square, as -2,5 has.
# Seen:     In the plane, the distance of the diagonals of the square is 7.07, of a cross with one short arm 2: only end points are
#           compared, and the second end point of the first segment is omitted. A post with the distance 2 from a line has
#           the distance 5.39 if it is given downwards. In space, 5.92 instead of 5.83. The Chebyshev distance of 12,5 is 12: on
#           the upper side, it is the distance from the lower corner. The Euclidean distance is right.

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
fetch libmath-vector-real-perl=0.18-3

cat >check.pl <<'PL'
use strict;
use warnings;
use lib 'root/usr/share/perl5';
use Math::Vector::Real;

# Distance of two segments by comparison of 1001 points on the first with the second.
sub sampled {
    my ($p, $q, @second) = @_;
    my $least;
    for my $i (0 .. 1000) {
        my $d = ($p + ($q - $p) * ($i / 1000))->dist2_to_segment(@second);
        $least = $d if !defined $least || $d < $least;
    }
    return sqrt $least;
}

for my $case (
    ['diagonals', V(0, 0), V(10, 10), V(0, 10), V(10, 0)],
    ['cross with a short arm', V(0, 0), V(10, 0), V(5, -2), V(5, 9)],
    ['post above a line', V(5, 2), V(5, 9), V(0, 0), V(10, 0)],
    ['in space, crossing', V(0, 0, 0), V(10, 10, 0), V(0, 10, 0), V(10, 0, 0)],
    ['in space, skew', V(7, 0, 4), V(7, 0, 0), V(2, 3, 3), V(0, 5, 1)],
) {
    my ($name, $p, $q, $r, $s) = @$case;
    my @distances = map { sqrt(Math::Vector::Real->dist2_between_segments(@$_)) }
        [$p, $q, $r, $s], [$q, $p, $r, $s], [$p, $q, $s, $r], [$r, $s, $p, $q];
    printf "%s: %s, sampled %.2f\n", $name, join(' ', map { sprintf '%.2f', $_ } @distances), sampled($p, $q, $r, $s);
}
for my $point (V(-2, 5), V(12, 5), V(5, -2), V(5, 12), V(1012, 5)) {
    printf "%s: Chebyshev distance %.2f, Euclidean distance %.2f\n", $point,
        $point->chebyshev_dist_to_box(V(0, 0), V(10, 10)), sqrt($point->dist2_to_box(V(0, 0), V(10, 10)));
}
PL
perl check.pl | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
diagonals: 7.07 7.07 7.07 7.07, sampled 0.00
cross with a short arm: 2.00 2.00 2.00 2.00, sampled 0.00
post above a line: 2.00 5.39 2.00 2.00, sampled 2.00
in space, crossing: 0.00 0.00 0.00 0.00, sampled 0.00
in space, skew: 5.92 5.92 5.92 5.83, sampled 5.83
{-2, 5}: Chebyshev distance 2.00, Euclidean distance 2.00
{12, 5}: Chebyshev distance 12.00, Euclidean distance 2.00
{5, -2}: Chebyshev distance 2.00, Euclidean distance 2.00
{5, 12}: Chebyshev distance 12.00, Euclidean distance 2.00
{1012, 5}: Chebyshev distance 1012.00, Euclidean distance 1002.00
EXPECTED
