// SPDX-License-Identifier: GPL-3.0-or-later
//
// The 128-bit integer type.
#pragma once

namespace ncsim {

/// A compiler extension; missing operations are in lib/cda/src/exact/wide.h.
__extension__ using Int128 = __int128;

}  // namespace ncsim
