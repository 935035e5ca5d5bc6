#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, gerbis 1.0.3 (Gerber parser).
# Input:    Gerber X2: a format of 4 integer and 6 fractional digits; a macro of a disc with a hole; a macro of two
#           discs with a comment; a region of two triangles; lines that end with CR LF; %TD*%, which deletes all
#           attributes. Source: Gerber Layer Format Specification, commands FS, AM, G36/G37 and TD; CR and LF are
#           separators.
# Expected: 6 fractional digits in X and Y. Two primitives in each macro. Two contours. No error.
# Seen:     The fractional digits of X are the integer digits: 4 instead of 6 (readme.md shows this, too), so that X
#           is 100 times too large. Each macro ends after its first primitive: the hole is lost; the comment is a
#           syntax error. The second contour is lost without an error. CR LF and %TD*% are errors.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  gerbis@1.0.3 >/dev/null

cat >check.cjs <<'JS'
const { parseGerber } = require('gerbis');
const show = (name, lines, describe, end = '\n') => {
  try {
    console.log(`${name}: ${describe(parseGerber([...lines, 'M02*', ''].join(end))[0])}`);
  } catch (error) {
    console.log(`${name}: ${error.message.split('\n')[0]}`);
  }
};
show('FSLAX46Y46', ['%FSLAX46Y46*%'], (c) => `fractional digits ${c.x_fractional_digits} in X, ${c.y_fractional_digits} in Y`);
const primitives = (command) => `primitives ${command.macro_body.length}`;
show('disc with hole', ['%AMRING*1,1,$1,0,0*1,0,$2,0,0*%'], primitives);
show('disc with hole, on lines', ['%AMRING*', '1,1,$1,0,0*', '1,0,$2,0,0*%'], primitives);
show('macro with comment', ['%AMPAIR*', '0 Two discs*', '1,1,0.2,0.5,0*', '1,1,0.2,-0.5,0*%'], primitives);
const contour = (x) => [`X${x}Y0D02*`, `X${x + 10}Y0D01*`, `X${x + 10}Y10D01*`, `X${x}Y0D01*`];
show('region of two triangles', ['G36*', ...contour(0), ...contour(50), 'G37*'],
  (region) => region.contour.flat().map((c) => `${c.command_code} ${c.x},${c.y}`).join(' '));
show('LF', ['%MOMM*%'], (command) => command.unit);
show('CR LF', ['%MOMM*%'], (command) => command.unit, '\r\n');
show('%TD*%', ['%TD*%'], (command) => command.command_code);
JS
node check.cjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
FSLAX46Y46: fractional digits 4 in X, 6 in Y
disc with hole: primitives 1
disc with hole, on lines: primitives 1
macro with comment: Syntax error at line 1 col 43:
region of two triangles: D02 0,0 D01 10,0 D01 10,10 D01 0,0
LF: MM
CR LF: Syntax error at line 1 col 8:
%TD*%: object null is not iterable (cannot read property Symbol(Symbol.iterator))
EXPECTED
