// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/setup/digest.h"

#include <gtest/gtest.h>

namespace ncsim::setup {
namespace {

// Examples of NIST for FIPS 180-4.
TEST(Digest, IsSha256) {
    EXPECT_EQ(digest_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(digest_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace ncsim::setup
