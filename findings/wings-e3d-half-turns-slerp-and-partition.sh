#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, wings3d 2.2.9-2+b1 (its Erlang library e3d), erlang-base 1:25.2.3+dfsg-1+deb12u4.
# Input:    half turns about six axes as matrices; turns about Z by 0.5 to 90 degrees; a mesh of two separate triangles.
#           Source: e3d_q.erl ("Operations on unit quaternions"), e3d_mesh.erl (partition: "Partitions a mesh in disjoint
#           sub-meshes"); mathematics of spherical interpolation.
# Expected: from_rotation_matrix returns a unit quaternion that moves the point 3,1,2 as the matrix does. slerp with the
#           parameter 1 returns the second quaternion, with 0.5 half of the angle. The mesh has two parts.
# Seen:     Half turns about X and 2,1,0 are right. About Y and Z the point shrinks to a quarter, the half turn about 1,2,0
#           becomes one about 2,1,0, and about 1,2,3 the point moves to -1.05,5.84,-0.39. At 179.99 degrees all are right.
#           slerp never leaves its start if the turn is smaller than 1.62 degrees. partition returns three meshes, the
#           first of which is empty.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Extracts pinned Debian 12 packages into ./root, without installation.
fetch() {
  mkdir -p deb root
  (cd deb && apt-get download "$@" >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch wings3d=2.2.9-2+b1 erlang-base=1:25.2.3+dfsg-1+deb12u4
erlang=$work/root/usr/lib/erlang
export HOME=$work ROOTDIR=$erlang EMU=beam PROGNAME=erl
BINDIR=$(echo "$erlang"/erts-*/bin)
export BINDIR

cat >check.erl <<'ERL'
-module(check).
-export([main/0]).

%% Records of e3d.hrl of Wings 3D.
-record(e3d_face, {vs = [], vc = [], tx = [], ns = [], mat = [], sg = 1, vis = -1}).
-record(e3d_mesh, {type = triangle, vs = [], vc = [], tx = [], ns = [], fs = [], he = [], matrix = identity}).

text({X, Y, Z}) ->
    [string:join([case io_lib:format("~.2f", [V]) of ["-0.00"] -> "0.00"; S -> lists:flatten(S) end || V <- [X, Y, Z]], ",")].

half_turn(Angle, Axis) ->
    Point = {3.0, 1.0, 2.0},
    Matrix = e3d_mat:rotate(Angle, e3d_vec:norm(Axis)),
    Quaternion = e3d_q:from_rotation_matrix(Matrix),
    io:format("~.2f degrees about ~s: matrix ~s, quaternion ~s, magnitude ~.2f~n",
              [Angle, text(Axis), text(e3d_mat:mul_point(Matrix, Point)), text(e3d_q:vec_rotate(Point, Quaternion)),
               e3d_q:magnitude(Quaternion)]).

slerp(Angle) ->
    Second = e3d_q:from_angle_axis(Angle, {0.0, 0.0, 1.0}),
    [Half, Full] = [element(1, e3d_q:to_angle_axis(e3d_q:slerp(e3d_q:identity(), Second, T))) || T <- [0.5, 1.0]],
    io:format("slerp of a turn by ~.2f degrees: ~.2f at 0.5, ~.2f at 1~n", [Angle, Half, Full]).

main() ->
    [half_turn(Angle, Axis) || Angle <- [180.0, 179.99],
                               Axis <- [{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {2.0, 1.0, 0.0}, {1.0, 2.0, 0.0},
                                        {1.0, 2.0, 3.0}]],
    [slerp(Angle) || Angle <- [0.5, 1.0, 1.6, 1.65, 5.0, 90.0]],
    Mesh = #e3d_mesh{vs = [{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                           {11.0, 0.0, 0.0}, {11.0, 1.0, 0.0}, {10.0, 1.0, 0.0}],
                     fs = [#e3d_face{vs = [0, 1, 2]}, #e3d_face{vs = [3, 4, 5]}]},
    io:format("faces of the parts: ~p~n", [[length(Part#e3d_mesh.fs) || Part <- e3d_mesh:partition(Mesh)]]).
ERL
"$BINDIR/erlexec" -noshell -boot "$erlang/bin/start_clean" -pa "$erlang/lib/wings-2.2.9/ebin" \
  -eval '{ok, check} = compile:file("check.erl"), code:add_path("."), check:main(), halt().' 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
180.00 degrees about 1.00,0.00,0.00: matrix 3.00,-1.00,-2.00, quaternion 3.00,-1.00,-2.00, magnitude 1.00
180.00 degrees about 0.00,1.00,0.00: matrix -3.00,1.00,-2.00, quaternion -0.75,0.25,-0.50, magnitude 0.50
180.00 degrees about 0.00,0.00,1.00: matrix -3.00,-1.00,2.00, quaternion -0.75,-0.25,0.50, magnitude 0.50
180.00 degrees about 2.00,1.00,0.00: matrix 2.60,1.80,-2.00, quaternion 2.60,1.80,-2.00, magnitude 1.00
180.00 degrees about 1.00,2.00,0.00: matrix -1.00,3.00,-2.00, quaternion 2.60,1.80,-2.00, magnitude 1.00
180.00 degrees about 1.00,2.00,3.00: matrix -1.43,2.14,2.71, quaternion -1.05,5.84,-0.39, magnitude 1.26
179.99 degrees about 1.00,0.00,0.00: matrix 3.00,-1.00,-2.00, quaternion 3.00,-1.00,-2.00, magnitude 1.00
179.99 degrees about 0.00,1.00,0.00: matrix -3.00,1.00,-2.00, quaternion -3.00,1.00,-2.00, magnitude 1.00
179.99 degrees about 0.00,0.00,1.00: matrix -3.00,-1.00,2.00, quaternion -3.00,-1.00,2.00, magnitude 1.00
179.99 degrees about 2.00,1.00,0.00: matrix 2.60,1.80,-2.00, quaternion 2.60,1.80,-2.00, magnitude 1.00
179.99 degrees about 1.00,2.00,0.00: matrix -1.00,3.00,-2.00, quaternion -1.00,3.00,-2.00, magnitude 1.00
179.99 degrees about 1.00,2.00,3.00: matrix -1.43,2.14,2.71, quaternion -1.43,2.14,2.71, magnitude 1.00
slerp of a turn by 0.50 degrees: 0.00 at 0.5, 0.00 at 1
slerp of a turn by 1.00 degrees: 0.00 at 0.5, 0.00 at 1
slerp of a turn by 1.60 degrees: 0.00 at 0.5, 0.00 at 1
slerp of a turn by 1.65 degrees: 0.83 at 0.5, 1.65 at 1
slerp of a turn by 5.00 degrees: 2.50 at 0.5, 5.00 at 1
slerp of a turn by 90.00 degrees: 45.00 at 0.5, 90.00 at 1
faces of the parts: [0,1,1]
EXPECTED
