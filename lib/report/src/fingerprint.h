// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fingerprints of texts.
#pragma once

#include <string>
#include <string_view>

namespace ncsim::report {

/// Returns a hash of 64 bits in hexadecimal, which distinguishes texts but is not cryptographic.
/// Source: Fowler, Noll, Vo: FNV-1a.
std::string fingerprint(std::string_view text);

}  // namespace ncsim::report
