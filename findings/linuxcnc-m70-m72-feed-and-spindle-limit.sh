#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, linuxcnc-uspace 2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 (rs274, the stand-alone interpreter).
# Input:    M70 saves the modes, the program changes feed and speed, M72 restores the modes.
# Expected: M72 restores the values: F123.456, S1234.56, F0.04 per revolution, G96 with the limit D2000.
# Seen:     M70 stores F with one decimal and S as an integer: F123.456 becomes 123.5, S1234.56 becomes 1235.
#           F0.04 (feed per revolution, or inches) becomes 0, so the next G1 is an error: "zero feed rate".
#           M72 restores G96 without its D word: the spindle limit of 2000 becomes 1e30, that is, no limit.

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
  tr '|' '\n' <<<"$1" >in.ngc
  { root/usr/bin/rs274 -g in.ngc 2>&1 || true; } | sed 's/^ *[0-9]* *N[.0-9]* *//' |
    grep -E '^(SET_FEED_RATE|SET_SPINDLE_SPEED|SET_SPINDLE_MODE|Cannot)' | grep -vE '\(0 0\.0000\)' | sed 's/^/  /'
}
{
  run 'G21 F123.456|M70|F10|M72|M2'
  run 'S1234.56|M70|S10|M72|M2'
  run 'G21 G95 S500 M3|F0.04|M70|F1|M72|G1 X1|M2'
  run 'G96 D2000 S100|M70|G97 S50|M72|M2'
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
G21 F123.456|M70|F10|M72|M2
  SET_FEED_RATE(123.4560)
  SET_FEED_RATE(10.0000)
  SET_FEED_RATE(123.5000)
  SET_FEED_RATE(0.0000)
S1234.56|M70|S10|M72|M2
  SET_SPINDLE_SPEED(0, 1234.5600)
  SET_SPINDLE_SPEED(0, 10.0000)
  SET_SPINDLE_SPEED(0, 1235.0000)
  SET_FEED_RATE(0.0000)
G21 G95 S500 M3|F0.04|M70|F1|M72|G1 X1|M2
  SET_FEED_RATE(0.0000)
  SET_SPINDLE_SPEED(0, 500.0000)
  SET_FEED_RATE(0.0400)
  SET_FEED_RATE(1.0000)
  SET_FEED_RATE(0.0000)
  Cannot do g1 with zero feed rate
G96 D2000 S100|M70|G97 S50|M72|M2
  SET_SPINDLE_MODE(0 2000.0000)
  SET_SPINDLE_SPEED(0, 100.0000)
  SET_SPINDLE_SPEED(0, 50.0000)
  SET_SPINDLE_MODE(0 1000000000000000019884624838656.0000)
  SET_SPINDLE_SPEED(0, 100.0000)
  SET_FEED_RATE(0.0000)
EXPECTED
