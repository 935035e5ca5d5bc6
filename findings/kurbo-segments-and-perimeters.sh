#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, librust-kurbo-dev 0.7.1-4, librust-arrayvec-dev 0.7.2-2 (kurbo: curves in Rust). The script calls rustc,
#           of any version since 1.51.
# Input:    ring segments with the radii 10 and 5: from 0 by 90 degrees, from 0 by -90, from 315 by 90; an ellipse with the
#           half axes 10 and 5; an arc of 90 degrees with the radius 10. The values of the shape itself are compared with
#           the values of its path with the tolerance 1e-9. Source: documentation of the trait Shape (perimeter(accuracy):
#           "Total length of perimeter", winding: "+1 when the point is inside a positive area shape and -1 when it is inside a
#           negative area shape", bounding_box: "The smallest rectangle that encloses the shape").
# Expected: The shape and its path agree. The perimeter of the ellipse with the accuracy 1e-9 is 48.442241, the length of the
#           arc 15.707963. The bounding box of the first segment is 0,0 to 10,10.
# Seen:     The points of the second and the third segment are outside of the shapes and inside of the paths; the second
#           has the perimeter -13.56. Each segment has the bounding box -10,-10 to 10,10. The accuracy is ignored:
#           the perimeter of the ellipse is 48.449160, the length of the arc 15.710167. Areas are right.

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
fetch librust-kurbo-dev=0.7.1-4 librust-arrayvec-dev=0.7.2-2
sources=root/usr/share/cargo/registry

cat >check.rs <<'RS'
use kurbo::{Arc, CircleSegment, Ellipse, Point, Rect, Shape, Vec2};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

fn text(r: Rect) -> String {
    format!("{:.1},{:.1} to {:.1},{:.1}", r.x0 + 0.0, r.y0 + 0.0, r.x1, r.y1)
}

fn segment(start: f64, sweep: f64, inside: Point) {
    let make = || CircleSegment::new((0.0, 0.0), 10.0, 5.0, start * DEGREE, sweep * DEGREE);
    let (shape, path) = (make(), make().into_path(1e-9));
    println!("segment from {} by {}: area {:.3}, perimeter {:.3}, winding {}, box {}", start, sweep, shape.area(),
             shape.perimeter(1e-9), shape.winding(inside), text(shape.bounding_box()));
    println!("  path: area {:.3}, perimeter {:.3}, winding {}, box {}", path.area(), path.perimeter(1e-9),
             path.winding(inside), text(path.bounding_box()));
}

fn main() {
    segment(0.0, 90.0, Point::new(5.5, 5.5));
    segment(0.0, -90.0, Point::new(5.5, -5.5));
    segment(315.0, 90.0, Point::new(7.0, 0.5));
    let ellipse = Ellipse::new((0.0, 0.0), (10.0, 5.0), 0.5);
    println!("ellipse: perimeter {:.6}, path {:.6}", ellipse.perimeter(1e-9), ellipse.into_path(1e-9).perimeter(1e-9));
    let arc = Arc { center: Point::new(0.0, 0.0), radii: Vec2::new(10.0, 10.0), start_angle: 0.0,
                    sweep_angle: 90.0 * DEGREE, x_rotation: 0.0 };
    println!("arc: length {:.6}, path {:.6}", arc.perimeter(1e-9), arc.into_path(1e-9).perimeter(1e-9));
}
RS
build() {
  rustc --edition 2018 --cap-lints allow "$@" 2>log || { cat log >&2; exit 2; }
}
build --crate-type rlib --crate-name arrayvec --cfg 'feature="std"' $sources/arrayvec-0.7.2/src/lib.rs
build --crate-type rlib --crate-name kurbo --cfg 'feature="std"' --extern arrayvec=libarrayvec.rlib $sources/kurbo-0.7.1/src/lib.rs
build --extern kurbo=libkurbo.rlib -L . check.rs
./check | sed 's/-0\.0,/0.0,/g' | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
segment from 0 by 90: area 58.905, perimeter 33.562, winding 1, box -10.0,-10.0 to 10.0,10.0
  path: area 58.905, perimeter 33.562, winding 1, box 0.0,0.0 to 10.0,10.0
segment from 0 by -90: area -58.905, perimeter -13.562, winding 0, box -10.0,-10.0 to 10.0,10.0
  path: area -58.905, perimeter 33.562, winding -1, box 0.0,-10.0 to 10.0,0.0
segment from 315 by 90: area 58.905, perimeter 33.562, winding 0, box -10.0,-10.0 to 10.0,10.0
  path: area 58.905, perimeter 33.562, winding 1, box 3.5,-7.1 to 10.0,7.1
ellipse: perimeter 48.449160, path 48.442241
arc: length 15.710167, path 15.707963
EXPECTED
