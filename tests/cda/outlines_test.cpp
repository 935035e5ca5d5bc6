// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points rounded with an estimate in doubles against divisions, and numbers of points and keys.
#include "outlines.h"

#include "interner.h"
#include "support/random.h"
#include "wide.h"

#include <gtest/gtest.h>

#include <vector>

namespace ncsim::cda {
namespace {

using test::Random;

TEST(FixedPoint, IsRoundedDownAsByDivision) {
    Random random(1);
    int negative = 0;
    int whole = 0;
    for (int i = 0; i < 200000; ++i) {
        // Of all sizes, w up to 75 bits, coordinates up to 2^26 of it.
        const Int128 w = (static_cast<Int128>(random.between(0, (std::int64_t{1} << 61) - 1))
                              << random.between(0, 13) >>
                          random.between(0, 60)) +
                         1;
        ExactPoint p;
        p.w = w;
        const auto coordinate = [&] {
            const std::int64_t most = std::int64_t{1} << random.between(0, 26);
            const std::int64_t units = random.between(-most, most);
            switch (random.between(0, 3)) {
                case 0: return units * w;
                case 1: return units * w + random.between(-1, 1);
                default: return units * w + w / random.between(2, 1 << 30);
            }
        };
        p.x = coordinate();
        p.y = coordinate();
        p.z = coordinate();
        const FixedPoint fixed = FixedPoint::of(p);
        const Int128 scale = Int128{1} << 24;
        EXPECT_EQ(fixed.at[0], static_cast<std::int64_t>(floor_quotient(p.x * scale, w)));
        EXPECT_EQ(fixed.at[1], static_cast<std::int64_t>(floor_quotient(p.y * scale, w)));
        EXPECT_EQ(fixed.at[2], static_cast<std::int64_t>(floor_quotient(p.z * scale, w)));
        negative += p.x < 0 ? 1 : 0;
        whole += p.x % w == 0 ? 1 : 0;
    }
    EXPECT_GT(negative, 1000);
    EXPECT_GT(whole, 1000);
}

TEST(Outlines, TellsPointsOfOnePageApartByTheirPlanes) {
    Outlines outlines;
    std::vector<std::uint32_t> planes;
    for (std::int32_t i = 0; i < 30; ++i) {
        Plane plane{0, 0, 0, 100 + i};
        (i % 3 == 0 ? plane.nx : i % 3 == 1 ? plane.ny : plane.nz) = 1;
        planes.push_back(outlines.add_plane(plane));
    }
    // All corners of a grid, on each page.
    for (int page = 0; page < 3; ++page) {
        if (page > 0) outlines.turn_page();
        const std::size_t before = outlines.points().size();
        for (int again = 0; again < 2; ++again) {
            for (std::size_t i = 0; i < 1000; ++i) {
                const std::uint32_t x = planes[3 * (i % 10)];
                const std::uint32_t y = planes[3 * (i / 10 % 10) + 1];
                const std::uint32_t z = planes[3 * (i / 100) + 2];
                const std::uint32_t number =
                    again == 0 ? outlines.point(x, y, z) : outlines.point(z, x, y);
                EXPECT_EQ(number, before + i);
                const double step = outlines.points()[number].fixed.approx().x;
                EXPECT_EQ(step, 100.0 + 3.0 * static_cast<double>(i % 10));
            }
        }
        EXPECT_EQ(outlines.points().size(), before + 1000);
    }
}

TEST(Interner, NumbersManyKeysAsOneByOne) {
    struct Hash {
        std::uint64_t operator()(const std::uint64_t& key) const { return mix(0, key / 2); }
    };
    Random random(3);
    Interner<std::uint64_t, Hash> one_by_one;
    Interner<std::uint64_t, Hash> together;
    for (const std::size_t count : {0U, 1U, 7U, 8U, 15U, 16U, 17U, 1000U, 20000U}) {
        std::vector<std::uint64_t> keys;
        std::vector<std::uint32_t> expected;
        for (std::size_t i = 0; i < count; ++i) {
            keys.push_back(static_cast<std::uint64_t>(random.between(0, 12000)));
            expected.push_back(one_by_one(keys.back()));
        }
        std::vector<std::uint32_t> numbers(count, ~std::uint32_t{0});
        together.number_all(keys, [&](std::size_t i, std::uint32_t n) { numbers[i] = n; });
        EXPECT_EQ(numbers, expected);
    }
    EXPECT_EQ(together.keys(), one_by_one.keys());
    EXPECT_GT(together.size(), 5000U);
}

}  // namespace
}  // namespace ncsim::cda
