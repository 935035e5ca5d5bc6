#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, linuxcnc-uspace 2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 (rs274).
# Input:    O-word structures with a move in the line of "else", "elseif" or "endif"; labels that are used twice.
# Expected: One rule for such a line: the move is made, or the line is refused, as with "o1 if [1] G1 X7"
#           ("Unexpected character after O-word"). A label of two structures is refused, as with two "if".
# Seen:     The value of the condition decides. After a false condition the line is accepted and the move is dropped without a
#           message; after a true one the same line is refused. Two "if" with one label are refused, two "do ... while" are not.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export HOME=$work

mkdir -p deb root
(cd deb && apt-get download linuxcnc-uspace=2.9.0~pre1+git20230208.f1270d6ed7-1+deb12u2 \
  libboost-python1.74.0=1.74.0+ds1-21 libpython3.11 >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
for package in deb/*.deb; do dpkg -x "$package" root; done
export LD_LIBRARY_PATH=$work/root/usr/lib:$work/root/usr/lib/x86_64-linux-gnu

# Prints the name and the X of all moves that rs274 makes, or that it refuses the program.
try() {
  printf 'G21 G90 F100\nG0 X1\n%b\nG1 X9\nM2\n' "$2" >p.ngc
  if root/usr/bin/rs274 -g p.ngc >out 2>err; then :; fi
  if [ "$(wc -l <err)" -gt 1 ]; then
    echo "$1: refused"
  else
    echo "$1: $(grep -oE '(STRAIGHT_FEED|STRAIGHT_TRAVERSE)\([-0-9.]+' out | sed 's/.*(/X/' | tr '\n' ' ' | sed 's/ $//')"
  fi
}
{
  try 'if' 'o1 if [1] G1 X7\no1 endif'
  for condition in 0 1; do
    try "[$condition] else" "o1 if [$condition]\no1 else G1 X7\no1 endif"
    try "[$condition] elseif" "o1 if [$condition]\no1 elseif [1] G1 X7\no1 endif"
    try "[$condition] endif" "o1 if [$condition]\no1 endif G1 X7"
  done
  try 'two if' 'o1 if [1]\no1 endif\no1 if [1]\no1 endif'
  try 'two do' 'o1 do\nG1 X3\no1 while [0]\no1 do\nG1 X4\no1 while [0]'
} >seen
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
if: refused
[0] else: X1.0000 X9.0000
[0] elseif: X1.0000 X9.0000
[0] endif: X1.0000 X9.0000
[1] else: refused
[1] elseif: refused
[1] endif: refused
two if: refused
two do: X1.0000 X3.0000 X4.0000 X9.0000
EXPECTED
