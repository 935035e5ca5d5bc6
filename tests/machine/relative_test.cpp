// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/machine/relative.h"

#include "../support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ranges>
#include <string_view>

namespace ncsim::machine {
namespace {

using test::Random;

Vec3 random_vector(Random& random, double reach) {
    return {random.within(-reach, reach), random.within(-reach, reach),
            random.within(-reach, reach)};
}

Joint random_joint(Random& random, char letter) {
    if (letter >= 'A' && letter <= 'C')
        return joint_of(letter, true, random_vector(random, 1.0), random_vector(random, 200.0));
    Vec3 along;
    along[letter - 'X'] = random.one_in(2) ? 1.0 : -1.0;
    return joint_of(letter, false, along);
}

Values random_values(Random& random, double mm, double degrees) {
    Values values{};
    for (std::size_t i = 0; i < 6; ++i)
        values[i] = random.within(-1.0, 1.0) * (i < 3 ? mm : degrees);
    return values;
}

void expect_same(Vec3 a, Vec3 b) {
    EXPECT_LT(norm(a - b), 1e-9);
}

Vec3 carried(const Chain& chain, const Values& values, Vec3 p) {
    for (const Joint& joint : std::views::reverse(chain.joints))
        p = move_by_joint(joint, values[*index_of(joint.letter)], p);
    return p;
}

TEST(Relative, IsTheWayOverTheBed) {
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const Joint x = random_joint(random, 'X'), a = random_joint(random, 'A'),
                    c = random_joint(random, 'C'), z = random_joint(random, 'Z'),
                    b = random_joint(random, 'B');
        const Chain table{{x, a, c}}, head{{x, z, b}};
        const Values values = random_values(random, 300.0, 180.0);
        const Vec3 p = random_vector(random, 100.0);
        const Pose X = pose_of(seen_from(table, head), values);
        // X carries both chains, so X does not occur in the relative motion.
        EXPECT_EQ(seen_from(table, head).joints.size(), 4U);
        expect_same(carried(table, values, X * p), carried(head, values, p));
        expect_same(inverse(X) * (X * p), p);
    }
    EXPECT_TRUE(seen_from({}, {}).joints.empty());
}

TEST(Relative, NoPointGoesFartherThanItsBounds) {
    Random random(4);
    double closest_speed = 0.0, closest_bend = 0.0;
    for (int i = 0; i < 3000; ++i) {
        SCOPED_TRACE(i);
        Chain chain;
        for (const char letter : std::string_view("CAXYZB")) {
            if (!random.one_in(3)) chain.joints.push_back(random_joint(random, letter));
        }
        JointMotion joint_motion;
        joint_motion.from = random_values(random, 100.0, 180.0);
        const Values by = random_values(random, 20.0, random.one_in(2) ? 5.0 : 90.0);
        for (std::size_t k = 0; k < 6; ++k)
            joint_motion.to[k] = joint_motion.from[k] + by[k];
        for (std::size_t k = 0; k < 3; ++k)
            joint_motion.speed[k] = std::abs(by[k]);
        joint_motion.all_speed = 3.0 * 20.0;
        const Vec3 centre = random_vector(random, 100.0);
        const double radius = random.within(0.0, 50.0);
        const Ball ball = move_ball(chain, joint_motion, {centre, radius, 0.0, 0.0});
        for (int k = 0; k < 4; ++k) {
            const Vec3 p = centre + radius * normalized(random_vector(random, 1.0));
            const auto at = [&](double t) {
                Values values{};
                for (std::size_t j = 0; j < 6; ++j)
                    values[j] = joint_motion.from[j] + t * by[j];
                return carried(chain, values, p);
            };
            const Vec3 from = at(0.0), to = at(1.0);
            for (int j = 1; j <= 16; ++j) {
                const double t = j / 16.0;
                const double gone = norm(at(t) - from);
                const double bent = norm(at(t) - (from + t * (to - from)));
                ASSERT_LE(gone, ball.speed + 1e-9);
                ASSERT_LE(bent, ball.bend / 8.0 + 1e-9);
                ASSERT_LE(norm(at(t) - ball.centre), ball.radius + 1e-9);
                if (ball.speed > 0.0) closest_speed = std::max(closest_speed, gone / ball.speed);
                if (ball.bend > 0.0) closest_bend = std::max(closest_bend, 8 * bent / ball.bend);
            }
        }
    }
    // The bounds are tight and do not hold only by being far too large.
    EXPECT_GT(closest_speed, 0.9);
    EXPECT_GT(closest_bend, 0.7);
}

}  // namespace
}  // namespace ncsim::machine
