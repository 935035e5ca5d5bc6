#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, freecad-python3 0.20.2+dfsg1-4+deb12u1 (installed; class Path.Path, setFromGCode).
# Input:    programs with blocks that repeat no G word (G1 and G83 are modal), a comment in a block, "T1 M6".
# Expected: A line end ends a block: "G1 X10 Y5 | X20 Y9" is two moves, and G83 with two more positions is three holes.
#           A comment has no influence on the words after it.
# Seen:     Line ends are ignored: the later words overwrite the earlier, so one move to X20 Y9 and one hole remain.
#           The words after a comment and the T word before M6 are lost. No error is raised.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

version=0.20.2+dfsg1-4+deb12u1
[ "$(dpkg-query -W -f '${Version}' freecad-python3 2>/dev/null)" = "$version" ] ||
  { echo "freecad-python3 $version is not installed" >&2; exit 2; }
export HOME=$work POSTS=/usr/share/freecad/Mod/Path/PathScripts/post

cat >check.py <<'PY'
import Path

programs = [
    "G1 X10 Y5\nG1 X20 Y9",
    "G1 X10 Y5\nX20 Y9",
    "G83 X1 Y1 Z-5 R2 Q1\nX2\nX3\nG80",
    "G1 (rough) X10 Y5",
    "T1 M6",
]
with open("seen", "w") as seen:
    for program in programs:
        path = Path.Path()
        path.setFromGCode(program)
        commands = []
        for command in path.Commands:
            words = [f"{letter}{value:g}" for letter, value in command.Parameters.items()]
            commands.append(" ".join([command.Name, *words]))
        seen.write(f"{' | '.join(program.splitlines())} -> {' | '.join(commands)}; length {path.Length:.3f}\n")
PY
freecadcmd check.py </dev/null >log 2>&1 || true
cat seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
G1 X10 Y5 | G1 X20 Y9 -> G1 X10 Y5 | G1 X20 Y9; length 21.951
G1 X10 Y5 | X20 Y9 -> G1 X20 Y9; length 21.932
G83 X1 Y1 Z-5 R2 Q1 | X2 | X3 | G80 -> G83 Q1 R2 X3 Y1 Z-5 | G80; length 0.000
G1 (rough) X10 Y5 -> G1 | (rough); length 0.000
T1 M6 -> M6; length 0.000
EXPECTED
