#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, octave-nurbs 1.4.3-3, octave 7.3.0-2.
# Input:    two lines of length 10 and 20, joined with nrbglue, and a quarter circle with the knots 0 0 0 7 7 7; a quadratic
#           curve and its unclamped form from nrbunclamp. Source: IGES entity 126 (V(0), V(1): start and end of the
#           parameter); help of nrbmeasure ("points are given by their coordinates in the parametric domain"), of
#           nrbreverse, nrbdegelev and nrbunclamp, which name no restriction.
# Expected: The IGES file contains the whole curves: lengths 30 and 7.85. nrbmeasure returns 30 for the range of the
#           joined curve, 0 to 2, and the same length for both forms of the quadratic curve. The reversed curve has the
#           same range of parameters and starts at 15,5; a raised degree keeps the curve.
# Seen:     nrbglue gives the range 0 to 2; nrb2iges always writes V(0) 0 and V(1) 1, so the file contains 10 of 30
#           mm and 1.05 of 7.85 mm. nrbmeasure returns 30 from 0 to 1 and stops with an error from 0 to 2. For the unclamped
#           curve nrbmeasure and nrbdegelev stop with an error, and nrbreverse moves the range from 0..1 to 1..2. nrbeval,
#           nrbkntins and nrbclamp are right.

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
fetch octave-nurbs=1.4.3-3 octave=7.3.0-2
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH HOME=$work OCTAVE_HOME=$work/root/usr OCTAVE_EXEC_HOME=$work/root/usr

cat >check.m <<'M'
warning("off", "all");
addpath(genpath("root/usr/share/octave/packages/nurbs-1.4.3"));
addpath(genpath("root/usr/lib/x86_64-linux-gnu/octave/packages/nurbs-1.4.3"));

% Length of the part of a curve between two parameters.
function result = span(curve, first, last)
  result = sum(sqrt(sum(diff(nrbeval(curve, linspace(first, last, 2001)), 1, 2) .^ 2)));
end

function iges(name, curve)
  nrb2iges(curve, "out.igs");
  lines = strsplit(fileread("out.igs"), "\n");
  text = "";
  for i = 1:numel(lines)
    if numel(lines{i}) > 73 && lines{i}(73) == "P"
      text = [text strtrim(lines{i}(1:64))];
    end
  end
  values = str2num(strrep(text, ";", ""));
  count = values(2) + 1;
  order = values(3) + 1;
  range = values(7 + count + order + 4 * count + (1:2));
  printf("%s: knots %s, V(0) %g, V(1) %g, length %.2f of %.2f\n", name, mat2str(curve.knots), range, ...
    span(curve, range(1), range(2)), span(curve, curve.knots(order), curve.knots(end - order + 1)));
end

function attempt(name, task)
  try
    printf("%s: %.3f\n", name, task());
  catch
    printf("%s: error\n", name);
  end
end

joined = nrbglue(nrbline([0 0], [10 0]), nrbline([10 0], [10 20]));
iges("joined lines", joined);
iges("quarter circle", nrbmak(nrbcirc(5, [0 0], 0, pi / 2).coefs, [0 0 0 7 7 7]));
attempt("nrbmeasure, 0 to 1", @() nrbmeasure(joined, 0, 1));
attempt("nrbmeasure, 0 to 2", @() nrbmeasure(joined, 0, 2));

curve = nrbmak([0 5 10 15; 0 10 0 5; 0 0 0 0], [0 0 0 0.5 1 1 1]);
loose = nrbunclamp(curve);
printf("unclamped: knots %s\n", mat2str(loose.knots));
forms = {"clamped", curve, "unclamped", loose, "knot inserted", nrbkntins(loose, 0.25), "clamped again", nrbclamp(loose)};
for i = 1:2:numel(forms)
  points = nrbeval(forms{i + 1}, [0 1]);
  printf("%s: from %.2f,%.2f to %.2f,%.2f, length %.3f\n", forms{i}, points(1:2, :), span(forms{i + 1}, 0, 1));
end
for i = 1:2:3
  attempt(["nrbmeasure, " forms{i}], @() nrbmeasure(forms{i + 1}));
  attempt(["nrbdegelev, " forms{i}], @() span(nrbdegelev(forms{i + 1}, 1), 0, 1));
  back = nrbreverse(forms{i + 1});
  printf("nrbreverse, %s: range %g to %g\n", forms{i}, back.knots(3), back.knots(end - 2));
end
M
(root/usr/bin/octave-cli --no-init-file --no-gui check.m 2>/dev/null || true) | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
joined lines: knots [0 0 1 2 2], V(0) 0, V(1) 1, length 10.00 of 30.00
quarter circle: knots [0 0 0 7 7 7], V(0) 0, V(1) 1, length 1.05 of 7.85
nrbmeasure, 0 to 1: 30.000
nrbmeasure, 0 to 2: error
unclamped: knots [-1 -0.5 0 0.5 1 1.5 2]
clamped: from 0.00,0.00 to 15.00,5.00, length 21.051
unclamped: from 0.00,0.00 to 15.00,5.00, length 21.051
knot inserted: from 0.00,0.00 to 15.00,5.00, length 21.051
clamped again: from 0.00,0.00 to 15.00,5.00, length 21.051
nrbmeasure, clamped: 21.051
nrbdegelev, clamped: 21.051
nrbreverse, clamped: range 0 to 1
nrbmeasure, unclamped: error
nrbdegelev, unclamped: error
nrbreverse, unclamped: range 1 to 2
EXPECTED
