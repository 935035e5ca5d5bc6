#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, lazarus-src-2.2, lcl-units-2.2 and lcl-nogui-2.2 2.2.6+dfsg2-2 (fpvectorial: vector graphics in Pascal;
#           about 50 MB are downloaded). The script calls fpc 3.2.2.
# Input:    DXF drawings of one or two entities, read and written as SVG and as G-code for AvisoCNC (G01 is a cut, P01 raises
#           the head, P02 lowers it). Source: DXF reference (group 70 of POLYLINE and LWPOLYLINE: bit 1 is closed, 128 is the
#           pattern of the line type; group 42: bulge; SPLINE: knots and control points; INSERT); avisocncgcodewriter.pas
#           ("Writes AvisoCNC G-Code"; line and Bezier segments).
# Expected: The G-code cuts the contour of each drawing, or an error says that an entity is not supported. Both polylines with
#           bit 1 are closed, with 128 as well. The curve of the spline has its top at 10,10.
# Seen:     No error. LINE and POLYLINE lower the head at their first point and raise it without a move, so a contour of four
#           lines becomes four holes; SVG contains the lines. CIRCLE, ARC and INSERT are missing in G-code, ARC and INSERT also
#           in SVG. A closed POLYLINE and an LWPOLYLINE with 129 are open, bulges are lines, and the spline is its control
#           polygon, with the top at 10,20.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Extracts some folders of pinned Debian 12 packages into ./root, without installation.
mkdir deb root
(cd deb && apt-get download lazarus-src-2.2=2.2.6+dfsg2-2 lcl-units-2.2=2.2.6+dfsg2-2 lcl-nogui-2.2=2.2.6+dfsg2-2 \
  >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
lazarus=usr/lib/lazarus/2.2.6
for package in deb/*.deb; do
  dpkg --fsys-tarfile "$package" | tar -x -C root --wildcards "./$lazarus/components/fpvectorial/*.*" \
    "./$lazarus/components/lazutils/*" "./$lazarus/lcl/units/x86_64-linux/*" 2>log || true
done

cat >convert.pas <<'PAS'
program convert;
{$mode objfpc}{$H+}
uses SysUtils, fpvectorial, dxfvectorialreader, svgvectorialwriter, avisocncgcodewriter;
var
  Document: TvVectorialDocument;
begin
  Document := TvVectorialDocument.Create;
  Document.ReadFromFile(ParamStr(1) + '.dxf', vfDXF);
  Document.WriteToFile(ParamStr(1) + '.svg', vfSVG);
  Document.WriteToFile(ParamStr(1) + '.ngc', vfGCodeAvisoCNCPrototipoV5);
  Document.Free;
end.
PAS
fpc -v0 -FU. -Furoot/$lazarus/components/fpvectorial -Furoot/$lazarus/components/lazutils/lib/x86_64-linux \
  -Furoot/$lazarus/lcl/units/x86_64-linux -Furoot/$lazarus/lcl/units/x86_64-linux/nogui convert.pas >log 2>&1 ||
  { cat log >&2; exit 2; }

cat >check.py <<'PY'
import re
import subprocess

corners = [(0, 0), (20, 0), (20, 10), (0, 10)]


def groups(*pairs):
    return "".join("%s\n%s\n" % pair for pair in pairs)


def line(x, y, u, v):
    return groups((0, "LINE"), (8, "0"), (10, x), (20, y), (11, u), (21, v))


def light(flags, bulge):
    points = "".join(groups((10, x), (20, y), (42, bulge)) for x, y in corners)
    return groups((0, "LWPOLYLINE"), (8, "0"), (90, 4), (70, flags)) + points


points = "".join(groups((0, "VERTEX"), (8, "0"), (10, x), (20, y)) for x, y in corners)
knots = groups(*((40, k) for k in (0, 0, 0, 1, 1, 1)))
control = "".join(groups((10, x), (20, y)) for x, y in ((0, 0), (10, 20), (20, 0)))
block = groups((0, "BLOCK"), (8, "0"), (2, "B"), (70, 0), (10, 0), (20, 0)) + line(0, 0, 5, 0) + groups((0, "ENDBLK"))
drawings = {
    "LWPOLYLINE 70=1": light(1, 0),
    "LWPOLYLINE 70=129": light(129, 0),
    "LWPOLYLINE 42=1": light(1, 1),
    "POLYLINE 70=1": groups((0, "POLYLINE"), (8, "0"), (66, 1), (70, 1), (10, 0), (20, 0)) + points + groups((0, "SEQEND")),
    "LINE, LINE": line(0, 0, 20, 0) + line(20, 0, 20, 10),
    "CIRCLE": groups((0, "CIRCLE"), (8, "0"), (10, 10), (20, 10), (40, 5)),
    "ARC": groups((0, "ARC"), (8, "0"), (10, 10), (20, 10), (40, 5), (50, 0), (51, 90)),
    "SPLINE": groups((0, "SPLINE"), (8, "0"), (70, 8), (71, 2), (72, 6), (73, 3)) + knots + control,
    "INSERT": groups((0, "INSERT"), (8, "0"), (2, "B"), (10, 10), (20, 10)),
}
for name, entities in drawings.items():
    with open("drawing.dxf", "w") as out:
        for section, content in ("BLOCKS", block), ("ENTITIES", entities):
            out.write(groups((0, "SECTION"), (2, section)) + content + groups((0, "ENDSEC")))
        out.write(groups((0, "EOF")))
    subprocess.run(["./convert", "drawing"], check=True)
    blocks = [b.split("//")[0].strip() for b in open("drawing.ngc", encoding="utf-8", errors="replace")]
    words = {"G01": "", "P01": "raise", "P02": "lower"}
    moves = [words[b[:3]] + b[3:].replace(".00", "").replace(" X", "").replace(" Y", ",") for b in blocks if b[:3] in words]
    svg = open("drawing.svg", encoding="utf-8").read()
    path = []
    for found in re.findall(r'\bd="m ([^"]*)"', svg):
        x = y = 0.0
        for u, v in (pair.split(",") for pair in found.replace("l ", "").split()):
            # The writer uses 90 pixels per 25.4 mm; Y points down in SVG.
            x, y = x + float(u) / 3.5433, y - float(v) / 3.5433
            path.append("%.0f,%.0f" % (x + 0.0, round(y, 3) + 0.0))
    print("%s: G-code %s; SVG %s" % (name, " ".join(moves), " ".join(path) or ("circle" if "<circle" in svg else "nothing")))
PY
python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
LWPOLYLINE 70=1: G-code raise 0,0 lower 20,0 20,10 0,10 0,0 raise; SVG 0,0 20,0 20,10 0,10 0,0
LWPOLYLINE 70=129: G-code raise 0,0 lower 20,0 20,10 0,10 raise; SVG 0,0 20,0 20,10 0,10
LWPOLYLINE 42=1: G-code raise 0,0 lower 20,0 20,10 0,10 0,0 raise; SVG 0,0 20,0 20,10 0,10 0,0
POLYLINE 70=1: G-code raise 0,0 lower raise; SVG 0,0 20,0 20,10 0,10
LINE, LINE: G-code raise 0,0 lower raise 20,0 lower raise; SVG 0,0 20,0 20,0 20,10
CIRCLE: G-code raise; SVG circle
ARC: G-code raise; SVG nothing
SPLINE: G-code raise 0,0 lower 10,20 20,0 raise; SVG 0,0 10,20 20,0
INSERT: G-code raise; SVG nothing
EXPECTED
