#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, dxf2json 1.0.3 (DXF to JSON and GeoJSON).
# Input:    a DXF file of R12 with a line, a circle, an arc and two closed polylines, with the line ends LF and CR LF, from a file
#           and from a text. Source: readme (init reads a file, parseContent the content of a file, toGeojson converts the result of
#           both).
# Expected: Both functions return five entities for both line ends. In GeoJSON, the circle and the arc are lines or polygons of
#           their extent, and closed polylines have a closing side.
# Seen:     parseContent returns an empty drawing for LF, without an error; init reads both. In GeoJSON, the circle and the arc are
#           their centres, and closed polylines are open. Of the second polyline, the entity has neither its layer nor its flag.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" dxf2json@1.0.3 >/dev/null

polyline() { # x of the first corner
  printf '0 POLYLINE 8 0 66 1 70 1 '
  printf '0 VERTEX 8 0 10 %s 20 %s ' "$1" 0 $(($1 + 10)) 0 $(($1 + 10)) 10
  printf '0 SEQEND 8 0 '
}
{
  printf '0 SECTION 2 HEADER 9 $ACADVER 1 AC1009 0 ENDSEC 0 SECTION 2 ENTITIES '
  printf '0 LINE 8 0 10 1 20 2 30 0 11 7 21 8 31 0 0 CIRCLE 8 0 10 5 20 5 30 0 40 3 '
  printf '0 ARC 8 0 10 5 20 5 30 0 40 3 50 30 51 120 '
  polyline 0
  polyline 20
  printf '0 ENDSEC 0 EOF'
} | tr ' ' '\n' >lf.dxf
echo >>lf.dxf
sed 's/$/\r/' lf.dxf >crlf.dxf

cat >check.cjs <<'JS'
const fs = require('fs');
const { DxfParser, toGeojson } = require('dxf2json');
(async () => {
  for (const name of ['lf', 'crlf']) {
    const readers = {
      init: () => new DxfParser().init(`${name}.dxf`),
      parseContent: () => new DxfParser().parseContent(fs.readFileSync(`${name}.dxf`, 'utf8')),
    };
    for (const [reader, read] of Object.entries(readers)) {
      const drawing = await read();
      console.log(`${name}, ${reader}: ${drawing.ENTITIES.map(({ type, layer, shape }) =>
        `${type} (layer ${layer}${shape ? ', closed' : ''})`).join(', ') || 'no entity'}`);
      for (const { geometry } of (await toGeojson(drawing)).features)
        console.log(`  ${geometry.type} ${JSON.stringify(geometry.coordinates)}`);
    }
  }
})();
JS
node check.cjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
lf, init: LINE (layer 0), CIRCLE (layer 0), ARC (layer 0), POLYLINE (layer 0, closed), POLYLINE (layer undefined)
  LineString [[1,2,0],[7,8,0]]
  Point [5,5,0]
  Point [5,5,0]
  LineString [[0,0,0],[10,0,0],[10,10,0]]
  LineString [[20,0,0],[30,0,0],[30,10,0]]
lf, parseContent: no entity
crlf, init: LINE (layer 0), CIRCLE (layer 0), ARC (layer 0), POLYLINE (layer 0, closed), POLYLINE (layer undefined)
  LineString [[1,2,0],[7,8,0]]
  Point [5,5,0]
  Point [5,5,0]
  LineString [[0,0,0],[10,0,0],[10,10,0]]
  LineString [[20,0,0],[30,0,0],[30,10,0]]
crlf, parseContent: LINE (layer 0), CIRCLE (layer 0), ARC (layer 0), POLYLINE (layer 0, closed), POLYLINE (layer undefined)
  LineString [[1,2,0],[7,8,0]]
  Point [5,5,0]
  Point [5,5,0]
  LineString [[0,0,0],[10,0,0],[10,10,0]]
  LineString [[20,0,0],[30,0,0],[30,10,0]]
EXPECTED
