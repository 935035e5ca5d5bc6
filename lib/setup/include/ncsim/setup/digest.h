// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace ncsim::setup {

/// SHA-256 (FIPS 180-4) in hexadecimal.
std::string digest_of(std::string_view bytes);

}  // namespace ncsim::setup
