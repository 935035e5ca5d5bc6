#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, linuxcnc-uspace 2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 (the milling subroutines helix.ngc,
#           helix_rtheta.ngc and hole_circle.ngc of ngcgui, run by rs274 of the same package).
# Input:    a call of each subroutine with the parameter "inside" 1 (a hole) and 0 (a boss), a tool of 0.2 inch.
# Expected: The last level is at Z-0.5 in all six programs, because the comment in the files offers both values.
# Seen:     With inside 0 all three stop after the approach, with the radius compensation active: "duplicate O-word label".
#           helix.ngc has the label o<l30> for a condition in the outside branch and for the loop over Z. The hole skips
#           the condition, so the error is hidden there. helix_rtheta.ngc and hole_circle.ngc call helix.ngc.

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
fetch linuxcnc-uspace=2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 libboost-python1.74.0=1.74.0+ds1-21 \
  libpython3.11 # no pin: security updates replace the version
export LD_LIBRARY_PATH=$work/root/usr/lib:$work/root/usr/lib/x86_64-linux-gnu
subroutines=root/usr/share/linuxcnc/ncfiles/ngcgui_lib
printf '[RS274NGC]\nSUBROUTINE_PATH = %s:%s/utilitysubs\n' "$subroutines" "$subroutines" >in.ini
echo 'T1 P1 D0.2' >tool.tbl

run() {
  printf '%s\n' G20 'F10' 'T1 M6' "o<$1> call $3" M2 >in.ngc
  { root/usr/bin/rs274 -i in.ini -t tool.tbl -g in.ngc 2>&1 || true; } >out
  last=$(grep ARC_FEED out | tail -1 | cut -d, -f6 | tr -d ' ' || true)
  echo "$1, inside $2: last arc at Z ${last:-none}; $(grep -o 'duplicate O-word label' out || echo 'no error')"
}
for inside in 1 0; do
  # tool, speed, feed, direction, inside, depth, step, safe Z, then the geometry and the start Z
  run helix $inside "[1][2000][10][3][$inside][0.5][0.2][0.5][1][1][1][0][0][0][0][1][0][0]"
  run helix_rtheta $inside "[1][2000][10][3][$inside][0.5][0.2][0.5][1][0][0][1][45][0][0][1][0][0]"
  run hole_circle $inside "[1][2000][10][3][$inside][0.5][0.2][0.5][4][0][1][4][0][0][0][0][1][0][0]"
done | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
helix, inside 1: last arc at Z -0.5000; no error
helix_rtheta, inside 1: last arc at Z -0.5000; no error
hole_circle, inside 1: last arc at Z -0.5000; no error
helix, inside 0: last arc at Z none; duplicate O-word label
helix_rtheta, inside 0: last arc at Z none; duplicate O-word label
hole_circle, inside 0: last arc at Z none; duplicate O-word label
EXPECTED
