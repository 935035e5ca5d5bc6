#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, inkscape 1.2.2-2+deb12u1 (extension hpgl_output.py), python3-lxml, python3-cssselect 1.2.0-2,
#           python3-numpy 1:1.24.2-1+deb12u1.
# Input:    an SVG sheet of 100 x 100 mm with a square of 20 mm at X 10 to 30 and Y 70 to 90 from the bottom. Options:
#           no automatic alignment, no tool offset, no overcut; then mirror and rotation options.
# Expected: 40 units are one millimetre. Mirror X gives X 2800 to 3600 on the sheet, mirror Y gives Y 400 to 1200, because
#           rotations by 90, 180 and 270 degrees keep the drawing on the sheet of 4000 x 4000 units.
# Seen:     The mirror axes are the left edge and the top edge. Mirror X gives negative values, and these
#           are replaced by 0: the square becomes a line at X 0. Mirror Y puts the square above the
#           sheet, at Y 4400 to 5200. With "centre zero point" negative values are kept. No message appears.

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
fetch inkscape=1.2.2-2+deb12u1 python3-cssselect=1.2.0-2 python3-numpy=1:1.24.2-1+deb12u1 \
  python3-lxml libxslt1.1 # no pin: security updates replace the version
extensions=$work/root/usr/share/inkscape/extensions
export PYTHONPATH=$extensions:$work/root/usr/lib/python3/dist-packages
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu

cat >sheet.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">
  <path d="M 10 10 H 30 V 30 H 10 Z"/>
</svg>
SVG
show() {
  printf '%s: ' "$*"
  /usr/bin/python3 "$extensions/hpgl_output.py" --autoAlign false --overcut 0 --toolOffset 0 --precut false \
    "$@" sheet.svg 2>&1 | grep -o 'PD[-0-9,]*'
}
{
  show --mirrorX false
  show --orientation 90
  show --orientation 180
  show --mirrorX true
  show --mirrorY true
  show --mirrorX true --center true
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
--mirrorX false: PD1200,3600,1200,2800,400,2800,400,3600
--orientation 90: PD3600,2800,2800,2800,2800,3600,3600,3600
--orientation 180: PD2800,400,2800,1200,3600,1200,3600,400
--mirrorX true: PD0,3600,0,2800,0,2800,0,3600
--mirrorY true: PD1200,4400,1200,5200,400,5200,400,4400
--mirrorX true --center true: PD-3200,1600,-3200,800,-2400,800,-2400,1600
EXPECTED
