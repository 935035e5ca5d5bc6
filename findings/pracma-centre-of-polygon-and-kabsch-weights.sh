#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, r-cran-pracma 2.4.2-1, r-base-core 4.2.2.20221110-2 (numerical methods in R).
# Input:    squares of 10 and an L of 20 x 20 with the first vertex at 0,0 and elsewhere; five points and the same points turned by 90
#           degrees about Z and moved by 5,6,7, with equal and other weights. Source: help of polyarea ("The polygon automatically
#           be closed, that is the last point need not be / should not be the same as the first"; poly_center: "the center
#           (of mass) of the figure defined by the polygon"), of kabsch ("determines a best rotation of a given vector set into a
#           second vector set"; "w: weights , influence the distance of points").
# Expected: The centre of a square from 100,50 is 105,55. With an exact copy, each set of weights gives the turn, the move 5,6,7
#           and the deviation 0.
# Seen:     The closing side is missing in the centre: it is 438.33,238.33, far outside of the square. The area is right, and a
#           repeated first vertex gives 105,55. kabsch is right only if the sum of the weights is 1: with weights of 1, a point
#           misses its copy by 40, with the weights 1 to 5 by 133, without a message.

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
fetch r-cran-pracma=2.4.2-1 r-base-core=4.2.2.20221110-2
LD_LIBRARY_PATH=$(find root/usr/lib -name '*.so*' -printf "$work/%h\n" | sort -u | tr '\n' ':')
export LD_LIBRARY_PATH HOME=$work EDITOR=true PAGER=cat TAR=tar R_ZIPCMD=zip R_UNZIPCMD=unzip
export R_HOME=$work/root/usr/lib/R R_LIBS_SITE=$work/root/usr/lib/R/site-library R_SHARE_DIR=$work/root/usr/share/R/share

cat >check.R <<'R'
suppressMessages(library(pracma))

text <- function(v) paste(sprintf("%.2f", v + 0), collapse = ",")

for (start in list(c(0, 0), c(5, 5), c(100, 50))) {
  for (shape in list(list("square", c(0, 10, 10, 0), c(0, 0, 10, 10)), list("L", c(0, 20, 20, 10, 10, 0), c(0, 0, 10, 10, 20, 20)))) {
    x <- shape[[2]] + start[1]
    y <- shape[[3]] + start[2]
    cat(sprintf("%s from %s: centre %s, with repeated vertex %s, area %.0f\n", shape[[1]], text(start), text(poly_center(x, y)),
                text(poly_center(c(x, x[1]), c(y, y[1]))), polyarea(x, y)))
  }
}

points <- cbind(c(0, 0, 0), c(1, 0, 0), c(0, 2, 0), c(0, 0, 3), c(1, 2, 3))
copy <- rbind(c(0, -1, 0), c(1, 0, 0), c(0, 0, 1)) %*% points + c(5, 6, 7)
weights <- list(NULL, rep(0.2, 5), rep(1, 5), 1:5, (1:5) / 15)
for (w in weights) {
  result <- kabsch(points, copy, w)
  miss <- max(sqrt(colSums((result$U %*% points + as.vector(result$R) - copy)^2)))
  cat(sprintf("weights %s: move %s, d %.2f, farthest point %.2f\n", if (is.null(w)) "none" else text(w), text(result$R),
              result$d, miss))
}
R
root/usr/lib/R/bin/exec/R --vanilla --no-echo -f check.R 2>log | sed '/^cannot find system Renviron/d' | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
square from 0.00,0.00: centre 5.00,5.00, with repeated vertex 5.00,5.00, area 100
L from 0.00,0.00: centre 8.33,8.33, with repeated vertex 8.33,8.33, area 300
square from 5.00,5.00: centre 10.83,11.67, with repeated vertex 10.00,10.00, area 100
L from 5.00,5.00: centre 13.89,15.00, with repeated vertex 13.33,13.33, area 300
square from 100.00,50.00: centre 438.33,238.33, with repeated vertex 105.00,55.00, area 100
L from 100.00,50.00: centre 330.56,191.67, with repeated vertex 108.33,58.33, area 300
weights none: move 5.00,6.00,7.00, d 0.00, farthest point 0.00
weights 0.20,0.20,0.20,0.20,0.20: move 5.00,6.00,7.00, d 0.00, farthest point 0.00
weights 1.00,1.00,1.00,1.00,1.00: move 18.25,27.72,35.51, d 87.01, farthest point 40.01
weights 1.00,2.00,3.00,4.00,5.00: move 48.11,79.08,107.62, d 513.16, farthest point 133.29
weights 0.07,0.13,0.20,0.27,0.33: move 5.00,6.00,7.00, d 0.00, farthest point 0.00
EXPECTED
