#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libeuclid-java 2.3-1 (org.xmlcml.euclid) with its dependencies. A JDK 17 is installed.
# Input:    the ranges 0..4, 0..3 and 0..2, turned by 30 degrees; a block of 8 points, turned; planes through 4 and 5 points; a
#           rotation by 90 degrees about the line through 1,2 along Z. The names of the methods state the results (getTranformedRange,
#           bestPlane, getCentreOfRotation, getAxisAndAngle).
# Expected: The range of a turned rectangle contains the turned rectangle. Points in a plane have a best plane. The centre of a rotation
#           stays in place. Both constructors turn in the same direction.
# Seen:     Only two opposite corners are turned: the rectangle with the area 12 gets a range with the area 2.97, a block of 4 x 3 x 2 one
#           of 1.96 x 4.60 x 2. bestPlane fails for all points ("zero length normal"). The centre of the rotation about 1,2 is -1,3, and
#           the rotation moves it to 0,0. Half turns about X, Y and Z have the axes 1,0,-Infinity, 0,NaN,Infinity and 0,-Infinity,NaN.
#           Transform3 turns counter-clockwise about a vector or a line and clockwise about Axis3.

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
fetch libeuclid-java=2.3-1 liblog4j2-java=2.19.0-2 libcommons-io-java=2.11.0-2 \
  libcommons-lang3-java=3.12.0-2+deb12u1 libcommons-math-java=2.2-8 libxom-java=1.3.8-1 libjoda-time-java=2.10.14-1
jars=root/usr/share/java
path=.
for name in euclid log4j-1.2-api log4j-api log4j-core commons-io commons-lang3 commons-math xom joda-time; do path+=:$jars/$name.jar; done

cat >Check.java <<'JAVA'
import org.xmlcml.euclid.*;

public class Check {
    static Angle degrees(double value) { return new Angle(value, Angle.Units.DEGREES); }

    static String text(double... values) {
        StringBuilder text = new StringBuilder();
        for (double v : values) text.append(text.length() > 0 ? "," : "").append(v - v == 0 ? Math.round(v * 1000) / 1000.0 + 0.0 : v);
        return text.toString();
    }

    static String range(RealRange range) { return text(range.getMin()) + ".." + text(range.getMax()); }

    static void plane(double... points) {
        try {
            System.out.println("best plane: " + new Point3Vector(points).bestPlane());
        } catch (EuclidRuntimeException error) {
            System.out.println("best plane: " + error.getMessage());
        }
    }

    public static void main(String[] arguments) {
        Vector3 z = new Vector3(0, 0, 1);
        Real2Range flat = new Real2Range(new Real2(0, 0), new Real2(4, 3)).getTranformedRange(new Transform2(degrees(30)));
        System.out.println("range of a turned rectangle: " + range(flat.getXRange()) + ", " + range(flat.getYRange()));
        double[] block = {0, 0, 0, 4, 0, 0, 4, 3, 0, 0, 3, 0, 0, 0, 2, 4, 0, 2, 4, 3, 2, 0, 3, 2};
        Transform3 turn = new Transform3(z, degrees(30));
        Point3Vector points = new Point3Vector(block);
        Real3Range box = points.getRange3();
        box.transformEquals(turn);
        points.transform(turn);
        Real3Range exact = points.getRange3();
        System.out.println("range of a turned block: " + range(box.getXRange()) + ", " + range(box.getYRange()));
        System.out.println("range of its points: " + range(exact.getXRange()) + ", " + range(exact.getYRange()));
        plane(0, 0, 5, 4, 0, 5, 4, 3, 5, 0, 3, 5);
        plane(3, 0, 0, 0, 3, 0, 0, 0, 3, 1, 1, 1, 2, 2, -1);
        Transform3 about = new Transform3(new Line3(new Point3(1, 2, 0), z), degrees(90));
        Point3 centre = about.getCentreOfRotation();
        System.out.println("rotation about 1,2,0: 1,2,0 stays at " + text(new Point3(1, 2, 0).transform(about).getArray())
            + "; centre " + text(centre.getArray()) + " moves to " + text(centre.transform(about).getArray()));
        for (Vector3 axis : new Vector3[] {new Vector3(1, 0, 0), new Vector3(0, 1, 0), z, new Vector3(1, 2, 3)}) {
            Vector3 found = new Vector3();
            Angle angle = new Angle();
            new Transform3(axis, degrees(180)).getAxisAndAngle(found, angle);
            System.out.println("half turn about " + text(axis.getArray()) + ": axis " + text(found.getArray()) + ", angle "
                + text(angle.getDegrees()));
        }
        Point3 x = new Point3(1, 0, 0);
        System.out.println("1,0,0 turned by 90 degrees about the vector Z: " + text(x.transform(new Transform3(z, degrees(90))).getArray())
            + ", about Axis3.Z: " + text(x.transform(new Transform3(Axis.Axis3.Z, degrees(90))).getArray()));
    }
}
JAVA
javac -cp "$path" Check.java
java -cp "$path" Check 2>log | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
range of a turned rectangle: 0.0..4.964, 0.0..0.598
range of a turned block: 0.0..1.964, 0.0..4.598
range of its points: -1.5..3.464, 0.0..4.598
best plane: zero length normal
best plane: zero length normal
rotation about 1,2,0: 1,2,0 stays at 1.0,2.0,0.0; centre -1.0,3.0,0.0 moves to 0.0,0.0,0.0
half turn about 1.0,0.0,0.0: axis 1.0,0.0,-Infinity, angle 180.0
half turn about 0.0,1.0,0.0: axis 0.0,NaN,Infinity, angle 180.0
half turn about 0.0,0.0,1.0: axis 0.0,-Infinity,NaN, angle 180.0
half turn about 0.267,0.535,0.802: axis 0.267,0.535,0.802, angle 180.0
1,0,0 turned by 90 degrees about the vector Z: 0.0,1.0,0.0, about Axis3.Z: 0.0,-1.0,0.0
EXPECTED
