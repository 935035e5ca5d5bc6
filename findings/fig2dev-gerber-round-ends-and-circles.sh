#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, fig2dev 1:3.2.8b-3+deb12u2 (driver gbx: Gerber), gerbv 2.9.6-1 as the reader.
# Input:    FIG 3.2 with one black object: a track of two lines with projecting and with round ends, a circle, a pie wedge
#           of 90 degrees (format 3.2 of xfig: cap style 2 and 1, object code 1 with sub type 3, object code 5 with
#           sub type 2).
# Expected: gerbv shows both tracks. The circle is in the output. The wedge has an arc and two straight sides.
# Seen:     Round ends write `%ADD11C,0.333333%*` instead of `...*%` (Gerber specification: a data block ends with `*`,
#           then `%` closes the command). gerbv then reads the rest of the file as commands, and the layer is empty.
#           The circle is missing; the warning says that only black objects are written, but the circle is black.
#           The wedge is the arc alone. Projecting ends are right.

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
# The dependencies of fig2dev are for bitmaps and fonts; the driver gbx does not use them.
(cd deb && apt-get download fig2dev=1:3.2.8b-3+deb12u2 >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
dpkg -x deb/fig2dev_*.deb root
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu PATH=$work/root/usr/bin:$PATH HOME=$work

show() {
  echo "$1:"
  {
    printf '#FIG 3.2\nLandscape\nCenter\nMetric\nA4\n100.00\nSingle\n-2\n1200 2\n'
    printf '%b\n' "$2"
  } >in.fig
  fig2dev -L gbx -p pos in.fig out.gbx 2>warnings
  sed -nE '/^%ADD11/p; /^G0[23]/p; /^X/p' out.gbx
  sed -n '/black/p' warnings
  gerbv -x svg -o out.svg out.gbx >/dev/null 2>&1
  echo "shapes in gerbv: $(grep -c '<path' out.svg || true)"
}
{
  show 'track, projecting ends' '2 1 0 1 0 7 50 -1 -1 0.000 0 2 -1 0 0 3\n\t0 0 0 2250 900 2250'
  show 'track, round ends' '2 1 0 1 0 7 50 -1 -1 0.000 1 1 -1 0 0 3\n\t0 0 0 2250 900 2250'
  show 'circle' '1 3 0 1 0 7 50 -1 -1 0.000 1 0.0000 2400 2400 600 600 2400 2400 3000 2400'
  show 'wedge' '5 2 0 1 0 7 50 -1 -1 0.000 0 1 0 0 2250.0 2250.0 2700 2250 2568 1932 2250 1800'
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
track, projecting ends:
%ADD11R,0.333333X0.333333*%
X0Y0D02*
X0Y5000000D01*
X2000000Y5000000*
shapes in gerbv: 2
track, round ends:
%ADD11C,0.333333%*
X0Y0D02*
X0Y5000000D01*
X2000000Y5000000*
shapes in gerbv: 0
circle:
Warning: By default only objects with line colour of "default" or  "black" are output.
shapes in gerbv: 0
wedge:
%ADD11R,0.333333X0.333333*%
X6000000Y5000000D02*
G02*
X5000000Y4000000I-1000000J0D01*
shapes in gerbv: 1
EXPECTED
