#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libgeometry-primitive-perl 0.24-3 (Geometry::Primitive, shapes in Perl).
# Input:    the square from 10,10 to 20,20 as Polygon and as Rectangle; the line from 2,0 to 2,10; a circle of radius 5 about
#           3,4; an arc from 0 to 1.57. Source: documentation of the modules (Polygon: "closed path", "No need to close the path,
#           it's handled automatically", area "Assumes it is non-self-intersecting"; contains_point: "true if the supplied
#           point is 'on' the line"; get_points: "the points that make up this Rectangle"; Circle, scale: "a new circle whose
#           radius is $amount times bigger than this one"; get_point_at_angle: "undef if the angle falls outside this arc's range").
# Expected: The area 100 for each start point. Points 2,5 and 5,5 are on and off the vertical line. The
#           points of the rectangle are the corners of a polygon of the area 100. A scaled circle has a centre.
# Seen:     The area of the polygon lacks the side from the last point to the first: 150, 150, 0 and 0 for the four start
#           points, and 100 if the first point is repeated at the end. The points with y 0 are on the vertical line, 2,5 is not.
#           The rectangle yields its points in the order of a Z, with the area 0 as a polygon. The scaled circle has no centre.
#           The arc yields a point at the angle 3.14, too.

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
fetch libgeometry-primitive-perl=0.24-3
PERL5LIB=$(echo "$work"/root/usr/share/perl5 "$work"/root/usr/lib/x86_64-linux-gnu/perl5/* | tr ' ' ':')
export PERL5LIB

cat >check.pl <<'PERL'
use strict;
use warnings;
no warnings 'uninitialized';
use Geometry::Primitive::Arc;
use Geometry::Primitive::Circle;
use Geometry::Primitive::Line;
use Geometry::Primitive::Polygon;
use Geometry::Primitive::Rectangle;

sub point { return Geometry::Primitive::Point->new(x => $_[0], y => $_[1]) }
sub polygon { return Geometry::Primitive::Polygon->new(points => [map { point(@$_) } @_]) }

my @corners = ([10, 10], [20, 10], [20, 20], [10, 20]);
for my $start (0 .. 3) {
  my @points = @corners[map { ($_ + $start) % 4 } 0 .. 3];
  print "square from $points[0][0],$points[0][1]: area ", polygon(@points)->area, ", first point repeated ",
    polygon(@points, $points[0])->area, "\n";
}

my $rectangle = Geometry::Primitive::Rectangle->new(origin => point(10, 10), width => 10, height => 10);
my @points = map { [$_->x, $_->y] } @{$rectangle->get_points};
print 'rectangle: area ', $rectangle->area, ', points ', join(' ', map { "$_->[0],$_->[1]" } @points),
  ', area as polygon ', polygon(@points, $points[0])->area, "\n";

my $vertical = Geometry::Primitive::Line->new(start => point(2, 0), end => point(2, 10));
my $slanted = Geometry::Primitive::Line->new(start => point(0, 0), end => point(2, 1));
for my $place ([2, 5], [5, 5], [0, 0]) {
  print "vertical line, $place->[0],$place->[1]: ", ($vertical->contains_point(@$place) ? 'on' : 'off'), "\n";
}
print 'slanted line, 1,0.5: ', ($slanted->contains_point(1, 0.5) ? 'on' : 'off'), "\n";

my $circle = Geometry::Primitive::Circle->new(origin => point(3, 4), radius => 5)->scale(2);
print 'scaled circle: radius ', $circle->radius, ', centre ', (defined $circle->origin ? 'defined' : 'undefined'), "\n";
my $arc = Geometry::Primitive::Arc->new(origin => point(0, 0), radius => 5, angle_start => 0, angle_end => 1.57);
my $outside = $arc->get_point_at_angle(3.14);
print 'arc at 3.14: ', (defined $outside ? sprintf('%.2f,%.2f', $outside->x, $outside->y) : 'undefined'), "\n";
PERL
perl check.pl 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
square from 10,10: area 150, first point repeated 100
square from 20,10: area 150, first point repeated 100
square from 20,20: area 0, first point repeated 100
square from 10,20: area 0, first point repeated 100
rectangle: area 100, points 10,10 20,10 10,20 20,20, area as polygon 0
vertical line, 2,5: off
vertical line, 5,5: off
vertical line, 0,0: on
slanted line, 1,0.5: on
scaled circle: radius 10, centre undefined
arc at 3.14: -5.00,0.01
EXPECTED
