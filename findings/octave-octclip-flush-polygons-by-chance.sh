#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, octave-octclip 2.0.3-1, octave 7.3.0-2 (Boolean operations of polygons in Octave).
# Input:    a U of 30 x 20 with a slot of 10 x 10, and a bar of 30 x 5 whose ends and top are flush with the U; a square of
#           10, alone or with a square inside, around or far away. Source: help of oc_polybool ("poly: ... the third column is a
#           mark identifying if the polygon is a hole (value 0) or not (value 1)", "relevant only in the case of the OR
#           operation", npert: "perturbed points of the clip polygon if any particular case (points in the border of the other
#           polygon) occurs").
# Expected: Each call gives the same: the union has the area 600 and a hole of 50, the intersection two parts of 50. The
#           polygons of the other unions are no holes.
# Seen:     The result changes from call to call. About half of the calls are wrong, without an error: the union is 550 or 475,
#           a part of the intersection 575, which is larger than the bar. A call takes 4 seconds. With a wider bar, the
#           result is right. The unions of two squares that do not cross, one inside the other or apart, consist of holes only.

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
fetch octave-octclip=2.0.3-1 octave=7.3.0-2
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH HOME=$work OCTAVE_HOME=$work/root/usr OCTAVE_EXEC_HOME=$work/root/usr

cat >check.m <<'M'
warning("off", "all");
addpath(glob([getenv("OCTAVE_HOME") "/share/octave/packages/octclip-*"]){1});
addpath(glob([getenv("OCTAVE_HOME") "/lib/*/octave/packages/octclip-*/*"]){1});

% Areas of the result, largest first.
function areas = areas_of(subject, clip, operation)
  [points, details] = oc_polybool(subject, clip, operation);
  areas = [];
  for range = details.poly'
    loop = points(range(1):range(2), :);
    areas(end + 1) = abs(sum(loop(:, 1) .* shift(loop(:, 2), -1) - loop(:, 2) .* shift(loop(:, 1), -1))) / 2;
  end
  areas = sort(areas(areas > 1e-6), "descend");
end

u = [0 0; 30 0; 30 20; 20 20; 20 10; 10 10; 10 20; 0 20];
bar = [0 15; 30 15; 30 20; 0 20];
expected = {"OR", [600 50]; "AND", [50 50]};
for row = expected'
  wrong = false;
  for call = 1:40
    areas = areas_of(u, bar, row{1});
    if numel(areas) ~= numel(row{2}) || norm(areas - row{2}) > 1e-6
      wrong = true;
      break;
    end
  end
  printf("%s of U and flush bar: one of 40 calls is wrong: %d\n", row{1}, wrong);
end
printf("OR of U and wider bar: %s\n", mat2str(areas_of(u, [-5 15; 35 15; 35 25; -5 25], "OR")));

square = [0 0; 10 0; 10 10; 0 10];
for other = {{"far away", square + 30}, {"inside", square / 2 + 2}, {"around", square * 3 - 5}, {"across", square + 5}}
  [points, details] = oc_polybool(square, other{1}{2}, "OR");
  printf("union of a square and a square %s: %s, marks %s\n", other{1}{1}, ...
         mat2str(areas_of(square, other{1}{2}, "OR")), mat2str(details.poly(:, 3)'));
end
M
root/usr/bin/octave-cli --no-gui --quiet check.m 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
OR of U and flush bar: one of 40 calls is wrong: 1
AND of U and flush bar: one of 40 calls is wrong: 1
OR of U and wider bar: [850 50]
union of a square and a square far away: [100 100], marks [0 0]
union of a square and a square inside: 100, marks 0
union of a square and a square around: 900, marks 0
union of a square and a square across: 175, marks 1
EXPECTED
