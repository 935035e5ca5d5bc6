// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/verify/evidence.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace ncsim::verify {
namespace {

Observation seen(std::uint64_t motion, std::uint64_t step, Subject subject) {
    Observation o;
    o.motion = motion;
    o.step = step;
    o.subject = subject;
    return o;
}

TEST(Evidence, ComesBackToTheLastBit) {
    Observation full = seen(~std::uint64_t{0}, Observation::kAtEnd, Subject::Link);
    full.index = 4'000'000'000;
    full.other = 7;
    full.rank = 3;
    full.touches = false;
    full.certain = full.assumed = true;
    full.point = Vec3{0.1, -1.0 / 3.0, 1e-300};
    full.box = {{-1.5, 0, 2}, {-1.5, 0.1 + 0.2, 3}};
    full.value = -5e-324;
    full.values = machine::Values{1, 2, 0.3, 4, 5, 6, 7, 8, -0.9};
    full.places = {full.box, {{0, 0, 0}, {1, 1, 1}}};
    const Evidence evidence{seen(1, 2, Subject::FeedCut), full};
    EXPECT_EQ(evidence_from(bytes_of(evidence)), evidence);
    EXPECT_TRUE(evidence_from("").empty());
}

TEST(Evidence, ThatCannotBeReadIsRefused) {
    const std::string whole = bytes_of({seen(1, 2, Subject::Body)});
    EXPECT_EQ(whole, "1 2 3 0 0 0 1\n");
    for (const char* text :
         {"\n", "1 2 3 0 0 0 1", "1 2 3 0 0 0\n", "1 2 99 0 0 0 1\n", "1 2 3 0 0 0 128\n",
          "1 2 3 0 0 0 8 1 2\n", "1 2 3 0 0 0 8 1 2 nan\n", "1 2 3 0 0 0 32 inf\n",
          "1 2 3 0 0 0 16 1 1 1 0 0 0\n", "1 2 3 -1 0 0 1\n", "1  2 3 0 0 0 1\n",
          " 1 2 3 0 0 0 1\n", "1 2 3 0 0 0 1 \n", "1 2 3 0 0 0 1 0 0 0 1 1\n", "x\n"})
        EXPECT_THROW(evidence_from(text), std::invalid_argument) << text;
}

TEST(Evidence, OfTilesIsThatOfAll) {
    Observation near = seen(2, 1, Subject::RapidCut), far = near;
    near.touches = false;
    near.value = -1.0;
    near.box = {{0, 0, 0}, {1, 1, 1}};
    far.certain = true;
    far.value = 3.5;
    far.point = Vec3{5, 5, 5};
    far.rank = 1;
    far.box = {{5, 5, 5}, {6, 6, 6}};
    Observation raised = seen(2, 1, Subject::Body), higher = raised;
    raised.value = 0.02;
    raised.point = Vec3{1, 1, 1};
    raised.rank = 9;
    higher.value = 0.25;
    higher.point = Vec3{2, 2, 2};
    higher.rank = 2;
    const Observation other = seen(1, 7, Subject::FeedCut);
    const Evidence all = together({{near, raised}, {other, far, higher}});
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0], other);
    EXPECT_EQ(all[1].subject, Subject::RapidCut);
    EXPECT_TRUE(all[1].touches && all[1].certain);
    EXPECT_EQ(all[1].value, 2.5);
    EXPECT_EQ(all[1].point, far.point);
    EXPECT_EQ(all[1].box, (Box{{0, 0, 0}, {6, 6, 6}}));
    EXPECT_EQ(all[2].value, 0.25);
    EXPECT_EQ(all[2].point, higher.point);
}

// Each link and fixture is judged separately, in the order of the contacts.
TEST(Evidence, KeepsLinksAndFixturesApart) {
    Observation two = seen(1, Observation::kAtEnd, Subject::Fixture), one = two;
    two.index = 2;
    one.index = 1;
    const Observation link = seen(1, Observation::kAtEnd, Subject::Link);
    EXPECT_EQ(together({{link}, {two, one}, {link}}), (Evidence{two, one, link, link}));
}

}  // namespace
}  // namespace ncsim::verify
