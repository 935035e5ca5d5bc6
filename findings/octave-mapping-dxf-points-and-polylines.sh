#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, octave-mapping 1.4.2-3 (functions dxfread and dxfparse); octave 7.3.0-2.
# Input:    DXF files with a line from 1,2 to 7,8 and a point 3,4; two points; closed and open polylines of both kinds, with and
#           without the flag 0 of their vertices; two circles. Source: documentation of dxfparse (output style 0: "an output struct
#           optimized for fast drawing with dxfdraw.m"; style 1: "2D (Matlab-compatible) mapstructs", with a polygon "for closed
#           POLYLINE and LWPOLYLINE entities"); in the arrays of style 0, a row of NaN separates two objects.
# Expected: Each object has its coordinates, in both styles. Closed polylines are polygons.
# Seen:     In style 0, the y of a point is written into the array of the lines: the line begins at 1,4. Without a line, the array
#           of the lines contains the y of the points. The second closed LWPOLYLINE overwrites the last corner of the first one, and
#           two open ones are one. A closed POLYLINE is open if its vertices have the flag 0. Two circles are an error. Style 1 is
#           right for all but the POLYLINE and the circles.

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
fetch octave-mapping=1.4.2-3 octave=7.3.0-2
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH HOME=$work OCTAVE_HOME=$work/root/usr OCTAVE_EXEC_HOME=$work/root/usr

# Writes a DXF file: its name, then the entities, each in one argument with the groups "code value".
drawing() {
  local name=$1 group
  shift
  {
    printf '0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nENDSEC\n'
    printf '0\nSECTION\n2\nBLOCKS\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n'
    for group in $*; do echo "${group/:/$'\n'}"; done
    printf '0\nENDSEC\n0\nEOF\n'
  } >"$name.dxf"
}
line='0:LINE 8:0 10:1.0 20:2.0 11:7.0 21:8.0'
first='10:0.0 20:0.0 10:10.0 20:0.0 10:10.0 20:10.0'
second='10:20.0 20:0.0 10:30.0 20:0.0 10:30.0 20:10.0'
vertices() { # further groups of each vertex
  for point in '10:0.0 20:0.0' '10:10.0 20:0.0' '10:10.0 20:10.0'; do echo "0:VERTEX 8:0 $point $1"; done
}
drawing 'line' "$line"
drawing 'line and point' "$line" '0:POINT 8:0 10:3.0 20:4.0'
drawing 'two points' '0:POINT 8:0 10:3.0 20:4.0' '0:POINT 8:0 10:5.0 20:6.0'
drawing 'closed LWPOLYLINE' "0:LWPOLYLINE 8:0 90:3 70:1 $first"
drawing 'two closed LWPOLYLINE' "0:LWPOLYLINE 8:0 90:3 70:1 $first" "0:LWPOLYLINE 8:0 90:3 70:1 $second"
drawing 'two open LWPOLYLINE' "0:LWPOLYLINE 8:0 90:3 70:0 $first" "0:LWPOLYLINE 8:0 90:3 70:0 $second"
drawing 'closed POLYLINE' "0:POLYLINE 8:0 66:1 70:1 $(vertices '') 0:SEQEND 8:0"
drawing 'closed POLYLINE, flags of vertices 0' "0:POLYLINE 8:0 66:1 70:1 $(vertices '70:0') 0:SEQEND 8:0"
drawing 'two circles' '0:CIRCLE 8:0 10:1.0 20:2.0 40:5.0' '0:CIRCLE 8:0 10:3.0 20:4.0 40:6.0'

cat >check.m <<'M'
warning("off", "all");
addpath("root/usr/share/octave/packages/mapping-1.4.2");

function text = points(array)
  text = "";
  for row = array'
    if all(isnan(row))
      text = [text " |"];
    else
      text = [text sprintf(" %g,%g", row(1:2))];
    end
  end
end

names = {"line", "line and point", "two points", "closed LWPOLYLINE", "two closed LWPOLYLINE", "two open LWPOLYLINE", ...
         "closed POLYLINE", "closed POLYLINE, flags of vertices 0", "two circles"};
for name = names
  printf("%s\n", name{1});
  try
    evalc("drawing = dxfparse(dxfread([name{1} '.dxf']), 0);");
    arrays = {"XYZ", "lines"; "XYZp", "points"; "VRTS", "corners of POLYLINE"; "LWP", "corners of LWPOLYLINE"; "XY", "open LWPOLYLINE"};
    for i = 1:rows(arrays)
      if isfield(drawing, arrays{i, 1}) && ! all(isnan(drawing.(arrays{i, 1})(:)))
        printf("  style 0, %s:%s\n", arrays{i, 2}, points(drawing.(arrays{i, 1})));
      end
    end
  catch problem
    printf("  style 0: error\n");
  end
  try
    evalc("drawing = dxfparse(dxfread([name{1} '.dxf']), 1);");
    for kind = {"dxfpt", "dxfpl", "dxfpg"}
      if isfield(drawing, kind{1})
        for object = drawing.(kind{1})(:)'
          printf("  style 1, %s:%s\n", object.Geometry, points([object.X' object.Y']));
        end
      end
    end
  catch problem
    printf("  style 1: error\n");
  end
end
M
root/usr/bin/octave-cli --no-init-file --no-history check.m 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
line
  style 0, lines: 1,2 7,8
  style 1, Polyline: 1,2 7,8
line and point
  style 0, lines: 1,4 7,8
  style 0, points: 3,NaN
  style 1, Point: 3,4
  style 1, Polyline: 1,2 7,8
two points
  style 0, lines: 0,4 0,0 0,6
  style 0, points: 3,NaN | 5,NaN
  style 1, Point: 3,4
  style 1, Point: 5,6
closed LWPOLYLINE
  style 0, corners of LWPOLYLINE: 0,0 10,0 10,10
  style 1, Polygon: 0,0 10,0 10,10
two closed LWPOLYLINE
  style 0, corners of LWPOLYLINE: 0,0 10,0 20,0 30,0 30,10
  style 1, Polygon: 0,0 10,0 10,10
  style 1, Polygon: 20,0 30,0 30,10
two open LWPOLYLINE
  style 0, open LWPOLYLINE: 0,0 10,0 10,10 20,0 30,0 30,10
  style 1, Line: 0,0 10,0 10,10
  style 1, Line: 20,0 30,0 30,10
closed POLYLINE
  style 0, corners of POLYLINE: 0,0 10,0 10,10
  style 1, Polygon: 0,0 10,0 10,10
closed POLYLINE, flags of vertices 0
  style 0, lines: 0,0 10,0 10,10
  style 1, Line: 0,0 10,0 10,10
two circles
  style 0: error
  style 1: error
EXPECTED
