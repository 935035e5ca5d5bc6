#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libgeoregression-java 0.24+ds-1, libejml-java 0.41+ds-2, libddogleg-java 0.22+ds-1 (GeoRegression: geometry
#           in Java). The script calls a JDK 17.
# Input:    the triangle 0,0,0 10,0,0 0,10,0 with points in its plane and 0.001 above; this triangle and a flat one to 2,1,0 with all
#           points with whole X and Y from -20 to 20 at the height 3; segments that cross at the heights 0 and 2 (length 10) or 0.2
#           (length 1). Source: API documentation (Distance3D_F64: "Signed distance from a 3D point to 3D triangle. The sign
#           indicates which side of the triangle the point is on"; ClosestPoint3D_F64: "Closest point from a 3D triangle to a
#           point", "Find the point which minimizes its distance from the two line segments").
# Expected: The distance of 10,10,0 is 7.07, of 5,10,0 it is 3.54, as at the height 0.001. No point of the triangle is nearer than
#           the closest one. The closest point of the segments is between both, at 2.5,0,1 and 0.25,0,0.1.
# Seen:     The distance of each point in the plane of the triangle is 0, even outside of the triangle: the sign 0 is a factor. For
#           the flat triangle, 136 closest points are wrong: for 3,2,3 it is the corner 10,0,0. For segments of length 10, the
#           point is 4,3,2, or 5,0,0 if they are exchanged: a length along the segment is compared with 1, so all segments beyond
#           the length 1 end there. Segments of length 1 are right.

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
fetch libgeoregression-java=0.24+ds-1 libejml-java=0.41+ds-2 libddogleg-java=0.22+ds-1
jars=$(find root/usr/share/java -name '*.jar' | sort | tr '\n' ':')

cat >Check.java <<'JAVA'
import georegression.metric.ClosestPoint3D_F64;
import georegression.metric.Distance3D_F64;
import georegression.struct.line.LineSegment3D_F64;
import georegression.struct.point.Point3D_F64;
import georegression.struct.shapes.Triangle3D_F64;

public class Check {
    static String text(Point3D_F64 p) {
        return String.format("%.2f,%.2f,%.2f", p.x + 0.0, p.y + 0.0, p.z + 0.0);
    }

    static double distance(double x, double y, Point3D_F64 a, Point3D_F64 b) {
        double t = ((x - a.x) * (b.x - a.x) + (y - a.y) * (b.y - a.y)) / a.distance2(b);
        t = Math.max(0, Math.min(1, t));
        return Math.hypot(x - a.x - t * (b.x - a.x), y - a.y - t * (b.y - a.y));
    }

    static void closestPoints(Triangle3D_F64 triangle) {
        Point3D_F64 a = triangle.v0, b = triangle.v1, c = triangle.v2;
        int wrong = 0, all = 0;
        for (int x = -20; x <= 20; x++)
            for (int y = -20; y <= 20; y++, all++) {
                Point3D_F64 found = ClosestPoint3D_F64.closestPoint(a, b, c, new Point3D_F64(x, y, 3), null);
                double boundary = Math.min(distance(x, y, a, b), Math.min(distance(x, y, b, c), distance(x, y, c, a)));
                double d = Math.hypot(found.x - x, found.y - y);
                if (d > boundary + 1e-6) {
                    if (wrong == 0)
                        System.out.printf("closest to %d,%d,3: %s at the distance %.2f in X and Y, boundary at %.2f%n", x, y,
                            text(found), d, boundary);
                    wrong++;
                }
            }
        System.out.printf("triangle to %s: wrong closest points %d of %d%n", text(c), wrong, all);
    }

    public static void main(String[] arguments) {
        Triangle3D_F64 right = new Triangle3D_F64(0, 0, 0, 10, 0, 0, 0, 10, 0);
        double[][] points = {{2, 2}, {10, 10}, {5, 10}, {-3, -4}};
        for (double[] p : points)
            for (double z : new double[] {0, 0.001})
                System.out.printf("distance of %.0f,%.0f,%s: %.2f%n", p[0], p[1], z,
                    Math.abs(Distance3D_F64.distance(right, new Point3D_F64(p[0], p[1], z))));
        closestPoints(right);
        closestPoints(new Triangle3D_F64(0, 0, 0, 10, 0, 0, 2, 1, 0));
        for (double size : new double[] {1, 10}) {
            LineSegment3D_F64 first = new LineSegment3D_F64(0, 0, 0, size, 0, 0);
            LineSegment3D_F64 second = new LineSegment3D_F64(0, -size / 2, size / 5, size / 2, size / 2, size / 5);
            Point3D_F64 point = ClosestPoint3D_F64.closestPoint(first, second, null);
            Point3D_F64 exchanged = ClosestPoint3D_F64.closestPoint(second, first, null);
            System.out.printf("segments of %.0f: %s, exchanged %s%n", size, text(point), text(exchanged));
        }
    }
}
JAVA
javac -cp "$jars" Check.java 2>log || { cat log >&2; exit 2; }
java -cp "$jars:." Check | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
distance of 2,2,0.0: 0.00
distance of 2,2,0.001: 0.00
distance of 10,10,0.0: 0.00
distance of 10,10,0.001: 7.07
distance of 5,10,0.0: 0.00
distance of 5,10,0.001: 3.54
distance of -3,-4,0.0: 0.00
distance of -3,-4,0.001: 5.00
triangle to 0.00,10.00,0.00: wrong closest points 0 of 1681
closest to 3,2,3: 10.00,0.00,0.00 at the distance 7.28 in X and Y, boundary at 1.12
triangle to 2.00,1.00,0.00: wrong closest points 136 of 1681
segments of 1: 0.25,0.00,0.10, exchanged 0.25,-0.00,0.10
segments of 10: 4.00,3.00,2.00, exchanged 5.00,0.00,0.00
EXPECTED
