// SPDX-License-Identifier: GPL-3.0-or-later
//
// The 128-bit integer type of the kernel.
#pragma once

namespace ncsim::cda {

/// A compiler extension; missing operations are in src/exact/wide.h.
__extension__ using Int128 = __int128;

}  // namespace ncsim::cda
