#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libghc-diagrams-lib-dev 1.4.5.1-1+b5 (diagrams, a library of Haskell), ghc 9.0.2-4 (about 90 MB are
#           downloaded). The script calls gcc, which links the program.
# Input:    counter-clockwise loops: a square of 10, an L of 20 x 20 and a circle of radius 10, offset by 2 outwards and inwards
#           with each kind of join; the square expanded by 1. Source: documentation of offsetTrail' ("generates a new trail
#           that is always radius 'r' away from the given 'Trail'", "a negative radius gives an inner loop"), of expandTrail'
#           ("the loop that, when filled, represents stroking the trail with a radius 'r' brush").
# Expected: Each point of the offset has the distance 2 from the contour, at corners 2.83 for a mitre and 1.41 for a bevel. The
#           inner loop of the square is a square with the length 24 and the area 36, that of the L has the length 64 and the
#           area 156.
# Seen:     Outwards, the square and the circle are right; at the inner corner of the L, the distance is 0. Inwards, the offset
#           of each side keeps its full length, and a spur joins it to the next at the corner: the length is 56, and the distance
#           0, so a cutter of radius 2 on this path cuts into each side at its ends. With round joins the area is -17.71. The
#           inner loop of the expanded square reaches the contour. Inwards, the circle is right.

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
fetch libghc-diagrams-lib-dev=1.4.5.1-1+b5 ghc=9.0.2-4
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH

# Moves the package database of GHC from /usr to ./root/usr.
compiler=$work/root/usr/lib/ghc
rm "$compiler/package.conf.d"
mkdir "$compiler/package.conf.d"
for package in root/var/lib/ghc/package.conf.d/*.conf; do
  sed "s,/usr/,$work/root/usr/,g; s,\${pkgroot},$compiler,g" "$package" >"$compiler/package.conf.d/${package##*/}"
done
"$compiler/bin/ghc-pkg" --global-package-db="$compiler/package.conf.d" recache 2>log

cat >Check.hs <<'HS'
import Diagrams.Prelude
import Diagrams.TwoD.Offset
import Text.Printf

type Contour = Path V2 Double

-- Points on a contour, 100 for each segment.
points :: Contour -> [P2 Double]
points contour = [s `atParam` (fromIntegral i / 100) | t <- pathTrails contour, s <- fixTrail t, i <- [0 .. 99 :: Int]]

area :: [P2 Double] -> Double
area ps = sum (zipWith cross2 vs (tail ps ++ [head ps])) / 2
  where
    vs = ps
    cross2 p q = let (V2 a b, V2 c d) = (p .-. origin, q .-. origin) in a * d - b * c

clearanceOf :: [P2 Double] -> P2 Double -> Double
clearanceOf contour p = minimum [norm (p .-. q) | q <- contour]

report :: String -> Contour -> Contour -> IO ()
report name contour result =
  printf "%s: loops %d, length %.2f, area %.2f, distance %.2f to %.2f\n" name (length (pathTrails result))
    (sum (map stdArcLength (pathTrails result)) :: Double) (area (points result)) (minimum distances) (maximum distances)
  where
    distances = map (clearanceOf (points contour)) (points result)

ell :: Contour
ell = Path [closeTrail (fromOffsets [V2 20 0, V2 0 10, V2 (-10) 0, V2 0 10, V2 (-10) 0]) `at` origin]

main :: IO ()
main = do
  let joins = [("mitre", LineJoinMiter), ("round", LineJoinRound), ("bevel", LineJoinBevel)]
      shapes = [("square", square 10), ("L", ell), ("circle", circle 10)]
  sequence_
    [ report (printf "%s by %.0f, %s" shape r join) contour (offsetPath' (with & offsetJoin .~ kind) r contour)
    | (shape, contour) <- shapes, r <- [2, -2], (join, kind) <- joins ]
  report "square expanded by 1" (square 10) (expandPath 1 (square 10))
HS
"$compiler/bin/ghc" -B"$compiler" -v0 Check.hs -o check 2>log || { cat log >&2; exit 2; }
./check | sed 's/-0\.00/0.00/g' | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
square by 2, mitre: loops 1, length 56.00, area 196.00, distance 2.00 to 2.83
square by 2, round: loops 1, length 52.57, area 192.57, distance 2.00 to 2.00
square by 2, bevel: loops 1, length 51.31, area 188.00, distance 1.41 to 2.00
square by -2, mitre: loops 1, length 56.00, area 36.00, distance 0.00 to 2.00
square by -2, round: loops 1, length 77.70, area -17.71, distance 0.00 to 2.00
square by -2, bevel: loops 1, length 51.31, area 28.00, distance 0.00 to 2.00
L by 2, mitre: loops 1, length 102.83, area 478.00, distance 0.00 to 2.83
L by 2, round: loops 1, length 105.14, area 485.14, distance 0.00 to 2.00
L by 2, bevel: loops 1, length 96.97, area 468.00, distance 0.00 to 2.00
L by -2, mitre: loops 1, length 102.83, area 158.00, distance 0.00 to 2.00
L by -2, round: loops 1, length 130.27, area 89.72, distance 0.00 to 2.00
L by -2, bevel: loops 1, length 96.97, area 148.00, distance 0.00 to 2.00
circle by 2, mitre: loops 1, length 75.40, area 452.35, distance 2.00 to 2.00
circle by 2, round: loops 1, length 75.40, area 452.35, distance 2.00 to 2.00
circle by 2, bevel: loops 1, length 75.40, area 452.35, distance 2.00 to 2.00
circle by -2, mitre: loops 1, length 50.28, area 201.21, distance 2.00 to 2.00
circle by -2, round: loops 1, length 50.28, area 201.21, distance 2.00 to 2.00
circle by -2, bevel: loops 1, length 50.28, area 201.21, distance 2.00 to 2.00
square expanded by 1: loops 2, length 96.00, area 79.89, distance 0.00 to 1.41
EXPECTED
