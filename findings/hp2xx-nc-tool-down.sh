#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, hp2xx 3.4.4-12+b1 writes (mode nc); linuxcnc-uspace 2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2
#           (rs274) reads.
# Input:    HPGL: two lines with two pens, PU before each SP; one horizontal line.
# Expected: PU before a pen change becomes a retract before the tool change M06, and a retract before the end.
#           A horizontal line gives its coordinates. LinuxCNC reads the program.
# Seen:     The change to tool 2 and the change to tool 0 at the end are at Z-1, in the material; no retract follows
#           the last line. The horizontal line has "Y -nan". There is no F word: LinuxCNC stops at the first block.

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
fetch hp2xx=3.4.4-12+b1 linuxcnc-uspace=2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 \
  libboost-python1.74.0=1.74.0+ds1-21 libpython3.11 # no pin: security updates replace the version
export LD_LIBRARY_PATH=$work/root/usr/lib:$work/root/usr/lib/x86_64-linux-gnu

convert() {
  echo "$1" >in.plt
  root/usr/bin/hp2xx -q -t -m nc -f "$2" in.plt </dev/null >log 2>&1
  echo "$1 -> $(grep -E '^[GM]' "$2" | tr '\n' '|')"
}
{
  convert 'IN;SP1;PU0,0;PD400,0;PU;SP2;PU0,400;PD400,800;PU;SP0;' pens.nc
  convert 'IN;SP1;PU0,400;PD400,400;PU;SP0;' line.nc
  echo "rs274: $(root/usr/bin/rs274 -g pens.nc 2>&1 | grep -o 'Cannot.*')"
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
IN;SP1;PU0,0;PD400,0;PU;SP2;PU0,400;PD400,800;PU;SP0; -> M06 T 1|G01 Z1|G00 X 0 Y 0|G01 Z-1|G01 X 0 Y 0|G01 X 10 Y 0|M06 T 2|G01 Z1|G00 X 0 Y 10|G01 Z-1|G01 X 0 Y 10|G01 X 10 Y 20|M06 T 0|M02|
IN;SP1;PU0,400;PD400,400;PU;SP0; -> M06 T 1|G01 Z1|G00 X 0 Y -nan|G01 Z-1|G01 X 0 Y -nan|G01 X 10 Y -nan|M06 T 0|M02|
rs274: Cannot do g1 with zero feed rate
EXPECTED
