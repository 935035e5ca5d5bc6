// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ncsim::cda {

/// A compiler extension; missing operations are in src/exact/wide.h.
__extension__ using Int128 = __int128;

}  // namespace ncsim::cda
