// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares points rounded with an estimate in doubles with divisions, and tests the numbers of
// points and keys.
#include "surface/outlines.h"

#include "exact/wide.h"
#include "support/random.h"

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
        // Points of all sizes: w up to 75 bits, coordinates up to 2^26 units.
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
        if (page > 0) outlines.start_page();
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

// Two squares of the same face are adjacent, on separate pages. Their common edge is removed if
// both squares name the edge alike, have the same owner, and traverse the whole edge in opposite
// directions.
TEST(Outlines, DropsWhatGoesThereAndBack) {
    enum class Second { ProjectionSeed, OfAnother, SameWay, Longer };
    for (const Second second :
         {Second::ProjectionSeed, Second::OfAnother, Second::SameWay, Second::Longer}) {
        Outlines outlines;
        const std::uint32_t floor = outlines.add_plane({0, 0, 1, 0});
        const std::uint32_t left = outlines.add_plane({1, 0, 0, 0});
        const std::uint32_t seam = outlines.add_plane({1, 0, 0, 10});
        const std::uint32_t right = outlines.add_plane({1, 0, 0, 20});
        const std::uint32_t front = outlines.add_plane({0, 1, 0, 0});
        const std::uint32_t back = outlines.add_plane({0, 1, 0, 10});
        const std::uint32_t beyond = outlines.add_plane({0, 1, 0, 20});
        std::vector<std::uint32_t> seams;
        const auto add = [&](std::uint32_t edge, std::uint32_t tail, std::uint32_t head,
                             Origin origin) {
            if (edge == seam) seams.push_back(static_cast<std::uint32_t>(outlines.pieces().size()));
            outlines.add({2 * floor, edge, origin, outlines.point(floor, edge, tail),
                          outlines.point(floor, edge, head)});
        };
        const Origin first{1};
        add(front, left, seam, first);
        add(seam, front, back, first);
        add(back, seam, left, first);
        add(left, back, front, first);
        outlines.start_page();
        const Origin other = second == Second::OfAnother ? Origin{2} : first;
        const std::uint32_t end = second == Second::Longer ? beyond : back;
        add(front, seam, right, other);
        add(right, front, end, other);
        add(end, right, seam, other);
        second == Second::SameWay ? add(seam, front, end, other) : add(seam, end, front, other);
        EXPECT_EQ(outlines.points().size(), 8U);
        outlines.cancel(seams);
        const bool cancels = second == Second::ProjectionSeed;
        EXPECT_EQ(outlines.pieces().size(), cancels ? 6U : 8U);
        EXPECT_EQ(outlines.points().size(), 8U);  // more pieces end there
        double doubled_area = 0.0;
        for (const Outlines::Piece& piece : outlines.pieces()) {
            const Vec3 tail = outlines.points()[piece.tail].fixed.approx();
            const Vec3 head = outlines.points()[piece.head].fixed.approx();
            doubled_area += tail.x * head.y - tail.y * head.x;
        }
        if (cancels) {
            EXPECT_EQ(doubled_area, 2.0 * 200.0);
        }
    }
}

// Points that only dropped pieces have are dropped, and the remaining points are renumbered.
TEST(Outlines, DropsPointsOfDroppedPieces) {
    Outlines outlines;
    const std::uint32_t floor = outlines.add_plane({0, 0, 1, 0});
    const std::uint32_t seam = outlines.add_plane({1, 0, 0, 10});
    std::vector<std::uint32_t> across;
    for (std::int32_t i = 0; i < 4; ++i)
        across.push_back(outlines.add_plane({0, 1, 0, 10 * i}));
    const auto add = [&](std::size_t from, std::size_t to) {
        outlines.add({2 * floor, seam, Origin{1}, outlines.point(floor, seam, across[from]),
                      outlines.point(floor, seam, across[to])});
    };
    add(0, 1);
    add(2, 3);
    outlines.start_page();
    add(1, 0);
    const std::vector<std::uint32_t> seams{0, 1, 2};
    outlines.cancel(seams);
    ASSERT_EQ(outlines.pieces().size(), 1U);
    ASSERT_EQ(outlines.points().size(), 2U);
    EXPECT_EQ(outlines.points()[outlines.pieces()[0].tail].fixed.approx().y, 20.0);
    EXPECT_EQ(outlines.points()[outlines.pieces()[0].head].fixed.approx().y, 30.0);
}

}  // namespace
}  // namespace ncsim::cda
