#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libcurvesapi-java 1.06-1 (com.graphbuilder.curve). A JDK 17 is installed.
# Input:    paths of one, two and three sides of a square, of two separate lines, and of two lines in space; points on, near and far from
#           the path. The script compares MultiPath.getDistSq with the smallest Geom.ptSegDistSq of the same sides, and in the plane with
#           ShapeMultiPath.getDistSq. Both classes contain the same points.
# Expected: The squares of the distances are equal. A point on the path has the distance 0.
# Seen:     After the first side, MultiPath measures to lines from the first point of the path instead of the sides: on an L from 0,0
#           over 10,0 to 10,10, the point 5,5 in the air has the distance 0, and the point 10,5 on the path 3.54. ShapeMultiPath
#           and paths of one side are right. The second of two separate lines also begins at the first point. In space, the middle
#           of the second side has the distance 2.24, and a point 2.5 from both sides has 0.

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
fetch libcurvesapi-java=1.06-1
path=.:root/usr/share/java/curvesapi.jar

cat >Check.java <<'JAVA'
import com.graphbuilder.curve.MultiPath;
import com.graphbuilder.curve.ShapeMultiPath;
import com.graphbuilder.geom.Geom;
import java.util.Locale;

public class Check {
    // Each piece is a list of points.
    static void measure(String name, double[][][] pieces, double[][] points) {
        int dimension = points[0].length;
        MultiPath path = new MultiPath(dimension);
        ShapeMultiPath shape = new ShapeMultiPath();
        for (double[][] piece : pieces) {
            for (int i = 0; i < piece.length; ++i) {
                if (i == 0) path.moveTo(piece[i]); else path.lineTo(piece[i]);
                if (i == 0) shape.moveTo(piece[i]); else shape.lineTo(piece[i]);
            }
        }
        for (double[] p : points) {
            double best = Double.MAX_VALUE;
            for (double[][] piece : pieces)
                for (int i = 1; i < piece.length; ++i)
                    best = Math.min(best, Geom.ptSegDistSq(piece[i - 1], piece[i], p, new double[dimension + 1], dimension));
            String text = String.format(Locale.ROOT, "%s, %s: MultiPath %.2f, sides %.2f", name, java.util.Arrays.toString(p),
                Math.sqrt(path.getDistSq(p)), Math.sqrt(best));
            if (dimension == 2) text += String.format(Locale.ROOT, ", ShapeMultiPath %.2f", Math.sqrt(shape.getDistSq(p[0], p[1])));
            System.out.println(text);
        }
    }

    public static void main(String[] arguments) {
        double[] a = {0, 0}, b = {10, 0}, c = {10, 10}, d = {0, 10};
        double[][] points = {{5, 0}, {10, 5}, {5, 5}, {5, 3}, {20, 5}};
        measure("one side", new double[][][] {{a, b}}, points);
        measure("L", new double[][][] {{a, b, c}}, points);
        measure("U", new double[][][] {{a, b, c, d}}, points);
        measure("two lines", new double[][][] {{a, b}, {d, c}}, points);
        double[][] space = {{0, 0, 0}, {10, 0, 0}, {10, 0, 5}};
        measure("in space", new double[][][] {space}, new double[][] {{10, 0, 0}, {10, 0, 2.5}, {5, 0, 2.5}});
    }
}
JAVA
javac -cp "$path" Check.java
java -cp "$path" Check | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
one side, [5.0, 0.0]: MultiPath 0.00, sides 0.00, ShapeMultiPath 0.00
one side, [10.0, 5.0]: MultiPath 5.00, sides 5.00, ShapeMultiPath 5.00
one side, [5.0, 5.0]: MultiPath 5.00, sides 5.00, ShapeMultiPath 5.00
one side, [5.0, 3.0]: MultiPath 3.00, sides 3.00, ShapeMultiPath 3.00
one side, [20.0, 5.0]: MultiPath 11.18, sides 11.18, ShapeMultiPath 11.18
L, [5.0, 0.0]: MultiPath 0.00, sides 0.00, ShapeMultiPath 0.00
L, [10.0, 5.0]: MultiPath 3.54, sides 0.00, ShapeMultiPath 0.00
L, [5.0, 5.0]: MultiPath 0.00, sides 5.00, ShapeMultiPath 5.00
L, [5.0, 3.0]: MultiPath 1.41, sides 3.00, ShapeMultiPath 3.00
L, [20.0, 5.0]: MultiPath 11.18, sides 10.00, ShapeMultiPath 10.00
U, [5.0, 0.0]: MultiPath 0.00, sides 0.00, ShapeMultiPath 0.00
U, [10.0, 5.0]: MultiPath 3.54, sides 0.00, ShapeMultiPath 0.00
U, [5.0, 5.0]: MultiPath 0.00, sides 5.00, ShapeMultiPath 5.00
U, [5.0, 3.0]: MultiPath 1.41, sides 3.00, ShapeMultiPath 3.00
U, [20.0, 5.0]: MultiPath 11.18, sides 10.00, ShapeMultiPath 10.00
two lines, [5.0, 0.0]: MultiPath 0.00, sides 0.00, ShapeMultiPath 0.00
two lines, [10.0, 5.0]: MultiPath 3.54, sides 5.00, ShapeMultiPath 5.00
two lines, [5.0, 5.0]: MultiPath 0.00, sides 5.00, ShapeMultiPath 5.00
two lines, [5.0, 3.0]: MultiPath 1.41, sides 3.00, ShapeMultiPath 3.00
two lines, [20.0, 5.0]: MultiPath 11.18, sides 11.18, ShapeMultiPath 11.18
in space, [10.0, 0.0, 0.0]: MultiPath 0.00, sides 0.00
in space, [10.0, 0.0, 2.5]: MultiPath 2.24, sides 0.00
in space, [5.0, 0.0, 2.5]: MultiPath 0.00, sides 2.50
EXPECTED
