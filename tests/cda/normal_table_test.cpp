// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares bounds in floats with the linear program that they bound, solved by evaluating all
// corners.
#include "tree/normal_table.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ncsim::cda {
namespace {

using test::Random;

// A plane that cuts a box: the exact plane, and the plane as the table sees it.
struct Seen {
    std::array<double, 3> n{};  // |x| + |y| + |z| = 1, for a box from -1 to 1
    double e = 0;
    ScaledNormal scaled;
};

BoxFrame random_box(Random& random) {
    HalfBox box;
    for (std::size_t i = 0; i < 3; ++i) {
        box.min[i] = 2 * random.between(-1000000, 1000000) + 1;
        box.max[i] = box.min[i] + 2 * random.between(1024, 3000000);
    }
    return BoxFrame(box);
}

Seen random_plane(Random& random, const BoxFrame& box) {
    const std::int64_t size = random.between(0, 3) == 0 ? 2 : 1 << 24;
    Plane plane = test::random_normal(random, size);
    HalfPlane h(plane);
    const double reach = BoxHeight(box, h).reach;
    const double share = 1e-6 * static_cast<double>(random.between(-999999, 999999));
    h.d2 = std::round(BoxHeight(box, h).above + share * reach);
    const BoxHeight sight(box, h);
    Seen seen;
    for (std::size_t i = 0; i < 3; ++i)
        seen.n[i] = h.normal(i) * box.half[i] / sight.reach;
    seen.e = -sight.above / sight.reach;
    seen.scaled = {h.nx, h.ny, h.nz, box, sight.reach};
    return seen;
}

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Returns the largest p·x over the points of the box below m. The maximum is at a corner of the box
// or where an edge meets m.
double largest_along(const Seen& p, const Seen& m) {
    double largest = -std::numeric_limits<double>::infinity();
    const auto corner = [](unsigned bits) {
        return std::array<double, 3>{bits & 1 ? 1.0 : -1.0, bits & 2 ? 1.0 : -1.0,
                                     bits & 4 ? 1.0 : -1.0};
    };
    for (unsigned bits = 0; bits < 8; ++bits) {
        const auto at = corner(bits);
        const double height = dot(m.n, at) - m.e;
        if (height <= 0.0) largest = std::max(largest, dot(p.n, at));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            auto next = at;
            next[axis] = -at[axis];
            const double there = dot(m.n, next) - m.e;
            if (height <= 0.0 || there > 0.0) continue;
            const double part = height / (height - there);
            for (std::size_t i = 0; i < 3; ++i)
                next[i] = at[i] + part * (next[i] - at[i]);
            largest = std::max(largest, dot(p.n, next));
        }
    }
    return largest;
}

TEST(NormalTable, BoundsWhatIsBelowAPlane) {
    Random random(1);
    int tight = 0;
    int telling = 0;
    for (int i = 0; i < 200000; ++i) {
        const BoxFrame box = random_box(random);
        const Seen p = random_plane(random, box);
        const Seen m = random_plane(random, box);
        const Bound bound = bound_along(p.scaled, m.scaled);
        ASSERT_GE(bound.slope, 0.0F);
        const double found = static_cast<double>(bound.slope) * m.e + bound.offset;
        const double largest = largest_along(p, m);
        // The bound has a margin because the comparison is in floats, too.
        ASSERT_GE(found + 0.5 * static_cast<double>(row::kMargin), largest);
        telling += largest < 0.999 ? 1 : 0;
        tight += largest < 0.999 && found < largest + 0.01 ? 1 : 0;
    }
    EXPECT_GT(telling, 80000);
    EXPECT_GT(tight, telling / 5) << "the bound is too wide to separate anything";
}

TEST(NormalTable, TellsInRowsWhatPairsTell) {
    Random random(2);
    int any_implied = 0;
    for (int i = 0; i < 300; ++i) {
        const BoxFrame box = random_box(random);
        std::vector<Seen> planes;
        std::vector<ScaledNormal> normals;
        for (auto k = random.between(1, 40); k > 0; --k) {
            planes.push_back(random_plane(random, box));
            normals.push_back(planes.back().scaled);
        }
        NormalTable table;
        table.assign(normals);
        ASSERT_EQ(table.normals(), planes.size());
        ASSERT_GE(table.stride(), planes.size());
        const Seen other = random_plane(random, box);
        std::vector<float> row(table.stride(), row::kUnknown);
        for (std::size_t k = 0; k < planes.size(); ++k)
            table.bound_by(table.column(k), static_cast<float>(planes[k].e), row.data());
        table.bound_by(other.scaled, static_cast<float>(other.e), row.data());
        for (std::size_t k = 0; k < planes.size(); ++k) {
            float least = row::kUnknown;
            const auto ask = [&](const Seen& m) {
                const Bound bound = bound_along(planes[k].scaled, m.scaled);
                least = std::min(least, bound.slope * static_cast<float>(m.e) + bound.offset);
            };
            for (std::size_t m = 0; m < planes.size(); ++m) {
                if (m != k) ask(planes[m]);
            }
            ask(other);
            EXPECT_EQ(row[table.column(k)], least);
        }
        SeenPlanes seen;
        for (const Seen& plane : planes)
            seen.add(plane.scaled, static_cast<float>(plane.e));
        const std::size_t end = seen.end_group();
        ASSERT_GE(end, planes.size());
        for (const Seen& p : {other, planes.back()}) {
            bool implied = false;
            for (const Seen& m : planes) {
                const Bound bound = bound_along(p.scaled, m.scaled);
                const float least = bound.slope * static_cast<float>(m.e) + bound.offset;
                implied = implied || least + row::kMargin < static_cast<float>(p.e);
            }
            // The sums differ in order, so nearly equal values may differ.
            const bool found = seen.imply(0, end, p.scaled, static_cast<float>(p.e));
            if (found != implied) {
                EXPECT_NE(seen.imply(0, end, p.scaled, static_cast<float>(p.e) - 1e-6F),
                          seen.imply(0, end, p.scaled, static_cast<float>(p.e) + 1e-6F));
            }
            any_implied += implied ? 1 : 0;
        }
        std::vector<float> higher = row;
        EXPECT_TRUE(is_below(row.data(), higher.data(), table.stride()));
        higher[table.column(0)] = std::nextafter(higher[table.column(0)], -2e30F);
        EXPECT_FALSE(is_below(row.data(), higher.data(), table.stride()));
    }
    EXPECT_GT(any_implied, 50);
}

}  // namespace
}  // namespace ncsim::cda
