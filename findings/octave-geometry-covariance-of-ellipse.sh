#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, octave-geometry 4.0.0-6, octave 7.3.0-2 (2D geometry).
# Input:    three covariance matrices, converted to ellipses and back; the ellipse of 4 x 1. Source: help of cov2ellipse ("ellipse
#           parameters from covariance matrix") and ellipse2cov ("covariance matrix from ellipse"), which refer to each other.
# Expected: ellipse2cov(cov2ellipse(K)) is K.
# Seen:     diag(4, 1) becomes the ellipse 2 x 1, and then diag(2, 1): the half axes are standard deviations in cov2ellipse
#           and variances in ellipse2cov.

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
fetch octave-geometry=4.0.0-6 octave=7.3.0-2
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH HOME=$work OCTAVE_HOME=$work/root/usr OCTAVE_EXEC_HOME=$work/root/usr

cat >check.m <<'M'
warning("off", "all");
addpath(genpath("root/usr/share/octave/packages"));
addpath(genpath("root/usr/lib/x86_64-linux-gnu/octave/packages"));

for K = {[4 0; 0 1], [9 0; 0 4], [3 1; 1 2]}
  ellipse = cov2ellipse(K{1});
  printf("K %s: ellipse %.3f x %.3f, K again %s\n", mat2str(K{1}), ellipse(3), ellipse(4), mat2str(ellipse2cov(ellipse), 3));
end
printf("ellipse 4 x 1: K %s\n", mat2str(ellipse2cov(4, 1), 3));
M
(root/usr/bin/octave-cli --no-init-file --no-gui check.m 2>log || true) | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
K [4 0;0 1]: ellipse 2.000 x 1.000, K again [2 0;0 1]
K [9 0;0 4]: ellipse 3.000 x 2.000, K again [3 0;0 2]
K [3 1;1 2]: ellipse 1.902 x 1.176, K again [1.7 0.325;0.325 1.38]
ellipse 4 x 1: K [4 0;0 1]
EXPECTED
