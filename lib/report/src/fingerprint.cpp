// SPDX-License-Identifier: GPL-3.0-or-later
//
// FNV-1a hash.
#include "fingerprint.h"

#include <fmt/format.h>

#include <cstdint>

namespace ncsim::report {

std::string fingerprint(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3ULL;
    }
    return fmt::format("{:016x}", hash);
}

}  // namespace ncsim::report
