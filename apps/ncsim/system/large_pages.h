// SPDX-License-Identifier: GPL-3.0-or-later
//
// Memory in large pages. A simulation touches tens of megabytes once and reads them at random. With
// pages of 4 kB, a tenth of the time is spent on mapping and address translation, more in a virtual
// machine.
#pragma once

namespace ncsim::app {

/// Restarts this program with GLIBC_TUNABLES set, if an argument is a folder or a file of some
/// size. The C library reads that variable only before main(): glibc.malloc.hugetlb (since glibc
/// 2.35) selects large pages; older versions ignore it. Returns without a restart if the variable
/// is set, by the user or by this function; if LD_PRELOAD is set (valgrind, a different malloc); or
/// if the restart fails.
void prefer_large_pages(char** argv);

}  // namespace ncsim::app
