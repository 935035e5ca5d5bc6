#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, librust-lyon-geom-dev 0.15.0-2, librust-euclid-dev 0.20.0-1, librust-num-traits-dev 0.2.15-1,
#           librust-arrayvec-dev 0.7.2-2 (lyon_geom: arcs and curves in Rust). The script calls rustc, of any version since 1.51.
# Input:    arcs of the radius 10, counter-clockwise and clockwise, and arcs of an ellipse of 10 x 5, turned by 30 degrees, with the
#           centre 100,50. Each is compared with 2001 samples of the arc itself. Source: documentation of Arc (to_svg_arc:
#           "Convert to the SVG arc notation"; for_each_flattened: "Approximates the arc with a sequence of line segments";
#           bounding_rect and fast_bounding_rect: "Returns a conservative rectangle that contains the curve").
# Expected: The SVG arc is the same arc. In the other direction, an arc has the same length and bounding box. Flattened with the
#           tolerance 0.01, a quarter arc has the length 15.70 in both directions. Each rectangle contains the arc.
# Seen:     The flags of the SVG arc are exchanged: an arc of 90 degrees becomes one of -270 degrees, -200 becomes 160. A
#           clockwise arc is flattened to its chord: the quarter has the length 14.14. The bounding box of clockwise arcs
#           omits their extrema, so the arc from 135 to 45 degrees leaves its box. The fast rectangle of the turned ellipse is
#           turned around the origin and does not touch the arc. bounding_rect of counter-clockwise arcs is right.

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
fetch librust-lyon-geom-dev=0.15.0-2 librust-euclid-dev=0.20.0-1 librust-num-traits-dev=0.2.15-1 librust-arrayvec-dev=0.7.2-2
sources=root/usr/share/cargo/registry

cat >check.rs <<'RS'
use lyon_geom::euclid::default::{Point2D, Rect, Vector2D};
use lyon_geom::euclid::Angle;
use lyon_geom::Arc;

type Point = Point2D<f64>;

fn text(low: Point, high: Point) -> String {
    format!("{:.1},{:.1} to {:.1},{:.1}", low.x + 0.0, low.y + 0.0, high.x + 0.0, high.y + 0.0)
}

fn rectangle(r: Rect<f64>) -> String {
    text(r.origin, r.origin + r.size.to_vector())
}

fn report(center: (f64, f64), radii: (f64, f64), start: f64, sweep: f64, rotation: f64) {
    let arc = Arc {
        center: Point::new(center.0, center.1),
        radii: Vector2D::new(radii.0, radii.1),
        start_angle: Angle::degrees(start),
        sweep_angle: Angle::degrees(sweep),
        x_rotation: Angle::degrees(rotation),
    };
    let (mut length, mut last) = (0.0, arc.from());
    let (mut low, mut high) = (last, last);
    for i in 1..=2000 {
        let point = arc.sample(i as f64 / 2000.0);
        length += (point - last).length();
        last = point;
        low = Point::min(low, point);
        high = Point::max(high, point);
    }
    let mut pieces = 0;
    arc.for_each_flattened(0.01, &mut |_| pieces += 1);
    let svg = arc.to_svg_arc();
    println!("arc from {} by {}: SVG flags {} {}, again {:.0}", start, sweep, svg.flags.large_arc as u8, svg.flags.sweep as u8,
             svg.to_arc().sweep_angle.to_degrees());
    println!("  flattened: {} pieces, length {:.2}, sampled {:.2}", pieces, arc.approximate_length(0.01), length);
    println!("  box {}, sampled {}, fast {}", rectangle(arc.bounding_rect()), text(low, high), rectangle(arc.fast_bounding_rect()));
}

fn main() {
    for &(start, sweep) in &[(0.0, 90.0), (90.0, -90.0), (45.0, 90.0), (135.0, -90.0), (0.0, 270.0), (270.0, -270.0)] {
        report((0.0, 0.0), (10.0, 10.0), start, sweep, 0.0);
    }
    report((100.0, 50.0), (10.0, 5.0), 0.0, 200.0, 30.0);
    report((100.0, 50.0), (10.0, 5.0), 200.0, -200.0, 30.0);
}
RS
build() {
  rustc --cap-lints allow -L . "$@" 2>log || { cat log >&2; exit 2; }
}
library() {
  name=$1
  shift
  build --crate-type rlib --crate-name "$name" "$@"
}
library num_traits --edition 2015 --cfg 'feature="std"' --cfg has_i128 $sources/num-traits-0.2.15/src/lib.rs
library arrayvec --edition 2018 --cfg 'feature="std"' $sources/arrayvec-0.7.2/src/lib.rs
library euclid --edition 2015 --extern num_traits=libnum_traits.rlib $sources/euclid-0.20.0/src/lib.rs
library lyon_geom --edition 2018 --extern num_traits=libnum_traits.rlib --extern arrayvec=libarrayvec.rlib \
  --extern euclid=libeuclid.rlib $sources/lyon_geom-0.15.0/src/lib.rs
build --edition 2018 --extern lyon_geom=liblyon_geom.rlib check.rs
./check | sed 's/-0\.0\b/0.0/g' | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
arc from 0 by 90: SVG flags 1 0, again -270
  flattened: 18 pieces, length 15.70, sampled 15.71
  box 0.0,0.0 to 10.0,10.0, sampled 0.0,0.0 to 10.0,10.0, fast -10.0,-10.0 to 10.0,10.0
arc from 90 by -90: SVG flags 0 0, again -90
  flattened: 1 pieces, length 14.14, sampled 15.71
  box 0.0,0.0 to 10.0,10.0, sampled 0.0,0.0 to 10.0,10.0, fast -10.0,-10.0 to 10.0,10.0
arc from 45 by 90: SVG flags 1 0, again -270
  flattened: 18 pieces, length 15.70, sampled 15.71
  box -7.1,7.1 to 7.1,10.0, sampled -7.1,7.1 to 7.1,10.0, fast -10.0,-10.0 to 10.0,10.0
arc from 135 by -90: SVG flags 0 0, again -90
  flattened: 1 pieces, length 14.14, sampled 15.71
  box -7.1,0.0 to 7.1,7.1, sampled -7.1,7.1 to 7.1,10.0, fast -10.0,-10.0 to 10.0,10.0
arc from 0 by 270: SVG flags 1 1, again 270
  flattened: 53 pieces, length 47.11, sampled 47.12
  box -10.0,-10.0 to 10.0,10.0, sampled -10.0,-10.0 to 10.0,10.0, fast -10.0,-10.0 to 10.0,10.0
arc from 270 by -270: SVG flags 0 1, again 90
  flattened: 1 pieces, length 14.14, sampled 47.12
  box 0.0,-10.0 to 10.0,10.0, sampled -10.0,-10.0 to 10.0,10.0, fast -10.0,-10.0 to 10.0,10.0
arc from 0 by 200: SVG flags 1 1, again 200
  flattened: 35 pieces, length 26.05, sampled 26.07
  box 91.0,43.8 to 108.7,56.6, sampled 91.0,43.8 to 108.7,56.6, fast 100.4,-16.0 to 122.8,2.6
arc from 200 by -200: SVG flags 0 1, again 160
  flattened: 1 pieces, length 19.47, sampled 26.07
  box 92.7,43.8 to 108.7,55.0, sampled 91.0,43.8 to 108.7,56.6, fast 100.4,-16.0 to 122.8,2.6
EXPECTED
