// SPDX-License-Identifier: GPL-3.0-or-later
//
// Number of random cases of a test.
#pragma once

namespace ncsim::test {

/// Returns `rounds`; a quarter of them in a build with sanitizers, where each takes eight times as
/// long.
template <class T>
constexpr T rounds(T rounds) {
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    return (rounds + 3) / 4;
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return (rounds + 3) / 4;
#else
    return rounds;
#endif
}

}  // namespace ncsim::test
