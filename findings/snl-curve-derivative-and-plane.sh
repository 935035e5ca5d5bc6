#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libsnl0 0.2.1.svn.18-1.1 (Simple Nurbs Library, a C++ library). The script calls g++.
# Input:    a quarter of a circle of radius 2 as a rational curve; a plane with the corners 0,0 10,0 0,10; a quarter of a
#           cone by revolution of a line about Z; a transform that turns X to -X.
# Expected: The integral of |velocity| is the length pi of the arc, and evalDerivs agrees with the differences of eval.
#           The plane ends at its corner 10,10 for each number of control points. align turns a vector to its opposite.
# Seen:     The first derivative of the curve is too short by its weight: the length is 2.984, the derivative at 0.3 is
#           2.950 instead of 3.178. A plane with n x n control points ends at 10 (n - 1) / n: at 5,5 for n = 2. align
#           leaves X in place. The derivative of the cone, a line from 0,0 to 10,0, and X to Z are right.

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
fetch libsnl0=0.2.1.svn.18-1.1 libsnl-dev=0.2.1.svn.18-1.1
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries

cat >check.cpp <<'CPP'
#include <cmath>
#include <cstdio>

#include "snlCurve.h"
#include "snlSurface.h"
#include "snlTransform.h"

static double distance(const snlPoint& a, const snlPoint& b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y(), a.z() - b.z());
}

int main()
{
    snlPoint start(2, 0, 0), end(0, 2, 0), centre(0, 0, 0);
    snlCurve arc(start, end, centre);
    double chords = 0, velocities = 0;
    const int steps = 10000;
    for (int i = 0; i < steps; ++i) {
        chords += distance(arc.eval(double(i) / steps), arc.eval(double(i + 1) / steps));
        snlVector velocity = arc.velocity((i + 0.5) / steps);
        velocities += velocity.length() / steps;
    }
    std::printf("length of the arc: chords %.3f, velocity %.3f\n", chords, velocities);
    const double h = 1e-5;
    const snlPoint* d = arc.evalDerivs(0.3, 1);
    std::printf("derivative of the arc: %.3f, differences %.3f\n", std::hypot(d[1].x(), d[1].y()),
                distance(arc.eval(0.3 + h), arc.eval(0.3 - h)) / (2 * h));

    snlPoint low(1, 0, 0), high(2, 0, 1), origin(0, 0, 0), up(0, 0, 1);
    snlCurve line(1, 2, low, high);
    snlSurface cone(line, origin, up, 90);
    const snlPoint* s = cone.evalDerivs(0.3, 0.4, 1, 1);
    std::printf("derivative of the cone: %.3f, differences %.3f\n", std::hypot(s[2].x(), s[2].y()),
                distance(cone.eval(0.3 + h, 0.4), cone.eval(0.3 - h, 0.4)) / (2 * h));

    snlPoint corner_u(10, 0, 0), corner_v(0, 10, 0);
    for (int n : {2, 3, 5}) {
        snlCurve edge(1, n, origin, corner_u);
        snlSurface plane(1, 1, n, n, origin, corner_u, corner_v);
        const snlPoint e = edge.eval(1), p = plane.eval(1, 1);
        std::printf("%d control points: line ends at %.3f,%.3f, plane at %.3f,%.3f\n", n, e.x(), e.y(), p.x(), p.y());
    }

    for (double x : {0.0, -1.0}) {
        snlVector from(1, 0, 0), to(x, 0, x == 0 ? 1 : 0);
        snlTransform turn;
        turn.align(from, to);
        snlPoint p(1, 0, 0);
        turn.transform(p);
        std::printf("align X to %g,0,%g: %.0f,%.0f,%.0f\n", to.x(), to.z(), p.x() + 0.0, p.y() + 0.0, p.z() + 0.0);
    }
}
CPP
g++ -std=c++17 -w -O1 -Iroot/usr/include check.cpp "$libraries/libSNL.so.0" -o check
./check | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
length of the arc: chords 3.142, velocity 2.984
derivative of the arc: 2.950, differences 3.178
derivative of the cone: 2.224, differences 2.224
2 control points: line ends at 10.000,0.000, plane at 5.000,5.000
3 control points: line ends at 10.000,0.000, plane at 6.667,6.667
5 control points: line ends at 10.000,0.000, plane at 8.000,8.000
align X to 0,0,1: 0,0,1
align X to -1,0,0: 1,0,0
EXPECTED
