#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, python3-transforms3d 0.4+ds-2 (module quaternions).
# Input:    quaternions in the order w, x, y, z that are not of unit length: 0,2,0,0 and 1,1,1,1; real quaternions:
#           1, 2 and -1; the same numbers as integers. Source: the docstrings of qinverse ("multiplicative inverse"),
#           qlog ("natural logarithm"), qpow ("the n th power") and qexp.
# Expected: q times qinverse(q) is 1. The logarithm of 1 is 0 and of 2 is 0.69. The square of 2 is 4. exp(1 + k) is
#           1.47 + 2.29 k, for integers also.
# Seen:     q times qinverse(q) is the length of q: 2. The logarithm of each real quaternion is 1, so the square
#           of 2 is 1, and exp(log(-1)) is 1. Integers are cut to integers: exp(1 + k) is 0, and log(1,1,1,1) is 0. No error
#           or warning appears. qmult gives the right squares; for other quaternions, log, exp and powers are right.

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
fetch python3-transforms3d=0.4+ds-2 python3-numpy=1:1.24.2-1+deb12u1
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries:$libraries/lapack:$libraries/blas PYTHONPATH=$work/root/usr/lib/python3/dist-packages

cat >check.py <<'PY'
from transforms3d.quaternions import qexp, qinverse, qlog, qmult, qpow


def text(quaternion):
    return ",".join(f"{x + 0:.2f}" for x in [round(float(x), 2) for x in quaternion])


for q in ([0.0, 1.0, 0.0, 0.0], [0.0, 2.0, 0.0, 0.0], [1.0, 1.0, 1.0, 1.0]):
    print(f"{text(q)}: times its inverse {text(qmult(q, qinverse(q)))}")
for q in ([1.0, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0, 0.0], [-1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 1.0]):
    print(f"{text(q)}: log {text(qlog(q))}, exp(log) {text(qexp(qlog(q)))}")
    print(f"{text(q)}: power 2 {text(qpow(q, 2))}, product {text(qmult(q, q))}")
for kind in (float, int):
    print(f"{kind.__name__}: exp(1,0,0,1) {text(qexp([kind(x) for x in (1, 0, 0, 1)]))}, "
          f"log(1,1,1,1) {text(qlog([kind(1)] * 4))}")
PY
/usr/bin/python3 check.py | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
0.00,1.00,0.00,0.00: times its inverse 1.00,0.00,0.00,0.00
0.00,2.00,0.00,0.00: times its inverse 2.00,0.00,0.00,0.00
1.00,1.00,1.00,1.00: times its inverse 2.00,0.00,0.00,0.00
1.00,0.00,0.00,0.00: log 1.00,0.00,0.00,0.00, exp(log) 1.00,0.00,0.00,0.00
1.00,0.00,0.00,0.00: power 2 1.00,0.00,0.00,0.00, product 1.00,0.00,0.00,0.00
2.00,0.00,0.00,0.00: log 1.00,0.00,0.00,0.00, exp(log) 1.00,0.00,0.00,0.00
2.00,0.00,0.00,0.00: power 2 1.00,0.00,0.00,0.00, product 4.00,0.00,0.00,0.00
-1.00,0.00,0.00,0.00: log 1.00,0.00,0.00,0.00, exp(log) 1.00,0.00,0.00,0.00
-1.00,0.00,0.00,0.00: power 2 1.00,0.00,0.00,0.00, product 1.00,0.00,0.00,0.00
1.00,0.00,0.00,1.00: log 0.35,0.00,0.00,0.79, exp(log) 1.00,0.00,0.00,1.00
1.00,0.00,0.00,1.00: power 2 0.00,0.00,0.00,2.00, product 0.00,0.00,0.00,2.00
float: exp(1,0,0,1) 1.47,0.00,0.00,2.29, log(1,1,1,1) 0.69,0.60,0.60,0.60
int: exp(1,0,0,1) 0.00,0.00,0.00,0.00, log(1,1,1,1) 0.00,0.00,0.00,0.00
EXPECTED
