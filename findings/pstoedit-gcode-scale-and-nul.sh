#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, pstoedit 3.78-2 writes (format gcode), with ghostscript;
#           linuxcnc-uspace 2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 (rs274) reads.
# Input:    PostScript: a horizontal line of 1440 points, which are 20 inches or 508 mm.
# Expected: LinuxCNC, for which the format is intended, reads the program. The line ends at X508.
# Seen:     The first comment has a NUL byte before its ")": LinuxCNC stops with "Unclosed comment found".
#           Without this byte the program is read. Its scale is 0.0139 instead of 1/72: the line ends at X508.41.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Extracts Debian 12 packages into ./root, without installation: LinuxCNC, and all others that are not installed.
fetch() {
  mkdir -p deb root
  apt-get install -s --no-install-recommends "$@" 2>log | sed -n 's/^Inst \([^ ]*\) .*(\([^ ]*\) .*/\1=\2/p' >list
  [ -s list ] || cat log >&2
  printf '%s\n' linuxcnc-uspace=2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 libboost-python1.74.0=1.74.0+ds1-21 \
    libpython3.11 >>list
  (cd deb && sort -u ../list | xargs apt-get download >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch pstoedit=3.78-2 ghostscript
ln -s x86_64-linux-gnu/pstoedit root/usr/lib/pstoedit # the folder of the drivers, relative to the program
library=$(find root -path "*/Resource/Init" | head -1)
export GS_LIB=$PWD/$library:$PWD/${library%/Resource/Init}/lib HOME=$work
export LD_LIBRARY_PATH=$work/root/usr/lib:$work/root/usr/lib/x86_64-linux-gnu PATH=$work/root/usr/bin:$PATH

cat >in.ps <<'PS'
%!PS-Adobe-3.0 EPSF-3.0
%%BoundingBox: 0 0 1440 1440
newpath 0 0 moveto 1440 0 lineto stroke
showpage
%%EOF
PS
pstoedit -f gcode in.ps out.ngc </dev/null >log 2>&1
grep -aoE '^#100[34] = [0-9.]*|^G20|^G64 P[0-9.]*' out.ngc >seen
# Prints the longest feed move along X that LinuxCNC makes, and the error message.
read_program() {
  { rs274 -g "$1" 2>&1 || true; } | grep -aoE 'Unclosed comment found|STRAIGHT_FEED\([1-9][0-9.]*' |
    sed -E 's/STRAIGHT_FEED\((.*)/\1 25.4/' | awk 'NF == 2 { printf "X%.2f mm\n", $1 * $2; next } { print }'
}
tr -d '\0' <out.ngc >clean.ngc
for name in out clean; do echo "$name.ngc: $(read_program $name.ngc)"; done >>seen
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
G20
G64 P0.003
#1003 = 0.0139
#1004 = 0.0139
out.ngc: Unclosed comment found
clean.ngc: X508.41 mm
EXPECTED
