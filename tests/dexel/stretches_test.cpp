// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests which bodies of a batch are cut together.
#include "stretches.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace ncsim::dexel {
namespace {

using Stretches = std::vector<Stretch>;

Stretches of(const std::vector<bool>& open) {
    return stretches_of(open.size(), [&](std::size_t i) { return open[i]; });
}

TEST(Stretches, OneToolThatIsNotOpenStandsAlone) {
    std::vector<bool> open(1000, true);
    EXPECT_EQ(of(open), (Stretches{{0, 1000, true}}));
    open[500] = false;
    EXPECT_EQ(of(open), (Stretches{{0, 500, true}, {500, 501, false}, {501, 1000, true}}));
}

TEST(Stretches, AFewOpenOnesGoWithTheOthers) {
    std::vector<bool> open(100, false);
    EXPECT_EQ(of(open), (Stretches{{0, 100, false}}));
    open[0] = open[10] = open[11] = open[99] = true;
    EXPECT_EQ(of(open), (Stretches{{0, 100, false}}));
    open.insert(open.end(), kFewOpen, true);
    EXPECT_EQ(of(open), (Stretches{{0, 99, false}, {99, 100 + kFewOpen, true}}));
}

TEST(Stretches, AFewThatAreAllThereIsAreOpen) {
    EXPECT_EQ(of({true, true}), (Stretches{{0, 2, true}}));
    EXPECT_EQ(of({}), Stretches{});
}

}  // namespace
}  // namespace ncsim::dexel
