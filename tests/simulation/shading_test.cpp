// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts cut by round tools are shaded as the surfaces that the facets approximate.
#include "ncsim/simulation/shading.h"

#include "ncsim/export/camera.h"
#include "ncsim/export/gltf.h"
#include "ncsim/export/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <set>
#include <sstream>
#include <string>

namespace ncsim::simulation {
namespace {

using brep::Shading;

struct Milled {
    Simulation simulation;
    Shading shading;

    const cda::Boundary& boundary() const { return *simulation.boundary; }
    // Returns the corners of cut faces longer than 30 mm along X whose normals have a Z of at most
    // `most_up`.
    std::set<std::uint32_t> corners_of_long_faces(double most_up) const {
        std::set<std::uint32_t> corners;
        for (const cda::BoundaryFace& face : boundary().faces) {
            if (face.origin == cda::kStockOrigin || face.normal.z > most_up) continue;
            Box box;
            for (const std::uint32_t v : face.loops[0])
                box.add(boundary().vertices[v]);
            if (box.size().x > 30.0) corners.insert(face.loops[0].begin(), face.loops[0].end());
        }
        return corners;
    }
    // Calls `visit` for each corner of each round face, with number, position, normal, and normal
    // of the facet.
    void for_each_round(
        const std::function<void(std::uint32_t v, Vec3 p, Vec3 n, Vec3 own)>& visit) const {
        for (std::uint32_t f = 0; f < boundary().faces.size(); ++f) {
            if (shading.recognition(f) != Shading::Recognition::Curved) continue;
            const cda::BoundaryFace& face = boundary().faces[f];
            for (const auto& loop : face.loops) {
                for (const std::uint32_t v : loop) {
                    const Vec3 p = boundary().vertices[v];
                    visit(v, p, shading.normal(f, face.normal, v, p), face.normal);
                }
            }
        }
    }
    std::size_t round_faces() const { return count(Shading::Recognition::Curved); }
    std::size_t count(Shading::Recognition recognition) const {
        std::size_t sum = 0;
        for (std::uint32_t f = 0; f < boundary().faces.size(); ++f)
            sum += shading.recognition(f) == recognition ? 1U : 0U;
        return sum;
    }
};

// Simulates moves on a block of 80 x 60 x 20 mm with a corner at the zero and its top at Z20.
Milled mill(const std::string& moves, double tool_tolerance = 0.05, unsigned threads = 1) {
    Plan plan;
    plan.job =
        setup::job_of({"shade.nc",
                       "(T1 D=10. CR=0. - flat end mill)\n(T2 D=6. CR=0. TAPER=118deg - drill)\n"
                       "(T3 D=8. CR=4. - ball end mill)\n(T4 D=12. CR=2. - bull nose end mill)\n"
                       "(T6 D=40. CR=0. - flat end mill)\n"
                       "(STOCK/BLOCK,80.,60.,20.,0.,0.,0.)\nG21 G90 G17 F300 S5000 M3\n" +
                           moves + "M30\n"});
    plan.keep_boundary = true;
    plan.tool_tolerance = tool_tolerance;
    plan.threads = threads;
    const Survey survey = simulation::survey(plan);
    EXPECT_TRUE(survey.is_ready());
    Verification nothing;
    nothing.keep_cuts = true;
    Milled milled{simulate(plan, survey, nothing, {}), {}};
    milled.shading = shading_of(plan, survey, milled.simulation, milled.boundary());
    milled.for_each_round([](std::uint32_t, Vec3, Vec3 n, Vec3 own) {
        EXPECT_NEAR(norm(n), 1.0, 1e-12);
        EXPECT_GE(dot(n, own), brep::kLeastShadingCosine);
    });
    return milled;
}

void expect_near(Vec3 a, Vec3 b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

constexpr char kBore[] = "T1 M6\nG0 X40 Y30 Z25\nG1 Z10\nG0 Z25\n";

TEST(Shading, WallsOfBoresLookAtTheAxis) {
    for (const double tolerance : {0.5, 0.05, 0.01}) {
        SCOPED_TRACE(tolerance);
        const Milled milled = mill(kBore, tolerance);
        // At least 16 sides.
        EXPECT_GE(milled.round_faces(), 16U);
        milled.for_each_round([](std::uint32_t, Vec3 p, Vec3 n, Vec3) {
            expect_near(n, normalized({40 - p.x, 30 - p.y, 0.0}), 1e-6);
        });
        // The floor and the sides of the block.
        EXPECT_GE(milled.count(Shading::Recognition::Planar), 7U);
        EXPECT_EQ(milled.count(Shading::Recognition::Unknown), 0U);
    }
}

TEST(Shading, GroovesOfBallsLookAtTheWayOfTheMiddle) {
    const Milled milled = mill("T3 M6\nG0 X20 Y30 Z25\nG1 Z17\nG1 X60\nG0 Z25\n");
    const std::set<std::uint32_t> of_walls = milled.corners_of_long_faces(1.0);
    std::size_t joints = 0, ends = 0;
    milled.for_each_round([&](std::uint32_t v, Vec3 p, Vec3 n, Vec3) {
        if (of_walls.contains(v)) {
            // Up to half a side from the circle in which the ball at rest begins.
            ++joints;
            expect_near(n, normalized({0.0, 30 - p.y, 21 - p.z}), 2e-3);
        } else {
            ++ends;
            expect_near(n, normalized(Vec3{p.x < 40 ? 20.0 : 60.0, 30, 21} - p), 1e-6);
        }
    });
    EXPECT_GT(joints, 20U);
    EXPECT_GT(ends, 20U);
}

TEST(Shading, RoundedCornersAreRings) {
    const Milled milled = mill("T4 M6\nG0 X40 Y30 Z25\nG1 Z10\nG0 Z25\n");
    std::size_t corners = 0;
    milled.for_each_round([&](std::uint32_t, Vec3 p, Vec3 n, Vec3) {
        const Vec3 out = normalized({p.x - 40, p.y - 30, 0.0});
        // The polygon of the wall begins where its corners are outside, up to 0.5 mm below the
        // circle at which the torus touches the wall.
        if (dot(p - Vec3{40, 30, p.z}, out) > 6 - 1e-3) {
            expect_near(n, -out, p.z < 12 + 1e-3 ? 1e-3 : 1e-6);
        } else if (p.z > 10.3) {  // where the torus touches neither floor nor wall
            ++corners;
            expect_near(n, normalized(Vec3{40, 30, 12} + 4.0 * out - p), 1e-6);
        }
    });
    EXPECT_GT(corners, 16U);
}

TEST(Shading, TipsOfDrillsAreCones) {
    const Milled milled = mill("T2 M6\nG0 X40 Y30 Z25\nG1 Z10\nG0 Z25\n");
    const double half = 59.0 * 3.14159265358979324 / 180.0;
    std::size_t corners = 0;
    milled.for_each_round([&](std::uint32_t, Vec3 p, Vec3 n, Vec3 own) {
        const Vec3 towards{40 - p.x, 30 - p.y, 0.0};
        if (norm(towards) < 0.1 || own.z < 0.5) return;
        ++corners;
        const Vec3 level = normalized(towards);
        expect_near(n, {std::cos(half) * level.x, std::cos(half) * level.y, std::sin(half)}, 1e-6);
    });
    EXPECT_GT(corners, 16U);
}

// Walls of the slot are exactly planar, and the ends continue the walls smoothly: a polygon meets
// its wall up to half a side, 12°, from the line of tangency.
TEST(Shading, EndsOfSlotsBeginAsTheirWallsEnd) {
    const Milled milled = mill("T1 M6\nG0 X20 Y30 Z25\nG1 Z10\nG1 X60\nG0 Z25\n");
    const std::set<std::uint32_t> of_walls = milled.corners_of_long_faces(0.5);
    std::size_t walls = 0;
    for (std::uint32_t f = 0; f < milled.boundary().faces.size(); ++f) {
        const cda::BoundaryFace& face = milled.boundary().faces[f];
        if (face.origin == cda::kStockOrigin || std::abs(face.normal.y) < 0.9999 ||
            !std::ranges::all_of(face.loops[0],
                                 [&](std::uint32_t v) { return of_walls.contains(v); }))
            continue;
        ++walls;
        EXPECT_EQ(milled.shading.recognition(f), Shading::Recognition::Planar);
        for (const std::uint32_t v : face.loops[0]) {
            const Vec3 p = milled.boundary().vertices[v];
            EXPECT_EQ(milled.shading.normal(f, face.normal, v, p), face.normal);
        }
    }
    EXPECT_EQ(walls, 2U);
    std::size_t touching = 0;
    milled.for_each_round([&](std::uint32_t v, Vec3 p, Vec3 n, Vec3) {
        EXPECT_NEAR(n.z, 0.0, 1e-9);
        if (!of_walls.contains(v) || std::abs(p.y - 30) < 4.5) return;
        ++touching;
        expect_near(n, {0.0, p.y > 30 ? -1.0 : 1.0, 0.0}, 1e-3);
    });
    // Two at each end of each wall.
    EXPECT_EQ(touching, 8U);
}

TEST(Shading, EdgesStaySharp) {
    // Two crossing grooves: on the ridge between the grooves, each groove has a separate normal.
    const Milled milled =
        mill("T3 M6\nG0 X-10 Y28 Z18\nG1 X90\nG0 Z25\nG0 Y33\nG0 X-10\nG1 Z18\nG1 X90\n");
    std::optional<double> least, greatest;
    milled.for_each_round([&](std::uint32_t, Vec3 p, Vec3 n, Vec3) {
        if (std::abs(p.y - 30.5) > 0.2) return;
        // Calculation by hand: the ball of radius 4 mm, 2.5 mm to the side. The ridge is where the
        // polygons meet, up to the tool tolerance of 0.05 mm from the ball.
        EXPECT_NEAR(std::abs(n.y), 2.5 / 4.0, 2.5 / 4.0 * 0.05 / 4.0);
        least = std::min(least.value_or(n.y), n.y);
        greatest = std::max(greatest.value_or(n.y), n.y);
    });
    ASSERT_TRUE(least && greatest);
    EXPECT_LT(*least, -0.6);
    EXPECT_GT(*greatest, 0.6);
}

TEST(Shading, IsTheSameForAnyNumberOfThreads) {
    const std::string moves = std::string(kBore) + "G0 X10 Y10\nG1 Z12\nG3 X30 Y10 I10 J0\n";
    const auto written = [&](unsigned threads, bool is_shaded = true) {
        const Milled milled = mill(moves, 0.05, threads);
        std::ostringstream out;
        exporter::write_gltf(out, milled.boundary(), milled.simulation.provenance, threads,
                             is_shaded ? milled.shading : Shading());
        return out.str();
    };
    EXPECT_EQ(written(1), written(3));
    EXPECT_NE(written(1), written(1, false));
}

// Returns the largest step of brightness from pixel to pixel over the wall of half a bore of 40 mm,
// seen from the front.
int largest_step(const Milled& milled, const Shading& shading) {
    exporter::RenderOptions options;
    options.width = 640;
    options.height = 240;
    options.camera =
        exporter::fit_camera({{0, 0, 0}, {80, 60, 20}}, exporter::View::Front, 640.0 / 240.0);
    const exporter::Image image = exporter::render_boundary(
        milled.boundary(), milled.simulation.provenance, options, {}, shading);
    const double mm = options.camera.height / options.height;
    const auto column = [&](double x) {
        return static_cast<std::uint32_t>((x - options.camera.target.x) / mm + 320.0);
    };
    const auto row = static_cast<std::uint32_t>(120.0 - (15.0 - options.camera.target.z) / mm);
    int step = 0;
    for (std::uint32_t x = column(22.0); x < column(58.0); ++x)
        step = std::max(step, std::abs(image.at(x + 1, row).g - image.at(x, row).g));
    return step;
}

TEST(Shading, PicturesOfBoresHaveNoBands) {
    for (const double tolerance : {1.0, 0.05}) {
        SCOPED_TRACE(tolerance);
        const Milled milled = mill("T6 M6\nG0 X40 Y0 Z25\nG1 Z10\nG0 Z25\n", tolerance);
        EXPECT_LE(largest_step(milled, milled.shading), 4);
        EXPECT_GE(largest_step(milled, {}), tolerance > 0.5 ? 12 : 6);
    }
}

}  // namespace
}  // namespace ncsim::simulation
