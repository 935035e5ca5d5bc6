// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ncsim::cda {

/// An extension of the compilers; what it lacks stands in src/wide.h.
__extension__ using Int128 = __int128;

}  // namespace ncsim::cda
