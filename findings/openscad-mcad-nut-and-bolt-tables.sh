#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, openscad 2021.01-6 with its library openscad-mcad 2019.05-1 (nuts_and_bolts.scad,
#           metric_fastners.scad).
# Input:    nutHole(size), boltHole(size, length=50) and csk_bolt(dia, len) for metric sizes of the tables in the library.
# Expected: The tables list nuts of 16, 19 and 24 for M20, M24 and M30, and heads of diameter 30, 36 and 45.
#           The bolt csk_bolt(10, 50) is 50 long.
# Seen:     Two tables have no comma after the entry for M20, so OpenSCAD subtracts the next entry from this entry and
#           moves all later entries: the pocket for an M20 nut is 15 deep, for M24 and M30 nothing remains to subtract.
#           The head of M20 has the diameter 29; the heads of M24 and M30 are missing. OpenSCAD gives no warning.
#           csk_bolt is 44 long. Sizes up to M16 are right.

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
fetch openscad=2021.01-6 openscad-mcad=2019.05-1
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu:$work/root/usr/lib HOME=$work OPENSCADPATH=$work/root/usr/share/openscad/libraries

# Prints the largest diameter along X in the upper and the lower half space, and the range in Z.
cat >measure.py <<'PY'
import sys

v = [tuple(map(float, line.split()[1:])) for line in open("out.stl") if line.split()[:1] == ["vertex"]]
low, high = min(p[2] for p in v), max(p[2] for p in v)
widths = []
for name, part in (("below", [p for p in v if p[2] < 0]), ("above", [p for p in v if p[2] > 0])):
    if part:
        widths.append(f"X size {name} Z 0: {max(p[0] for p in part) - min(p[0] for p in part):.2f}")
print(f"{sys.argv[1]}: {', '.join(widths)}, Z {low:g} to {high:g}")
PY
show() {
  printf '$fn = 24;\nuse <MCAD/%s>\n%s;\n' "$1" "$2" >in.scad
  rm -f out.stl
  if root/usr/bin/openscad -o out.stl in.scad >log 2>&1; then
    /usr/bin/python3 measure.py "$2"
  else
    echo "$2: $(grep 'empty' log)"
  fi
  grep -i 'warning' log || true
}
{
  for size in 12 16 20 24 30; do show nuts_and_bolts.scad "nutHole($size)"; done
  for size in 16 20 24 30; do show nuts_and_bolts.scad "boltHole($size, length=50)"; done
  show metric_fastners.scad 'cap_bolt(10, 50)'
  show metric_fastners.scad 'csk_bolt(10, 50)'
} | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
nutHole(12): X size above Z 0: 22.10, Z 0 to 10.0001
nutHole(16): X size above Z 0: 27.70, Z 0 to 13.0001
nutHole(20): X size above Z 0: 34.60, Z 0 to 15.0001
nutHole(24): Current top level object is empty.
nutHole(30): Current top level object is empty.
boltHole(16, length=50): X size below Z 0: 24.00, X size above Z 0: 15.96, Z -16.0001 to 50
boltHole(20, length=50): X size below Z 0: 29.00, X size above Z 0: 19.96, Z -20.0001 to 50
boltHole(24, length=50): X size above Z 0: 23.95, Z 0 to 50
boltHole(30, length=50): X size above Z 0: 29.95, Z 0 to 50
cap_bolt(10, 50): X size below Z 0: 15.00, X size above Z 0: 10.00, Z -12.5 to 50
csk_bolt(10, 50): X size above Z 0: 10.00, Z 0 to 44
EXPECTED
