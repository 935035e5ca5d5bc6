#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, dia 0.97.3+git20220525-5 (options -t and -e; export filters hpgl and dxf).
# Input:    SVG: a triangle with legs of 20 mm and a larger one that makes the drawing 100, 300 or 400 mm wide; an ellipse of
#           40 x 20 mm; a rectangle, a triangle and an L, all closed and without a fill. DXF: an ARC of radius 10 from 330 to
#           30 degrees. Source: HP-GL, plotter unit 0.025 mm (40 in a millimetre); AA x,y,angle: arc with a sweep angle.
# Expected: HPGL: 20 mm are 800 units in each drawing. The sweep of the arc is 60 degrees, the four arcs of the ellipse
#           have 360 degrees in total. DXF: the three outlines.
# Seen:     HPGL: 20 mm are 2000 units in a drawing of 100 or 300 mm, and 200 units in one of 400 mm: 2.5 times too large
#           or 4 times too small. The sweep of the arc is 420 degrees, so a plotter draws a full circle; the arcs of the
#           ellipse have 618, 461, 428 and 428 degrees. DXF: rectangle and triangle are a SOLID, which is filled; the L
#           is missing. No message about this appears.

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
fetch dia=0.97.3+git20220525-5
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
DIA_LIB_PATH=$(dirname "$(find "$work/root" -name libhpgl_filter.so)")
export LD_LIBRARY_PATH DIA_LIB_PATH HOME=$work

# Writes the elements $2 to an SVG file of $1 millimetres.
svg() {
  echo "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"$1mm\" height=\"$1mm\" viewBox=\"0 0 $1 $1\">" \
    "<g style=\"fill:none;stroke:#000000;stroke-width:0.1\">$2</g></svg>" >drawing.svg
}
convert() { root/usr/bin/dia -t "$1" -e "out.$1" "$2" >/dev/null 2>&1; }
hpgl() { convert plt "$1" && tr -d '\n' <out.plt | sed 's/^SP1;//; s/LT;//g'; }
triangle='M 10 10 L 30 10 L 30 30 L 10 10'
{
  for size in 100 300 400; do
    svg $size "<path d=\"$triangle\"/><path d=\"M 0 0 L $size 0 L $size $size L 0 0\"/>"
    echo "$size mm: $(hpgl drawing.svg | sed 's/PA/\n&/g' | grep -m1 '^PA' | sed 's/;.*//')"
  done
  printf '%s\n' 0 SECTION 2 ENTITIES 0 ARC 8 0 10 0 20 0 30 0 40 10 50 330 51 30 0 ENDSEC 0 EOF >arc.dxf
  echo "arc: $(hpgl arc.dxf)"
  svg 100 '<ellipse cx="50" cy="30" rx="20" ry="10"/>'
  echo "ellipse: $(hpgl drawing.svg)"
  for name in rectangle triangle L; do
    case $name in
      rectangle) svg 100 '<rect x="10" y="20" width="30" height="20"/>' ;;
      triangle) svg 100 "<path d=\"$triangle Z\"/>" ;;
      L) svg 100 '<path d="M 0 0 L 30 0 L 30 10 L 10 10 L 10 30 L 0 30 Z"/>' ;;
    esac
    convert dxf drawing.svg
    echo "DXF, $name: $(sed -n '/ENTITIES/,$p' out.dxf | paste -sd ' ' | tr -s ' ' | sed 's/^ENTITIES 0 //')"
  done
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
100 mm: PA3000,-1000,3000,-3000,1000,-1000
300 mm: PA3000,-1000,3000,-3000,1000,-1000
400 mm: PA300,-100,300,-300,100,-100
arc: PU8660,-5000;PD;AA0,0,420;
ellipse: PU6788,-2552;PD;AA6420,-3000,618;PU3211,-2552;PD;AA3579,-3000,461;PU6788,-2552;PD;AA5000,-5170,428;PU3211,-3447;PD;AA5000,-829,428;
DXF, rectangle: SOLID 8 Background 62 0 10 1 20 -2 11 4 21 -2 12 1 22 -4 13 4 23 -4 0 ENDSEC 0 EOF
DXF, triangle: SOLID 8 Background 62 0 10 1 20 -1 11 3 21 -1 12 1 22 -1 13 3 23 -3 0 ENDSEC 0 EOF
DXF, L: ENDSEC 0 EOF
EXPECTED
