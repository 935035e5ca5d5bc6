#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, camv-rnd 1.1.0-3 (viewer and converter of CAM files).
# Input:    Gerber files with a flash at the origin and G75 arcs of radius 5 about it: three quarters, two halves, and a
#           full circle whose end is its start. Each contour as a line of width 0.1 (D01) and as a region (G36, G37).
# Expected: In multi quadrant mode, an arc with end = start is a full circle. Line and region are 10 mm wide.
# Seen:     The full circle is an arc of 0 degrees: a dot of 0.1 mm at 5,0. The region with the full circle is missing,
#           without a message. Three quarters and two halves are right.

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
fetch camv-rnd-core=1.1.0-3 camv-rnd-import=1.1.0-3 camv-rnd-export-vector=1.1.0-3
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu:$work/root/usr/lib HOME=$work
# camv-rnd searches the folder "plugins" in the current folder, too.
mkdir plugins
cp root/usr/lib/librnd3/plugins/* root/usr/lib/camv-rnd/plugins/* plugins/

cat >size.py <<'PY'
import math
import re

text = open("in.svg").read()
points = []
for x1, y1, radius, large, sweep, x2, y2 in re.findall(
        r'd="M (\S+) (\S+) A (\S+) \S+ 0 (\d) (\d) (\S+) (\S+)"', text):
    x1, y1, x2, y2, radius = (float(v) for v in (x1, y1, x2, y2, radius))
    chord = math.hypot(x2 - x1, y2 - y1)
    height = math.sqrt(max(0, radius * radius - chord * chord / 4))
    side = 1 if large != sweep else -1
    centre_x, centre_y = (x1 + x2) / 2 - side * height * (y2 - y1) / chord, (y1 + y2) / 2 + side * height * (x2 - x1) / chord
    begin, end = math.atan2(y1 - centre_y, x1 - centre_x), math.atan2(y2 - centre_y, x2 - centre_x)
    turn = (end - begin) % (2 * math.pi) if sweep == "1" else -((begin - end) % (2 * math.pi))
    for i in range(361):
        angle = begin + turn * i / 360
        points.append((centre_x + radius * math.cos(angle), centre_y + radius * math.sin(angle)))
for polygon in re.findall(r'points="([^"]*)"', text):
    points += [tuple(map(float, pair.split(","))) for pair in polygon.split()]
if not points:
    print("nothing")
else:
    print(" x ".join(f"{max(p[k] for p in points) - min(p[k] for p in points):.1f}" for k in (0, 1)))
PY

show() {
  printf '%s: ' "$1"
  rm -f in.svg
  printf '%s\n' '%FSLAX24Y24*%' '%MOMM*%' '%ADD10C,0.1*%' 'D10*' 'G75*' 'X0Y0D03*' "${@:2}" 'M02*' >in.gbr
  root/usr/bin/camv-rnd -x svg in.gbr </dev/null >log 2>&1 || true
  sed -n '/[Ww]arning\|error/p' log | grep -v 'Export load error' || true
  /usr/bin/python3 size.py
}
start='X50000Y0D02*'
quarters=('G03X0Y-50000I-50000J0D01*')
halves=('G03X-50000Y0I-50000J0D01*' 'G03X50000Y0I50000J0D01*')
full=('G03X50000Y0I-50000J0D01*')
{
  show 'line, three quarters' "$start" "${quarters[@]}"
  show 'line, two halves' "$start" "${halves[@]}"
  show 'line, full circle' "$start" "${full[@]}"
  show 'region, three quarters' 'G36*' "$start" "${quarters[@]}" 'G01X0Y0D01*' 'X50000D01*' 'G37*'
  show 'region, two halves' 'G36*' "$start" "${halves[@]}" 'G37*'
  show 'region, full circle' 'G36*' "$start" "${full[@]}" 'G37*'
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
line, three quarters: 10.0 x 10.0
line, two halves: 10.0 x 10.0
line, full circle: 0.0 x 0.0
region, three quarters: 10.0 x 10.0
region, two halves: 10.0 x 10.0
region, full circle: nothing
EXPECTED
