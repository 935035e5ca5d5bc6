// SPDX-License-Identifier: GPL-3.0-or-later
//
// SHA-256 by Nettle.
#include "ncsim/setup/digest.h"

#include <nettle/sha2.h>

#include <array>
#include <cstdint>

namespace ncsim::setup {

std::string digest_of(std::string_view bytes) {
    sha256_ctx context{};
    sha256_init(&context);
    sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context, digest.size(), digest.data());
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : digest) {
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

}  // namespace ncsim::setup
