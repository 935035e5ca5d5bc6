#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, linuxcnc-uspace 2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 (rs274, the stand-alone interpreter).
# Input:    a drilling cycle G82 with the dwell P1.5, cancelled by G80, then a tapping cycle G84 or G74 without P.
# Expected: The tapping cycle has no dwell. G89 without P after the same G82 is an error: "P word missing".
# Seen:     G84 and G74 reverse the spindle at the bottom and then dwell 1.5 seconds without a feed motion,
#           in spite of G80. Without the earlier G82 the dwell is 0.

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

run() {
  echo "$1"
  tr '|' '\n' <<<"G21 G90 F100|G0 Z5|S500|$1|G80|M2" >in.ngc
  { root/usr/bin/rs274 -g in.ngc 2>&1 || true; } | sed 's/^ *[0-9]* *N[.0-9]* *//' |
    grep -E '^(DWELL|STRAIGHT_FEED|START_SPINDLE_C|Dwell)' | sed 's/^/  /'
}
{
  run 'M3|G84 X2 Z-1 R2'
  run 'M3|G82 X1 Z-1 R2 P1.5|G80|G84 X2 Z-1 R2'
  run 'M4|G82 X1 Z-1 R2 P1.5|G80|G74 X2 Z-1 R2'
  run 'M3|G82 X1 Z-1 R2 P1.5|G80|G89 X2 Z-1 R2'
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
M3|G84 X2 Z-1 R2
  START_SPINDLE_CLOCKWISE(0)
  STRAIGHT_FEED(2.0000, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)
  START_SPINDLE_COUNTERCLOCKWISE(0)
  DWELL(0.0000)
  STRAIGHT_FEED(2.0000, 0.0000, 2.0000, 0.0000, 0.0000, 0.0000)
  START_SPINDLE_CLOCKWISE(0)
M3|G82 X1 Z-1 R2 P1.5|G80|G84 X2 Z-1 R2
  START_SPINDLE_CLOCKWISE(0)
  STRAIGHT_FEED(1.0000, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)
  DWELL(1.5000)
  STRAIGHT_FEED(2.0000, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)
  START_SPINDLE_COUNTERCLOCKWISE(0)
  DWELL(1.5000)
  STRAIGHT_FEED(2.0000, 0.0000, 2.0000, 0.0000, 0.0000, 0.0000)
  START_SPINDLE_CLOCKWISE(0)
M4|G82 X1 Z-1 R2 P1.5|G80|G74 X2 Z-1 R2
  START_SPINDLE_COUNTERCLOCKWISE(0)
  STRAIGHT_FEED(1.0000, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)
  DWELL(1.5000)
  STRAIGHT_FEED(2.0000, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)
  START_SPINDLE_CLOCKWISE(0)
  DWELL(1.5000)
  STRAIGHT_FEED(2.0000, 0.0000, 2.0000, 0.0000, 0.0000, 0.0000)
  START_SPINDLE_COUNTERCLOCKWISE(0)
M3|G82 X1 Z-1 R2 P1.5|G80|G89 X2 Z-1 R2
  START_SPINDLE_CLOCKWISE(0)
  STRAIGHT_FEED(1.0000, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)
  DWELL(1.5000)
  Dwell time p word missing with g89
EXPECTED
