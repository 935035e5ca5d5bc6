// SPDX-License-Identifier: GPL-3.0-or-later
//
// Digests of files.
#pragma once

#include <string>
#include <string_view>

namespace ncsim::setup {

/// Returns the SHA-256 digest in hexadecimal. Source: FIPS 180-4.
std::string digest_of(std::string_view bytes);

}  // namespace ncsim::setup
