#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, pcb-gtk 1:4.2.2-1+b1 and pcb-common 1:4.2.2-1 (pcb -x gcode, default options).
# Input:    a board of 40 x 30 with copper on top and plated holes: three of 0.8, one of 1.0, one of 2.0; the same board with
#           one line of copper at the bottom. Source: text of the option --drill-mill ("drill holes equal or bigger than
#           the milling tool diameter", default 1.0) and of --predrill ("pre-drill all drill spots", on by
#           default).
# Expected: Both boards get all five holes; the hole of 1.0 is milled. Each position of a drill file is
#           pre-drilled, and no position without a hole. Each program starts with a move to the safe height.
# Seen:     The board with copper on top only gets no file for holes; five holes are missing, without a message. With
#           copper at the bottom, the files exist, mirrored for the back. The hole of 1.0 is drilled. Predrilling
#           drills a hole that does not exist at 0,0, the corner of the board, and leaves out the last hole. The program
#           for milled holes has its first G0 in X and Y before any move to the safe height.

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
fetch pcb-gtk=1:4.2.2-1+b1 pcb-common=1:4.2.2-1
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH HOME=$work

# Writes a board to the file $1 with the lines $2 on its bottom layer.
board() {
  cat >"$1" <<PCB
PCB["" 40.0mm 30.0mm]
Grid[2500.0 0 0 0]
Groups("1,c:2,s")
Layer(1 "top")
(
	Line[5.0mm 5.0mm 20.0mm 5.0mm 1.0mm 0.5mm "clearline"]
)
Layer(2 "bottom")
(
	$2
)
Via[5.0mm 5.0mm 2.0mm 1.0mm 2.2mm 0.8mm "" ""]
Via[20.0mm 5.0mm 2.0mm 1.0mm 2.2mm 0.8mm "" ""]
Via[20.0mm 15.0mm 2.0mm 1.0mm 2.2mm 0.8mm "" ""]
Via[30.0mm 15.0mm 2.0mm 1.0mm 2.2mm 1.0mm "" ""]
Via[25.0mm 10.0mm 3.0mm 1.0mm 3.2mm 2.0mm "" ""]
PCB
}
board one.pcb ''
board two.pcb 'Line[5.0mm 5.0mm 20.0mm 5.0mm 1.0mm 0.5mm "clearline"]'

# Exports a board; prints the names of the programs, their cycles, and the first two G0 of each program for holes.
show() {
  rm -f ./*.gcode
  root/usr/bin/pcb-gtk -x gcode "$1.pcb" >/dev/null 2>&1
  echo "$1: $(find . -name '*.gcode' -printf '%f\n' | sort | paste -sd ' ')"
  for file in "$1"-*drill*.gcode; do
    [ ! -e "$file" ] || echo "$file: $(grep '^G0' "$file" | head -2 | paste -sd ';')"
  done
  for file in "$1"-*.gcode; do
    ! grep -q '^G81' "$file" || echo "$file: $(grep -oE '^G81 X[-0-9.]+ Y[-0-9.]+' "$file" | sed 's/0000\>//g' | paste -sd ';')"
  done
}
for name in one two; do show $name; done | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
one: one-outline.gcode one-top.gcode
two: two-0.8000.drill.gcode two-1.0000.drill.gcode two-bottom.gcode two-drillmill.gcode two-outline.gcode two-top.gcode
two-0.8000.drill.gcode: G0 Z#100
two-1.0000.drill.gcode: G0 Z#100
two-drillmill.gcode: G0 X15.000000 Y20.000000;G0 X15.000000 Y20.000000
two-0.8000.drill.gcode: G81 X20.00 Y15.00;G81 X20.00 Y25.00;G81 X35.00 Y25.00
two-1.0000.drill.gcode: G81 X10.00 Y15.00
two-bottom.gcode: G81 X0.00 Y0.00;G81 X10.00 Y15.00;G81 X20.00 Y15.00;G81 X20.00 Y25.00
EXPECTED
