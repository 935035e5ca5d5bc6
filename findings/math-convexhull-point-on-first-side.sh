#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, libmath-convexhull-perl 1.4-1.1 (Graham's scan), libmath-convexhull-monotonechain-perl 0.1-2+b1 (the same
#           hull with Andrew's algorithm, for comparison).
# Input:    polygons of four to six corners with an additional point on a side, and 2000 sets of eight points of a grid of 5 x 5.
#           Source: documentation of Math::ConvexHull ("calculates the convex hull of a set of points"; "returns a reference to an
#           array containing points in the hull").
# Expected: The hull has the area of the hull of the other package, whatever side the additional point is on.
# Seen:     If the first side, from the lowest point counter-clockwise, leans to the left and contains a further point, the end of
#           the side is missing: the area of the plate is 800 instead of 1000. On the other sides, the point is dropped correctly
#           or, on the last side, remains as a corner of 180 degrees. Of 2000 random sets, 4 hulls are too small, without a message.

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
fetch libmath-convexhull-perl=1.4-1.1 libmath-convexhull-monotonechain-perl=0.1-2+b1

cat >check.pl <<'PL'
use strict;
use warnings;
use lib 'root/usr/share/perl5', 'root/usr/lib/x86_64-linux-gnu/perl5/5.36';
use Math::ConvexHull;
use Math::ConvexHull::MonotoneChain;

sub area {
    my @p = @_;
    my $sum = 0;
    $sum += $p[$_ - 1][0] * $p[$_][1] - $p[$_][0] * $p[$_ - 1][1] for 0 .. $#p;
    return $sum / 2;
}

sub hulls {
    my @points = @_;
    return map { [@{ $_->([map { [@$_] } @points]) }] } \&Math::ConvexHull::convex_hull,
        \&Math::ConvexHull::MonotoneChain::convex_hull;
}

my @plate = ([40, 0], [20, 40], [0, 40], [0, 10]);
for my $extra ([], [[30, 20]], [[10, 40]], [[0, 20]], [[20, 5]], [[30, 20], [35, 10]]) {
    my ($graham, $andrew) = hulls(@plate, @$extra);
    printf "plate with (%s): %s, area %g, with the other package %g\n", join(' ', map { "@$_" } @$extra),
        join(', ', map { "@$_" } @$graham), area(@$graham), abs area(@$andrew);
}

# Park and Miller's generator, so that the sets are the same everywhere.
my $state = 1;
sub random { $state = $state * 16807 % 2147483647; return $state % 5 }
my ($small, $more) = (0, 0);
for (1 .. 2000) {
    my %set;
    while (keys %set < 8) { my ($x, $y) = (random(), random()); $set{"$x $y"} = [$x, $y] }
    my ($graham, $andrew) = hulls(map { $set{$_} } sort keys %set);
    my ($a, $b) = (area(@$graham), abs area(@$andrew));
    if ($a < $b) { ++$small } elsif (@$graham > @$andrew) { ++$more }
}
print "2000 sets: $small hulls are too small, $more have a corner of 180 degrees\n";
PL
perl check.pl | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
plate with (): 40 0, 20 40, 0 40, 0 10, area 1000, with the other package 1000
plate with (30 20): 40 0, 30 20, 0 40, 0 10, area 800, with the other package 1000
plate with (10 40): 40 0, 20 40, 0 40, 0 10, area 1000, with the other package 1000
plate with (0 20): 40 0, 20 40, 0 40, 0 10, area 1000, with the other package 1000
plate with (20 5): 40 0, 20 40, 0 40, 0 10, 20 5, area 1000, with the other package 1000
plate with (30 20 35 10): 40 0, 35 10, 0 40, 0 10, area 700, with the other package 1000
2000 sets: 4 hulls are too small, 77 have a corner of 180 degrees
EXPECTED
