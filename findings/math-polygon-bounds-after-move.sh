#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libmath-polygon-perl 1.10-3 (Math::Polygon: 2D polygons in Perl).
# Input:    a rectangle of 10 x 4, a square on its corner with the half diagonal 5, a regular octagon with the radius 10.
#           Source: Math::Polygon ("Returns a moved polygon object", "bounding box of the polygon", contains: "On the edge is
#           inside", distance: "zero if the point is on an edge"), Math::Polygon::Transform ("mirror in the line", "the
#           points with the widest angles will be removed").
# Expected: A rectangle moved by 100 has the bounding box 100 to 110. A line with two points of equal y is a valid mirror. All
#           points on the edges of the square are inside. An octagon reduced to 4 points is a square with the area 200.
# Seen:     After a call of bbox, move returns a polygon with the old bounding box, 0 to 10; all other transforms are right.
#           A horizontal mirror line stops with a division by zero; a vertical line works. The two right edges of the square are
#           inside, the two left edges are not; the distance is 0 at all. The octagon loses 4 adjacent corners: 70.71 of 282.84 remains.
#           A rotation by 90 degrees takes 1,0 to 0,-1.

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
fetch libmath-polygon-perl=1.10-3
export PERL5LIB=$work/root/usr/share/perl5

cat >check.pl <<'PERL'
use strict;
use warnings;
use Math::Polygon;

my $pi = atan2(0, -1);

sub polygon { return Math::Polygon->new(@_, $_[0]) }
sub box { return join(' ', map { sprintf('%.0f', $_) + 0 } $_[0]->bbox) }

for my $asked (0, 1) {
  my $plate = polygon([0, 0], [10, 0], [10, 4], [0, 4]);
  $plate->bbox if $asked;
  my $moved = $plate->move(dx => 100);
  my $points = join(' ', map { "$_->[0],$_->[1]" } $moved->points);
  print "moved, bbox ", ($asked ? 'called' : 'not called'), " before: $points, bbox ", box($moved), "\n";
  print "  mirror ", box($plate->mirror(x => 20)), ", rotate ", box($plate->rotate(degrees => 180));
  print ", resize ", box($plate->resize(scale => 2)), "\n";
}

my $one = Math::Polygon->new([1, 0], [1, 2]);
for my $line ([[0, 0], [0, 5]], [[0, 0], [5, 5]], [[0, 3], [5, 3]]) {
  my $mirrored = eval { join(' ', map { "$_->[0],$_->[1]" } $one->mirror(line => $line)->points) };
  print "mirror in the line $line->[0][0],$line->[0][1] to $line->[1][0],$line->[1][1]: ",
    $mirrored // ($@ =~ /(.*?) at /)[0], "\n";
}

my $turned = polygon([0, -5], [5, 0], [0, 5], [-5, 0]);
for my $point ([2, 3], [-2, 3], [-2, -3], [2, -3], [-4, 0], [5, 0], [-5, 0]) {
  printf("point %d,%d: inside %d, distance %.0f\n", @$point, $turned->contains($point) ? 1 : 0, $turned->distance($point));
}

my $octagon = polygon(map { [10 * cos($_ * $pi / 4), 10 * sin($_ * $pi / 4)] } 0 .. 7);
my $reduced = $octagon->simplify(max_points => 4);
printf("octagon: area %.2f, with 4 points %.2f\n", $octagon->area, $reduced->area);
printf("rotated by 90: 1,0 to %.0f,%.0f\n", @{(Math::Polygon->new([1, 0])->rotate(degrees => 90)->points)[0]});
PERL
perl check.pl | sed 's/-0\b/0/g' | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
moved, bbox not called before: 100,0 110,0 110,4 100,4 100,0, bbox 100 0 110 4
  mirror 30 0 40 4, rotate -10 -4 0 0, resize 0 0 20 8
moved, bbox called before: 100,0 110,0 110,4 100,4 100,0, bbox 0 0 10 4
  mirror 30 0 40 4, rotate -10 -4 0 0, resize 0 0 20 8
mirror in the line 0,0 to 0,5: -1,0 -1,2
mirror in the line 0,0 to 5,5: 0,1 2,1
mirror in the line 0,3 to 5,3: Illegal division by zero
point 2,3: inside 1, distance 0
point -2,3: inside 0, distance 0
point -2,-3: inside 0, distance 0
point 2,-3: inside 1, distance 0
point -4,0: inside 1, distance 1
point 5,0: inside 1, distance 0
point -5,0: inside 0, distance 0
octagon: area 282.84, with 4 points 70.71
rotated by 90: 1,0 to 0,-1
EXPECTED
