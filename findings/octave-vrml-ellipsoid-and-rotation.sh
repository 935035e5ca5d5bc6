#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, octave-vrml 1.0.13-8, octave 7.3.0-2 (VRML nodes for spheres, lines, frames and surfaces).
# Input:    the ellipsoid x^2/4 + y^2/9 + z^2/16 = 1, as a matrix and turned by 30 degrees about Z; the rotation by 90 degrees about Z
#           as an axis and as the matrix that takes 1,0,0 to 0,1,0; three points for vrml_lines; a surface of 2 x 2 points.
#           Source: help of vrml_ellipsoid ("Define elipsoid by x'*moment*x = 1"), of vrml_transfo ("3x3 Rotation matrix, or
#           3 Scaled rotation axis"), of vrml_lines (the indexes are optional), of vrml_surf and vrml_thick_surf.
# Expected: The ellipsoid has the half axes 2, 3, 4 and turns about +Z. Both forms of the rotation give 0 0 1 1.571. The lines join the
#           points: indexes 0, 1, 2. The surfaces are VRML nodes.
# Seen:     The half axes are 4, 9, 16, because the root is missing, and the ellipsoid turns about -Z. The axis gives 0 0 1, the
#           matrix 0 0 -1: the part turns the wrong way. The line has the index 0 three times, so no line is visible. vrml_surf
#           and vrml_thick_surf stop with an error, because Octave 7 has no function "finite". Cylinders are right.

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
fetch octave-vrml=1.0.13-8 octave=7.3.0-2
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH HOME=$work OCTAVE_HOME=$work/root/usr OCTAVE_EXEC_HOME=$work/root/usr

cat >check.m <<'M'
warning("off", "all");
addpath(genpath("root/usr/share/octave/packages"));
addpath(genpath("root/usr/lib/x86_64-linux-gnu/octave/packages"));

% Fields of a VRML node, in one line.
function show(name, node, varargin)
  printf("%s:", name);
  for field = varargin
    found = regexp(node, [field{1} "\\s+([-0-9. ]+)"], "tokens", "once");
    printf(" %s %s", field{1}, strjoin(cellfun(@(x) sprintf("%.4g", str2double(x) + 0), ...
      strsplit(strtrim(found{1})), "UniformOutput", false), " "));
  end
  printf("\n");
end

function attempt(name, task)
  try
    task();
    printf("%s: a node\n", name);
  catch failure
    printf("%s: %s\n", name, failure.message);
  end
end

angle = pi / 6;
turn = [cos(angle) -sin(angle) 0; sin(angle) cos(angle) 0; 0 0 1];
moment = diag([1 / 4, 1 / 9, 1 / 16]);
point = turn * [2; 0; 0];
printf("end of the axis of 2, turned by 30: %.3f %.3f, x' * moment * x = %.3f\n", point(1:2), point' * turn * moment * turn' * point);
show("ellipsoid", vrml_ellipsoid(moment), "scale");
show("ellipsoid, turned by 30", vrml_ellipsoid(turn * moment * turn'), "rotation", "scale");
show("sphere of radius 2", vrml_ellipsoid(1 / 4), "scale");

quarter = [0 -1 0; 1 0 0; 0 0 1];
printf("matrix: 1,0,0 to %g,%g,%g\n", quarter * [1; 0; 0]);
show("transfo, axis", vrml_transfo("X", [0 0 0], [0 0 pi / 2]), "rotation");
show("transfo, matrix", vrml_transfo("X", [0 0 0], quarter), "rotation");
show("cylinder along X", vrml_cyl([0 10; 0 0; 0 0], "rad", 2), "translation", "rotation", "height");

points = [0 10 10; 0 0 5; 0 0 0];
disp(["lines: " regexprep(regexp(vrml_lines(points), "coordIndex \\[([^\\]]*)", "tokens", "once"){1}, "\\s+", " ")]);
attempt("vrml_surf", @() vrml_surf([0 1], [0 2], [1 2; 3 4]));
attempt("vrml_thick_surf", @() vrml_thick_surf([0 1], [0 2], [1 2; 3 4]));
M
(root/usr/bin/octave-cli --no-init-file --no-gui check.m 2>/dev/null || true) | sed 's/-0\b\([^.]\|$\)/0\1/g; s/ *$//' | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
end of the axis of 2, turned by 30: 1.732 1.000, x' * moment * x = 1.000
ellipsoid: scale 4 9 16
ellipsoid, turned by 30: rotation 0 0 -1 0.524 scale 4 9 16
sphere of radius 2: scale 4 4 4
matrix: 1,0,0 to 0,1,0
transfo, axis: rotation 0 0 1 1.571
transfo, matrix: rotation 0 0 -1 1.571
cylinder along X: translation 5 0 0 rotation 0 0 -1 1.571 height 10
lines:  0, 0, 0, -1,
vrml_surf: 'finite' undefined near line 270, column 28
vrml_thick_surf: 'finite' undefined near line 93, column 28
EXPECTED
