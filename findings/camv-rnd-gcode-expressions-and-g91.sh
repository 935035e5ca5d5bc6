#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, camv-rnd 1.1.0-3 (viewer and converter of CAM files; the importer of G-code prints each move).
# Input:    expressions in brackets; an incremental move from the position 1,2; a change of units from G21 to G20 at 5,5.
# Expected: [5-2] is 3 and [1/4] is 0.25. After G91, X5 leads from 1,2 to 6,2. A change of units does not move the tool:
#           the next move starts at 5,5 mm.
# Seen:     Subtraction and division exchange their operands: -3 and 4. G91 doubles the position, and an incremental X
#           also moves Y: from 2,4 to 7,6. G20 multiplies the position by 25.4: the next move starts at 127,127 mm.
#           Sums, products and absolute moves are right. The picture has no line from 1,2; no warning is printed.

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

moves() {
  echo "$1:"
  printf '%s\n' "${@:2}" >in.ngc
  root/usr/bin/camv-rnd -x svg in.ngc </dev/null 2>&1 | sed -nE '/LINEAR|[Ww]arning|error/{s/[.]?0+(;|$| )/\1/g;p}'
}
{
  moves 'sum and product' G21 'G1 X[5+2] Y[2*4]'
  moves 'difference' G21 'G1 X[5-2] Y[10-2-3]'
  moves 'quotient' G21 'G1 X[1/4] Y[8/2]'
  moves 'absolute' G21 'G0 X1 Y2' 'G1 X6'
  moves 'incremental' G21 'G0 X1 Y2' G91 'G1 X5'
  moves 'inches after millimetres' G21 'G0 X5 Y5' G20 'G1 X1'
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
sum and product:
LINEAR 0;0;0 -> 7;8;0
difference:
LINEAR 0;0;0 -> -3;11;0
quotient:
LINEAR 0;0;0 -> 4;0.25;0
absolute:
LINEAR 1;2;0 -> 6;2;0
incremental:
LINEAR 2;4;0 -> 7;6;0
inches after millimetres:
LINEAR 127;127;0 -> 25.4;127;0
EXPECTED
