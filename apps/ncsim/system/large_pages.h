// SPDX-License-Identifier: GPL-3.0-or-later
//
// Memory in large pages. A simulation touches tens of megabytes once and looks them up at random;
// with pages of 4 kB a tenth of its time goes into having them mapped and found, more in a virtual
// machine.
#pragma once

namespace ncsim::app {

/// Where an argument is a folder or a file of some size, so that there is something to gain, begins
/// this program anew with GLIBC_TUNABLES set: only there the C library reads, before anything of
/// ours runs, that its memory is to be in large pages (glibc.malloc.hugetlb, from glibc 2.35 on;
/// others ignore it). Returns where nothing is to be done: it is set, by somebody or by this
/// function; something is loaded before everything else (LD_PRELOAD: valgrind, another malloc); or
/// it does not work.
void prefer_large_pages(char** argv);

}  // namespace ncsim::app
