#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, tcllib 1.21+dfsg-1 (math::geometry 1.4.1). The script calls tclsh 8.6.
# Input:    two lines that meet at 1/3, 2/3; all points with whole coordinates from 0,0 to 10,9 and the triangle 0,0 10,3 4,9; an L
#           with sides of 20 and a polyline of 14 points that crosses its first side at 15,0; two vectors. All coordinates are
#           whole numbers, as in the examples of the source. Source: manual page math_geometry (the coordinates are
#           "plain lists of coordinates"; findLineIntersection: "Find the intersection point of two (infinite) lines";
#           pointInsidePolygon: "Determine if a point is completely inside a polygon"; polylinesIntersect: "Check if two polylines
#           intersect or not"; areaParallellogram: "Calculate the area").
# Expected: 0 0 1 2 is the same line as 0.0 0.0 1.0 2.0. pointInsidePolygon agrees with pointInsidePolygonAlt. The polylines
#           intersect. The parallelogram of 2,0 and 0,3 has the area 6.
# Seen:     With whole coordinates, divisions are rounded down: the lines meet at 0,0, which is not on the second one. For 10 of
#           110 points, pointInsidePolygon is wrong, with decimal points for none; 0,1 is inside of a triangle that it does not
#           touch. polylinesIntersect compares parts of 10 points and returns 0 after the first two parts with overlapping
#           boxes; intersectionPolylines finds the point. areaParallellogram is an error for all vectors.

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
fetch tcllib=1.21+dfsg-1

cat >check.tcl <<'TCL'
set auto_path [linsert $auto_path 0 root/usr/share/tcltk/tcllib1.21]
package require math::geometry 1.4.1
namespace path ::math::geometry

proc decimal {coordinates} {
    lmap v $coordinates {expr {double($v)}}
}

foreach {first second} {{0 0 1 2} {0 1 1 0} {0 0 3 1} {1 -5 1 5}} {
    foreach lines [list [list $first $second] [list [decimal $first] [decimal $second]]] {
        lassign [findLineIntersection {*}$lines] x y
        puts "lines [join $lines { and }]: [format %.3f,%.3f $x $y]"
    }
}

set triangle {0 0 10 3 4 9}
set wrong {}
set wrong_decimal 0
for {set x 0} {$x <= 10} {incr x} {
    for {set y 0} {$y < 10} {incr y} {
        set point [list $x $y]
        set truth [pointInsidePolygonAlt [decimal $point] [decimal $triangle]]
        if {[pointInsidePolygon $point $triangle] != $truth} {lappend wrong $x,$y}
        if {[pointInsidePolygon [decimal $point] [decimal $triangle]] != $truth} {incr wrong_decimal}
    }
}
puts "points with a wrong side: [llength $wrong] ($wrong), with decimal points $wrong_decimal"

set ell {0 0 20 0 20 20}
set path {1 1 2 1 3 1 4 1 5 1 6 1 7 1 8 1 9 1 10 1 11 1 12 1 15 1 15 -1}
puts "polylines: intersect [polylinesIntersect $ell $path], at [intersectionPolylines $ell $path]"
catch {areaParallellogram {2 0} {0 3}} area
puts "parallelogram: [lindex [split $area \n] 0]"
TCL
tclsh check.tcl | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
lines 0 0 1 2 and 0 1 1 0: 0.000,0.000
lines 0.0 0.0 1.0 2.0 and 0.0 1.0 1.0 0.0: 0.333,0.667
lines 0 0 3 1 and 1 -5 1 5: 1.000,0.000
lines 0.0 0.0 3.0 1.0 and 1.0 -5.0 1.0 5.0: 1.000,0.333
points with a wrong side: 10 (0,1 0,2 1,3 1,4 2,5 2,6 3,1 3,7 3,8 6,2), with decimal points 0
polylines: intersect 0, at 15 0
parallelogram: unbalanced open paren
EXPECTED
