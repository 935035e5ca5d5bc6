#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libmrpt-math-dev 1:2.5.8+ds-2 (Mobile Robot Programming Toolkit). g++ and libeigen3-dev are installed.
# Input:    squares of 10 x 10 in the planes Z 0, 1, 5 and -5, X 3, and in a tilted plane, with points on, above and beside them; three
#           segments. Source: TPolygon3D.h (distance: "Absolute distance to point"), geometry.h (getSegmentBisector: "Gets the
#           bisector of a 3D segment").
# Expected: A point in the square has the distance 0. The plane of the bisector contains the middle of the segment, and both ends have
#           half of the length as their distance.
# Seen:     The distance is wrong for each plane that does not contain the origin: for a square at Z 5, the point in its centre is 10 away,
#           the point 4 above it 14, and the point 5 beside it 11.18; contains is true for the centre. The bisector of 0,0,0 to
#           10,0,0 is 0.196 x - 0.981 z = 0: it contains one end, and the middle is 0.98 away. The bisector of 0,0,2 to 0,0,8 is
#           Z 0. The bisector in the plane is right.

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
fetch libmrpt-math-dev=1:2.5.8+ds-2

cat >check.cpp <<'CPP'
#include <cstdio>
#include <mrpt/math/TLine2D.h>
#include <mrpt/math/TPlane.h>
#include <mrpt/math/TPolygon3D.h>
#include <mrpt/math/TSegment2D.h>
#include <mrpt/math/TSegment3D.h>
#include <mrpt/math/geometry.h>
using namespace mrpt::math;

// Square of 10 x 10 from `corner` along the unit vectors u and v; w is normal to both.
void square(const char* name, const TPoint3D& corner, const TPoint3D& u, const TPoint3D& v, const TPoint3D& w) {
    TPolygon3D polygon;
    for (const auto& p : {corner, corner + u * 10, corner + u * 10 + v * 10, corner + v * 10}) polygon.push_back(p);
    const TPoint3D centre = corner + u * 5 + v * 5;
    std::printf("square, %s: centre %.2f (contains %d), 4 above %.2f, 5 beside %.2f\n", name, polygon.distance(centre),
                polygon.contains(centre), polygon.distance(centre + w * 4), polygon.distance(centre + u * 10));
}

void bisect(const TSegment3D& s) {
    TPlane b;
    getSegmentBisector(s, b);
    const TPoint3D middle = (s.point1 + s.point2) * 0.5;
    std::printf("bisector %.3f,%.3f,%.3f,%.3f: middle %.2f, ends %.2f and %.2f, half of the length %.2f\n", b.coefs[0], b.coefs[1],
                b.coefs[2], b.coefs[3], b.distance(middle), b.distance(s.point1), b.distance(s.point2), s.length() / 2);
}

int main() {
    const TPoint3D x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), tilted(0.8, 0, 0.6), normal(-0.6, 0, 0.8);
    square("Z 0", {0, 0, 0}, x, y, z);
    square("Z 1", {0, 0, 1}, x, y, z);
    square("Z 5", {0, 0, 5}, x, y, z);
    square("Z -5", {0, 0, -5}, x, y, z);
    square("X 3", {3, 0, 0}, y, z, x);
    square("tilted, through 0,0,5", {0, 0, 5}, tilted, y, normal);
    bisect({{0, 0, 0}, {10, 0, 0}});
    bisect({{0, 0, 2}, {0, 0, 8}});
    bisect({{1, 2, 3}, {3, 6, 9}});
    const TSegment2D flat({1, 2}, {3, 8});
    TLine2D line;
    getSegmentBisector(flat, line);
    std::printf("in the plane: ends %.2f and %.2f, half of the length %.2f\n", line.distance(flat.point1),
                line.distance(flat.point2), flat.length() / 2);
}
CPP
lib=root/usr/lib/x86_64-linux-gnu
include=()
for folder in root/usr/include/mrpt/*/include; do include+=("-I$folder"); done
g++ -w -std=c++17 check.cpp -o check "${include[@]}" -Iroot/usr/include/mrpt -Iroot/usr/include -I/usr/include/eigen3 -L$lib \
  -lmrpt-math -lmrpt-core -Wl,-rpath-link,$lib
LD_LIBRARY_PATH=$lib ./check | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
square, Z 0: centre 0.00 (contains 1), 4 above 4.00, 5 beside 5.00
square, Z 1: centre 2.00 (contains 1), 4 above 6.00, 5 beside 5.39
square, Z 5: centre 10.00 (contains 1), 4 above 14.00, 5 beside 11.18
square, Z -5: centre 10.00 (contains 1), 4 above 6.00, 5 beside 11.18
square, X 3: centre 5.00 (contains 1), 4 above 5.83, 5 beside 15.00
square, tilted, through 0,0,5: centre 14.40 (contains 1), 4 above 16.96, 5 beside 19.61
bisector 0.196,0.000,-0.981,0.000: middle 0.98, ends 0.00 and 1.96, half of the length 5.00
bisector 0.000,0.000,-1.000,0.000: middle 5.00, ends 2.00 and 8.00, half of the length 3.00
bisector 0.036,0.071,-0.997,0.000: middle 5.62, ends 2.81 and 8.44, half of the length 3.74
in the plane: ends 3.16 and 3.16, half of the length 3.16
EXPECTED
