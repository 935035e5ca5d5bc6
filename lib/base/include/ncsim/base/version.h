// SPDX-License-Identifier: GPL-3.0-or-later
//
// Version of ncsim.
#pragma once

namespace ncsim {

extern const char* const kVersion;  ///< "1.0.0"

}  // namespace ncsim
