#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: Debian 12, libocct-data-exchange-dev 7.6.3+dfsg1-7 (installed), g++.
# Input:    STEP: half a cylinder of radius 10. The upper arc is a B-spline in the plane of the top. It leaves the cylinder
#           by 3e-4 at a third of its length and lies on the cylinder at both ends.
# Expected: The tolerance of the edge covers the deviation, 3.000e-04 (ShapeAnalysis_Edge.hxx, CheckSameParameter: an edge
#           is incorrect if the deviation is greater). The solid is valid, and BOPAlgo_ArgumentAnalyzer, which is also
#           Shape.check(True) of FreeCAD, accepts it.
# Seen:     The reader sets a tolerance of 2.994e-04, the largest deviation of a few points. BRepCheck_Analyzer accepts the
#           solid; BOPAlgo_ArgumentAnalyzer searches the true maximum and reports an invalid curve on the surface (kind
#           10). So the solid is not ready for Booleans, although the reader itself chose the tolerance. With the circle
#           instead of the B-spline, the solid is ready.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

version=7.6.3+dfsg1-7
[ "$(dpkg-query -W -f '${Version}' libocct-data-exchange-dev 2>/dev/null)" = "$version" ] ||
  { echo "libocct-data-exchange-dev $version is not installed" >&2; exit 2; }

cat >make.cpp <<'CPP'
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <cmath>
int main() {
    STEPControl_Writer writer;
    Interface_Static::SetIVal("write.surfacecurve.mode", 0);
    writer.Transfer(BRepPrimAPI_MakeCylinder(10, 20, std::acos(-1.0)).Shape(), STEPControl_AsIs);
    return writer.Write("half.step") == IFSelect_RetDone ? 0 : 1;
}
CPP
cat >bump.py <<'PY'
import math, sys
H = 3e-4
def point(t):
    r = 10 + H * 6.75 * t * (1 - t) ** 2
    a = math.pi * t
    return r * math.cos(a), r * math.sin(a)
def slope(t):
    r = 10 + H * 6.75 * t * (1 - t) ** 2
    dr = H * 6.75 * ((1 - t) ** 2 - 2 * t * (1 - t))
    a = math.pi * t
    return dr * math.cos(a) - r * math.pi * math.sin(a), dr * math.sin(a) + r * math.pi * math.cos(a)
n = 64
poles = [point(0.0)]
for i in range(n):
    (x, y), (u, v) = point(i / n), slope(i / n)
    (p, q), (f, g) = point((i + 1) / n), slope((i + 1) / n)
    poles += [(x + u / 3 / n, y + v / 3 / n), (p - f / 3 / n, q - g / 3 / n)]
poles.append(point(1.0))
first = 1000
text = open('half.step').read()
names, extra = [], []
for k, (x, y) in enumerate(poles):
    names.append(f'#{first + k}')
    extra.append(f"#{first + k} = CARTESIAN_POINT('',({x:.15E},{y:.15E},20.));")
mults = ','.join(['4'] + ['2'] * (n - 1) + ['4'])
knots = ','.join(repr(i / n) for i in range(n + 1))
curve = f"B_SPLINE_CURVE_WITH_KNOTS('',3,({','.join(names)}),.UNSPECIFIED.,.F.,.F.,({mults}),({knots}),.UNSPECIFIED.);"
head, tail = text.split("#26 = CIRCLE('',#27,10.);")
open('bump.step', 'w').write(head + '\n'.join(extra) + '\n#26 = ' + curve + tail)
PY
cat >judge.cpp <<'CPP'
#include <BOPAlgo_ArgumentAnalyzer.hxx>
#include <BOPAlgo_CheckResult.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>
int main(int, char** v) {
    STEPControl_Reader reader;
    if (reader.ReadFile(v[1]) != IFSelect_RetDone) return 1;
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    for (TopExp_Explorer e(shape, TopAbs_EDGE); e.More(); e.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(e.Current());
        const BRepAdaptor_Curve curve(edge);
        if (curve.GetType() != GeomAbs_BSplineCurve) continue;
        double off = 0.0;
        for (int i = 0; i <= 10000; ++i) {
            const gp_Pnt p = curve.Value(1e-4 * i);
            off = std::max(off, std::abs(std::hypot(p.X(), p.Y()) - 10.0));
        }
        std::printf("edge: off the cylinder by %.3e, tolerance %.3e\n", off, BRep_Tool::Tolerance(edge));
        break;
    }
    std::printf("valid: %s\n", BRepCheck_Analyzer(shape).IsValid() ? "yes" : "no");
    BOPAlgo_ArgumentAnalyzer check;
    check.SetShape1(shape);
    check.ArgumentTypeMode() = check.SelfInterMode() = check.SmallEdgeMode() = check.CurveOnSurfaceMode() = true;
    check.Perform();
    for (const auto& result : check.GetCheckResult()) std::printf("complaint of kind %d\n", (int)result.GetCheckStatus());
    std::printf("%s\n", check.HasFaulty() ? "not ready for Booleans" : "ready for Booleans");
}
CPP
build() {
  g++ -w -O1 "$1.cpp" -o "$1" -I/usr/include/opencascade -lTKSTEP -lTKSTEPBase -lTKXSBase -lTKBO -lTKPrim -lTKTopAlgo \
    -lTKBRep -lTKG3d -lTKGeomBase -lTKMath -lTKernel
}
build make
build judge
./make >log
python3 bump.py
for file in half bump; do
  echo "$file.step"
  ./judge "$file.step" | grep -E '^(edge|valid|complaint|not ready|ready)'
done | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
half.step
valid: yes
ready for Booleans
bump.step
edge: off the cylinder by 3.000e-04, tolerance 2.994e-04
valid: yes
complaint of kind 10
not ready for Booleans
EXPECTED
