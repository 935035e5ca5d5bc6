#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, librust-pathfinder-geometry-dev 0.5.1-1+b1 and librust-pathfinder-simd-dev 0.5.1-1+b1 (geometry of the
#           rasterizer Pathfinder, in Rust). The script calls rustc.
# Input:    a 2D turn by 30 degrees as a 3D transform; a scale of 2,1, a turn by 90 degrees and a move by 5,0 in one call; a
#           camera at 0,-10,10 that looks at the origin with Z up; 1/4 of the way between two moves. Source: documentation of
#           the crate (translation, rotation: "assumes that scale, rotation, and translation are applied in that order";
#           looking_at: "Just like gluLookAt()"; lerp: "Linearly interpolate between transforms").
# Expected: The 3D form moves a point like the 2D form and keeps its z. The combined transform has the translation 5,0. The
#           camera moves rigidly: distances remain. At the weight 0 the result is the first move, as in Vector2F::lerp.
# Seen:     The 3D form turns clockwise and makes each z 0. The call with scale, angle and move applies the move first: the
#           translation is 0,5. X of the camera is shortened by the sine of the angle between up and the direction of view: 10
#           becomes 7.07, and 10 if up is perpendicular. lerp of transforms runs backwards: the weight 0.25 gives 6 instead of
#           2.

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
fetch librust-pathfinder-geometry-dev=0.5.1-1+b1 librust-pathfinder-simd-dev=0.5.1-1+b1
sources=root/usr/share/cargo/registry

cat >check.rs <<'RS'
use pathfinder_geometry::transform2d::Transform2F;
use pathfinder_geometry::transform3d::Transform4F;
use pathfinder_geometry::vector::{vec2f, Vector2F, Vector3F, Vector4F};

fn text(values: &[f32]) -> String {
    values.iter().map(|v| format!("{:.2}", if v.abs() < 5e-3 { 0.0 } else { *v })).collect::<Vec<_>>().join(",")
}
fn flat(p: Vector2F) -> String {
    text(&[p.x(), p.y()])
}
fn space(p: Vector4F) -> String {
    text(&[p.x(), p.y(), p.z()])
}

fn main() {
    let degree = std::f32::consts::PI / 180.0;
    let turn = Transform2F::from_rotation(30.0 * degree);
    println!("2,0 turned by 30 degrees: {}", flat(turn * vec2f(2.0, 0.0)));
    println!("  2,0,7 by the 3D form: {}", space(turn.to_3d() * Vector4F::new(2.0, 0.0, 7.0, 1.0)));

    let combined = Transform2F::from_scale_rotation_translation(vec2f(2.0, 1.0), 90.0 * degree, vec2f(5.0, 0.0));
    let steps = Transform2F::from_scale(vec2f(2.0, 1.0)).rotate(90.0 * degree).translate(vec2f(5.0, 0.0));
    for (name, t) in [("in one call", combined), ("in three calls", steps)] {
        println!("scale, turn and move {}: translation {}, 1,0 to {}, 0,1 to {}", name, flat(t.translation()),
                 flat(t * vec2f(1.0, 0.0)), flat(t * vec2f(0.0, 1.0)));
    }

    for up in [Vector3F::new(0.0, 0.0, 1.0), Vector3F::new(0.0, 1.0, 1.0)] {
        let camera = Transform4F::looking_at(Vector3F::new(0.0, -10.0, 10.0), Vector3F::new(0.0, 0.0, 0.0), up);
        println!("camera, up {}: 10,0,0 to {}, 0,1,1 to {}", text(&[up.x(), up.y(), up.z()]),
                 space(camera * Vector4F::new(10.0, 0.0, 0.0, 1.0)), space(camera * Vector4F::new(0.0, 1.0, 1.0, 1.0)));
    }

    let (first, second) = (vec2f(0.0, 0.0), vec2f(8.0, 0.0));
    let of = |p: Vector2F| Transform4F::from_translation(p.to_4d());
    for weight in [0.0, 0.25, 1.0] {
        println!("weight {}: vector {}, transform {}", weight, flat(first.lerp(second, weight)),
                 space(of(first).lerp(weight, &of(second)) * Vector4F::new(0.0, 0.0, 0.0, 1.0)));
    }
}
RS
build() {
  rustc --edition 2018 --cap-lints allow -C opt-level=1 -L . "$@" 2>log || { cat log >&2; exit 2; }
}
build --crate-type rlib --crate-name pathfinder_simd "$sources/pathfinder_simd-0.5.1/src/lib.rs"
build --crate-type rlib --crate-name pathfinder_geometry "$sources/pathfinder_geometry-0.5.1/src/lib.rs" --extern pathfinder_simd
build check.rs --extern pathfinder_geometry
./check 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
2,0 turned by 30 degrees: 1.73,1.00
  2,0,7 by the 3D form: 1.73,-1.00,0.00
scale, turn and move in one call: translation 0.00,5.00, 1,0 to 0.00,6.00, 0,1 to -2.00,5.00
scale, turn and move in three calls: translation 5.00,0.00, 1,0 to 5.00,2.00, 0,1 to 4.00,0.00
camera, up 0.00,0.00,1.00: 10,0,0 to 7.07,0.00,-14.14, 0,1,1 to 0.00,1.41,-14.14
camera, up 0.00,1.00,1.00: 10,0,0 to 10.00,0.00,-14.14, 0,1,1 to 0.00,1.41,-14.14
weight 0: vector 0.00,0.00, transform 8.00,0.00,0.00
weight 0.25: vector 2.00,0.00, transform 6.00,0.00,0.00
weight 1: vector 8.00,0.00, transform 0.00,0.00,0.00
EXPECTED
