// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace ncsim::report {

/// 64 bits in hexadecimal, FNV-1a (Fowler, Noll, Vo): told apart, not kept secret.
std::string fingerprint(std::string_view text);

}  // namespace ncsim::report
