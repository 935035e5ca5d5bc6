#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, gerbv 2.9.6-1 (Excellon in, Excellon out).
# Input:    the same two holes in millimetres and in inches. G93 sets a new zero between the holes,
#           25.4 mm (1 inch) away.
# Expected: Both files give the same holes.
# Seen:     The inch file shifts the second hole by 1 inch. The metric file shifts it by 25.4 inches (645 mm):
#           the offset of G93 is not converted to the unit of the file. No message appears.

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
fetch gerbv=2.9.6-1
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu PATH=$work/root/usr/bin:$PATH HOME=$work

show() {
  printf 'M48\n%s,TZ\nT1C%s\n%%\nG05\nG90\nT1\nX%sY%s\nG93X%sY0\nX%sY%s\nM30\n' "${@:2}" >in.drl
  gerbv -x drill -o out.drl in.drl >log 2>&1
  echo "$1: $(grep '^X' out.drl | tr '\r\n' '  ')"
}
{
  show 'inch ' INCH 0.04 1.0 1.0 1.0 1.0 1.0
  show 'metric' METRIC 1.016 25.4 25.4 25.4 25.4 25.4
} | sed 's/  */ /g; s/ $//' | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
inch : X010000Y010000 X000000Y010000
metric: X010000Y010000 X-244000Y010000
EXPECTED
