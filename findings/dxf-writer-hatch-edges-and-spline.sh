#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, @tarikjabiri/dxf 2.9.0 (writer), dxf-json 0.14.1 and @mlightcad/dxf-json 1.2.8 (readers).
# Input:    a hatch of half a disc (HatchEdgesTypeData: arc and line), a hatch of a square (HatchPolylineBoundary),
#           and a spline of degree 3 with four control points. Source: index.d.ts of the writer; DXF reference, HATCH
#           (91, 93) and SPLINE (42, 43, 44).
# Expected: Each hatch has a boundary path. The spline has the tolerances 42, 43 and 44, and a reader returns four
#           control points and eight knots.
# Seen:     The hatch with edges has no boundary path: the method for edges sets the flag of a polyline, so that the
#           writer looks for polylines. The spline has group 42 twice and no 44. Both readers stop at the second 42:
#           no control point and no knot, but the counts 4 and 8, and no error. With 44 in its place, both return all.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  @tarikjabiri/dxf@2.9.0 dxf-json@0.14.1 @mlightcad/dxf-json@1.2.8 >/dev/null

cat >check.mjs <<'JS'
import { DxfWriter, HatchBoundaryPaths, HatchEdgesTypeData, HatchPolylineBoundary, pattern, point2d, point3d, vertex }
  from '@tarikjabiri/dxf';
import { DxfParser } from 'dxf-json';
import { DxfParser as ForkParser } from '@mlightcad/dxf-json';
const write = (draw) => {
  const drawing = new DxfWriter();
  draw(drawing.modelSpace, drawing);
  return drawing;
};
const edges = new HatchEdgesTypeData();
edges.addArcEdgeData(point2d(0, 0), 5, 0, 180, true);
edges.addLineEdgeData(point2d(-5, 0), point2d(5, 0));
const byEdges = new HatchBoundaryPaths();
byEdges.addEdgesTypeData(edges);
const polyline = new HatchPolylineBoundary();
for (const [x, y] of [[0, 0], [10, 0], [10, 10], [0, 10]]) polyline.add(vertex(x, y));
const byPolyline = new HatchBoundaryPaths();
byPolyline.addPolylineBoundary(polyline);
for (const [name, paths] of [['polyline', byPolyline], ['edges', byEdges]]) {
  const text = write((space) => space.addHatch(paths, pattern({ name: 'ANSI31' }))).stringify();
  const hatch = text.slice(text.indexOf('AcDbHatch'));
  console.log(`hatch by ${name}: boundary paths (91) ${hatch.match(/\n91\n(\d+)/)[1]}, edges or vertices (93) ` +
    `${hatch.match(/\n93\n(\d+)/)?.[1] ?? 'missing'}`);
}

const controlPoints = [point3d(0, 0), point3d(1, 2), point3d(3, 2), point3d(4, 0)];
const text = write((space) => space.addSpline({ controlPoints })).stringify();
const lines = text.slice(text.indexOf('AcDbSpline')).split('\n').slice(1);
console.log(`spline, groups: ${lines.filter((_, i) => i % 2 === 0 && /^4[1-4]$|^1?0$/.test(lines[i])).slice(0, 7).join(' ')}`);
const corrected = text.replace('\n42\n0.0000000001\n', '\n44\n0.0000000001\n');
const readers = [['dxf-json', DxfParser, text], ['@mlightcad/dxf-json', ForkParser, text], ['dxf-json, 44', DxfParser, corrected],
  ['@mlightcad/dxf-json, 44', ForkParser, corrected]];
for (const [name, Parser, file] of readers) {
  const spline = new Parser().parseSync(file).entities[0];
  const knots = spline.knots ?? spline.knotValues;
  console.log(`${name}: ${spline.type}, control points ${spline.controlPoints.length} of ` +
    `${spline.numberOfControlPoints}, knots ${knots.length} of ${spline.numberOfKnots}`);
}

JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
hatch by polyline: boundary paths (91) 1, edges or vertices (93) 4
hatch by edges: boundary paths (91) 0, edges or vertices (93) missing
spline, groups: 42 43 42 10 10 10 10
dxf-json: SPLINE, control points 0 of 4, knots 0 of 8
@mlightcad/dxf-json: SPLINE, control points 0 of 4, knots 0 of 8
dxf-json, 44: SPLINE, control points 4 of 4, knots 8 of 8
@mlightcad/dxf-json, 44: SPLINE, control points 4 of 4, knots 8 of 8
EXPECTED
