#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libvecmath-java 1.5.2-7 (javax.vecmath: vectors, matrices and quaternions of Java 3D).
# Input:    half turns about six axes as Matrix3d, read back as AxisAngle4d and as Quat4d; the matrix diag(3, 2, 1) and a
#           symmetric 2 x 2 matrix as GMatrix. Source: documentation of AxisAngle4d.set(Matrix3d) and Quat4d.set(Matrix3d)
#           ("rotational component of the passed matrix"), of GMatrix.SVD ("this = U*W*transpose(V)").
# Expected: The rotation of the result is the half turn, with the point 3,1,2 at the same place. The singular values of
#           diag(3, 2, 1) are 3, 2, 1. SVDBackSolve gives the solution 0.8, 1.4 of LUDBackSolve.
# Seen:     The AxisAngle4d of each half turn has the angle 0: no rotation. The quaternion of a half turn about 1,1,0 is
#           a half turn about Z; about 1,2,3 it is 0. With 179.9999 degrees all are right. All singular values are 1, and
#           U of diag(3, 2, 1) is NaN. SVDBackSolve gives -5.83, 0.08.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

apt-get download libvecmath-java=1.5.2-7 >/dev/null 2>log || { cat log >&2; exit 2; }
dpkg -x ./*.deb root

cat >Check.java <<'JAVA'
import java.util.Locale;
import javax.vecmath.*;

class Check {
    static String text(double... values) {
        StringBuilder text = new StringBuilder();
        for (double value : values)
            text.append(text.length() == 0 ? "" : ",").append(String.format(Locale.ROOT, "%.2f", value + 0.0).replace("-0.00", "0.00"));
        return text.toString();
    }

    static String moved(Matrix3d rotation) {
        Vector3d point = new Vector3d(3, 1, 2);
        rotation.transform(point);
        return text(point.x, point.y, point.z);
    }

    static void turn(double x, double y, double z, double degrees) {
        Matrix3d matrix = new Matrix3d(), back = new Matrix3d();
        matrix.set(new AxisAngle4d(x, y, z, Math.toRadians(degrees)));
        AxisAngle4d angle = new AxisAngle4d();
        angle.set(matrix);
        Quat4d quaternion = new Quat4d();
        quaternion.set(matrix);
        System.out.println(degrees + " about " + text(x, y, z) + ": " + moved(matrix));
        back.set(angle);
        System.out.println("  axis " + text(angle.x, angle.y, angle.z) + ", angle " + text(Math.toDegrees(angle.angle))
            + ": " + moved(back));
        back.set(quaternion);
        System.out.println("  quaternion " + text(quaternion.x, quaternion.y, quaternion.z, quaternion.w) + ": " + moved(back));
    }

    static GMatrix[] decomposed(GMatrix matrix) {
        int size = matrix.getNumRow();
        GMatrix[] parts = {new GMatrix(size, size), new GMatrix(size, size), new GMatrix(size, size)};
        matrix.SVD(parts[0], parts[1], parts[2]);
        return parts;
    }

    public static void main(String[] arguments) {
        double[][] axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, -1}, {1, 2, 3}};
        for (double[] axis : axes)
            turn(axis[0], axis[1], axis[2], 180);
        turn(1, 2, 3, 179.9999);

        GMatrix[] parts = decomposed(new GMatrix(3, 3, new double[] {3, 0, 0, 0, 2, 0, 0, 0, 1}));
        System.out.println("diag(3, 2, 1): singular values " + text(parts[1].getElement(0, 0), parts[1].getElement(1, 1),
            parts[1].getElement(2, 2)) + ", U(0,0) " + text(parts[0].getElement(0, 0)));

        GMatrix matrix = new GMatrix(2, 2, new double[] {2, 1, 1, 3}), triangular = new GMatrix(2, 2);
        GVector right = new GVector(new double[] {3, 5}), order = new GVector(2), solution = new GVector(2);
        matrix.LUD(triangular, order);
        solution.LUDBackSolve(triangular, right, order);
        System.out.println("2x + y = 3, x + 3y = 5: LUDBackSolve " + text(solution.getElement(0), solution.getElement(1)));
        parts = decomposed(matrix);
        solution.SVDBackSolve(parts[0], parts[1], parts[2], right);
        System.out.println("  SVDBackSolve " + text(solution.getElement(0), solution.getElement(1)) + ", singular values "
            + text(parts[1].getElement(0, 0), parts[1].getElement(1, 1)));
    }
}
JAVA
java -cp root/usr/share/java/vecmath.jar Check.java 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
180.0 about 1.00,0.00,0.00: 3.00,-1.00,-2.00
  axis 0.00,1.00,0.00, angle 0.00: 3.00,1.00,2.00
  quaternion 1.00,0.00,0.00,0.00: 3.00,-1.00,-2.00
180.0 about 0.00,1.00,0.00: -3.00,1.00,-2.00
  axis 0.00,1.00,0.00, angle 0.00: 3.00,1.00,2.00
  quaternion 0.00,1.00,0.00,0.00: -3.00,1.00,-2.00
180.0 about 0.00,0.00,1.00: -3.00,-1.00,2.00
  axis 0.00,1.00,0.00, angle 0.00: 3.00,1.00,2.00
  quaternion 0.00,0.00,1.00,0.00: -3.00,-1.00,2.00
180.0 about 1.00,1.00,0.00: 1.00,3.00,-2.00
  axis 0.00,1.00,0.00, angle 0.00: 3.00,1.00,2.00
  quaternion 0.00,0.00,1.00,0.00: -3.00,-1.00,2.00
180.0 about 0.00,1.00,-1.00: -3.00,-2.00,-1.00
  axis 0.00,1.00,0.00, angle 0.00: 3.00,1.00,2.00
  quaternion 0.00,0.00,1.00,0.00: -3.00,-1.00,2.00
180.0 about 1.00,2.00,3.00: -1.43,2.14,2.71
  axis 0.00,1.00,0.00, angle 0.00: 3.00,1.00,2.00
  quaternion 0.00,0.00,0.00,0.00: 3.00,1.00,2.00
179.9999 about 1.00,2.00,3.00: -1.43,2.14,2.71
  axis 0.27,0.53,0.80, angle 180.00: -1.43,2.14,2.71
  quaternion 0.27,0.53,0.80,0.00: -1.43,2.14,2.71
diag(3, 2, 1): singular values 1.00,1.00,1.00, U(0,0) NaN
2x + y = 3, x + 3y = 5: LUDBackSolve 0.80,1.40
  SVDBackSolve -5.83,0.08, singular values 1.00,1.00
EXPECTED
