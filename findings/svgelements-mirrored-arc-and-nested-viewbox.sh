#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, python3-svgelements 1.7.2-2; npm, svgpath 2.6.0 (the same transforms, for comparison).
# Input:    a quarter ellipse from 5,0 to 0,3 with the radii 5 and 3, transformed by a reflection in X = Y, a skew and a
#           scale; the same with an ellipse whose axes are turned by 30 degrees. A square of 10 in a nested svg element at
#           50,40 and in a symbol, both with viewBox. Source: SVG 2, 9.3.8 (arc), 8.2 (transform of a
#           viewport), 5.5 and 5.6 (symbol, use).
# Expected: The reflected quarter is from 0,0 to 3,5, its sweep flag is 0. A skewed ellipse has new axes. The box contains
#           all points. The nested square is 20 wide at 50,40; the use of the symbol gives 40 x 40 at 10,10. The symbol
#           itself is not drawn.
# Seen:     After a reflection that exchanges X and Y, the sweep flag remains 1: the arc is on the wrong side, from
#           -3,0 to 3,5, and its box does not contain its points. Skew and scale keep the directions of the old
#           axes as axes, so the arc becomes a different one. The offset of the nested svg is applied twice, the
#           second time scaled: 150,120. The viewBox of the symbol is ignored, and the symbol is drawn at 0,0 also. svgpath
#           is right; rotations and scale(-1,1) are right in both programs.

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
fetch python3-svgelements=1.7.2-2
npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" svgpath@2.6.0 >/dev/null

cat >transform.js <<'JS'
const svgpath = require('svgpath');
const [path, ...matrix] = process.argv.slice(2);
console.log(svgpath(path).matrix(matrix.map(Number)).toString());
JS
cat >check.py <<'PY'
import io
import subprocess

from svgelements import Matrix, Path, Shape, SVG


def box(points):
    values = [min(p.x for p in points), min(p.y for p in points), max(p.x for p in points), max(p.y for p in points)]
    return " ".join(f"{round(v, 2) + 0:g}" for v in values)


def sample(segment):
    return [segment.point(i / 2000) for i in range(2001)]


for path in ("M5 0A5 3 0 0 1 0 3", "M5 0A5 3 30 0 1 0 4"):
    for name, values in (("scale(-1,1)", (-1, 0, 0, 1, 0, 0)), ("rotate(90)", (0, 1, -1, 0, 0, 0)),
                         ("reflection", (0, 1, 1, 0, 0, 0)), ("skew", (1, 0, 0.5, 1, 0, 0)),
                         ("scale(2,1)", (2, 0, 0, 1, 0, 0))):
        matrix = Matrix(*values)
        exact = box([matrix.point_in_matrix_space(p) for p in sample(Path(path)[1])])
        arc = abs(Path(path) * matrix)[1]
        command = ["node", "transform.js", path, *map(str, values)]
        other = subprocess.run(command, capture_output=True, text=True, check=True)
        left, low, right, high = arc.bbox()
        bounds = " ".join(f"{round(v, 2) + 0:g}" for v in (left, low, right, high))
        print(f"{path} {name}: expected {exact}, points {box(sample(arc))}, box {bounds}, "
              f"svgpath {box(sample(Path(other.stdout.strip())[1]))}")

square = '<rect width="10" height="10"/>'
use = '<use href="#s" x="10" y="10" width="40" height="40"/>'
for name, content in (
    ("nested", f'<svg x="50" y="40" width="20" height="20">{square}</svg>'),
    ("nested, viewBox", f'<svg x="50" y="40" width="20" height="20" viewBox="0 0 10 10">{square}</svg>'),
    ("symbol", f'<symbol id="s">{square}</symbol>{use}'),
    ("symbol, viewBox", f'<symbol id="s" viewBox="0 0 10 10">{square}</symbol>{use}'),
):
    text = f'<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100" viewBox="0 0 100 100">{content}</svg>'
    shapes = [e for e in SVG.parse(io.StringIO(text), reify=True).elements() if isinstance(e, Shape)]
    print(f"{name}: {[tuple(round(v) for v in shape.bbox()) for shape in shapes]}")
PY
PYTHONPATH=$work/root/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
M5 0A5 3 0 0 1 0 3 scale(-1,1): expected -5 0 0 3, points -5 0 0 3, box -5 0 0 3, svgpath -5 0 0 3
M5 0A5 3 0 0 1 0 3 rotate(90): expected -3 0 0 5, points -3 0 0 5, box -3 0 0 5, svgpath -3 0 0 5
M5 0A5 3 0 0 1 0 3 reflection: expected 0 0 3 5, points -3 0 3 5, box 0 0 3 5, svgpath 0 0 3 5
M5 0A5 3 0 0 1 0 3 skew: expected 1.5 0 5.22 3, points 0 0 5 3.35, box 1.5 0 5 3, svgpath 1.5 0 5.22 3
M5 0A5 3 0 0 1 0 3 scale(2,1): expected 0 0 10 3, points 0 0 10 3, box 0 0 10 3, svgpath 0 0 10 3
M5 0A5 3 30 0 1 0 4 scale(-1,1): expected -7.18 0 0 5.68, points -7.18 0 0 5.68, box -7.18 0 0 5.68, svgpath -7.18 0 0 5.68
M5 0A5 3 30 0 1 0 4 rotate(90): expected -5.68 0 0 7.18, points -5.68 0 0 7.18, box -5.68 0 0 7.18, svgpath -5.68 0 0 7.18
M5 0A5 3 30 0 1 0 4 reflection: expected 0 0 5.68 7.18, points -1.68 -2.18 4 5, box -1.68 -2.18 4 5, svgpath 0 0 5.68 7.18
M5 0A5 3 30 0 1 0 4 skew: expected 2 0 9.2 5.68, points 1.88 -0.17 9.3 5.52, box 2 0 9.3 5.52, svgpath 2 0 9.2 5.68
M5 0A5 3 30 0 1 0 4 scale(2,1): expected 0 0 14.36 5.68, points -0.32 -0.13 13.91 6.66, box 0 0 13.91 6.66, svgpath 0 0 14.36 5.68
nested: [(50, 40, 60, 50)]
nested, viewBox: [(150, 120, 170, 140)]
symbol: [(0, 0, 10, 10), (10, 10, 20, 20)]
symbol, viewBox: [(0, 0, 10, 10), (10, 10, 20, 20)]
EXPECTED
