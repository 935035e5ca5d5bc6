// SPDX-License-Identifier: GPL-3.0-or-later
//
// Samples, from text to surface, with both models: a hundred thousand points near the surface
// compared with the definition of the part, closed surfaces, and equal pictures.
#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/check.h"
#include "ncsim/cda/flat.h"
#include "ncsim/cda/tree.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/export/camera.h"
#include "ncsim/export/render.h"
#include "ncsim/export/step.h"
#include "ncsim/mesh/simplify.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/trace.h"

#include "options/plan_options.h"
#include "run/picture.h"
#include "support/count.h"
#include "support/golden.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

namespace ncsim {
namespace {

// A sample, run once with each model.
struct Sample {
    setup::InputSet inputs;
    app::Options options;
    simulation::Plan plan;
    simulation::Survey survey;
    simulation::Simulation tree, flat;
    cda::Boundary boundary, flat_boundary;
};

const Sample& sample(const std::string& name) {
    static std::map<std::string, std::unique_ptr<Sample>> samples;
    auto& slot = samples[name];
    if (!slot) {
        slot = std::make_unique<Sample>();
        app::Options& options = slot->options;
        options.program = std::string(NCSIM_SOURCE_DIR) + "/samples/" + name + ".nc";
        options.model = "cda";
        // Keeps the cells of circumscribed tools; no file is written here.
        options.save_stock = "kept.ncstock";
        slot->plan = app::plan_for(options, slot->inputs);
        slot->survey = simulation::survey(slot->plan);
        slot->tree = simulation::simulate(slot->plan, slot->survey, {}, {});
        slot->plan.model = "cda-flat";
        slot->flat = simulation::simulate(slot->plan, slot->survey, {}, {});
        slot->boundary = slot->tree.part->boundary();
        slot->flat_boundary = slot->flat.part->boundary();
    }
    return *slot;
}

class Samples : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, Samples, testing::Values("simple", "complex", "wave"),
                         [](const auto& test) { return test.param; });

// A tool with a five times finer tolerance represents the round tool.
TEST(FairTools, LeaveTheVolumeThatRoundOnesLeave) {
    const auto volume = [](double tolerance, toolpath::Side side) {
        setup::InputSet inputs;
        app::Options options;
        options.program = std::string(NCSIM_SOURCE_DIR) + "/samples/wave.nc";
        options.model = "cda";
        options.tool_tolerance = tolerance;
        simulation::Plan plan = app::plan_for(options, inputs);
        const simulation::Survey survey = simulation::survey(plan);
        simulation::Verification verification;
        verification.side = side;
        return simulation::simulate(plan, survey, verification, {}).part->volume();
    };
    const double round = volume(0.01, toolpath::Side::Fair);
    EXPECT_NEAR(volume(0.05, toolpath::Side::Fair), round, 2e-4 * round);
    EXPECT_LT(volume(0.05, toolpath::Side::Circumscribed), round - 1e-3 * round);
}

TEST_P(Samples, RunWithoutFindings) {
    const Sample& s = sample(GetParam());
    EXPECT_TRUE(s.survey.is_ready());
    EXPECT_TRUE(s.survey.diagnostics.empty());
    EXPECT_GT(s.tree.part_volume, 0.0);
    EXPECT_LT(s.tree.part_volume, s.tree.stock_volume);
}

TEST_P(Samples, AreAsLargeAsThoseOfTheThesis) {
    const auto cells =
        dynamic_cast<const cda::FlatCda&>(*sample(GetParam()).flat.part).negative().size();
    const double count = static_cast<double>(cells);
    if (GetParam() == "simple") {
        EXPECT_NEAR(count, 20.0, 5.0);
    } else if (GetParam() == "complex") {
        EXPECT_NEAR(count, 120.0, 20.0);
    } else {
        EXPECT_GE(count, 900.0);
    }
}

TEST_P(Samples, HaveClosedSurfacesOfTheRightVolume) {
    const Sample& s = sample(GetParam());
    for (const cda::Boundary* boundary : {&s.boundary, &s.flat_boundary}) {
        EXPECT_TRUE(cda::check(*boundary).is_closed());
        EXPECT_LE(cda::check(*boundary).relative_area_sum, 1e-12);
        const TriangleMesh mesh = cda::triangulate(*boundary);
        EXPECT_TRUE(cda::check(mesh).is_closed());
        // The flat aggregate counts its volume cut by cut, and the tree sums over its leaves. CGAL,
        // or the stitching, makes the mesh from the facets.
        EXPECT_NEAR(cda::volume(mesh), s.flat.part_volume, 1e-9 * s.flat.part_volume);
        EXPECT_NEAR(cda::volume(*boundary), s.tree.part_volume, 1e-9 * s.flat.part_volume);
    }
}

TEST_P(Samples, BothModelsMakeTheSameSurface) {
    const Sample& s = sample(GetParam());
    const cda::Boundary& flat = s.flat_boundary;
    ASSERT_EQ(s.boundary.faces.size(), flat.faces.size());
    EXPECT_TRUE(s.boundary.vertices == flat.vertices);
    for (std::size_t i = 0; i < flat.faces.size(); ++i) {
        ASSERT_EQ(s.boundary.faces[i].loops, flat.faces[i].loops);
        ASSERT_EQ(s.boundary.faces[i].origin, flat.faces[i].origin);
    }
}

// Returns FNV-1a over the content of a boundary.
std::uint64_t hash_of(const cda::Boundary& boundary) {
    std::uint64_t h = 0xcbf29ce484222325ULL;
    const auto mix = [&h](std::uint64_t v) {
        for (int i = 0; i < 8; ++i)
            h = (h ^ ((v >> (8 * i)) & 0xffU)) * 0x100000001b3ULL;
    };
    for (const Vec3& v : boundary.vertices) {
        for (int axis = 0; axis < 3; ++axis)
            mix(std::bit_cast<std::uint64_t>(v[axis] + 0.0));
    }
    for (const cda::BoundaryFace& face : boundary.faces) {
        mix(static_cast<std::uint32_t>(face.origin));
        for (const auto& loop : face.loops) {
            mix(loop.size());
            for (const std::uint32_t vertex : loop)
                mix(vertex);
        }
    }
    return h;
}

// The surface does not depend on threads, order, leaves, batches or the compilation.
TEST_P(Samples, AreTheSameHoweverTheyAreMade) {
    const Sample& s = sample(GetParam());
    const std::map<std::string, std::uint64_t> known{{"simple", 12224367145059853698U},
                                                     {"complex", 9565089550310807006U},
                                                     {"wave", 10327530260237418823U}};
    EXPECT_EQ(hash_of(s.boundary), known.at(GetParam()));
    ASSERT_GE(s.tree.carved.size(), 2U);
    const cda::Shape stock = toolpath::stock_shape(*s.survey.stock, 0.05);
    // Inserts only the cells, without the merged cells of steps, which have different lines.
    cda::TreeCda once(stock.outer, stock.lattice);
    once.subtract_unmeasured(s.tree.carved);
    const cda::Boundary expected = once.boundary();
    EXPECT_NEAR(cda::volume(expected), cda::volume(s.boundary), 1e-9);
    test::Random random(11);
    for (const cda::TreeParameters& parameters :
         {cda::TreeParameters{20, 1}, {80, 2}, {300, 8}, {33, 3}}) {
        std::vector<cda::Cell> cells = s.tree.carved;
        for (std::size_t i = cells.size(); i > 1; --i)
            std::swap(cells[i - 1], cells[random.next() % i]);
        cda::TreeCda part(stock.outer, stock.lattice, parameters);
        const std::span<const cda::Cell> all(cells);
        for (std::size_t at = 0; at < all.size();) {
            const auto count = std::min<std::size_t>(1 + random.next() % 200, all.size() - at);
            part.subtract_unmeasured(all.subspan(at, count));
            at += count;
        }
        EXPECT_EQ(hash_of(part.boundary()), hash_of(expected));
    }
}

// Every point near a surface is on the side that the definition states: in the stock and in no
// hull.
TEST_P(Samples, AgreeWithTheDefinitionNearTheSurface) {
    const Sample& s = sample(GetParam());
    // Makes the hulls again from the program.
    std::vector<cda::Cell> hulls;
    std::map<int, toolpath::Cutter> cutters;
    for (const auto& [number, used] : s.survey.tools) {
        cutters.try_emplace(number, used.tool, s.tree.lattice, toolpath::ToolAccuracy{});
    }
    gcode::interpret(s.plan.job.program, s.plan.job.interpreter, [&](const gcode::Motion& motion) {
        const auto cutter = cutters.find(motion.tool);
        if (cutter == cutters.end() || !toolpath::has_known_start(motion)) return;
        const auto path = toolpath::sample(motion, cutter->second.extent(), {});
        for (std::size_t i = 1; i < path.poses.size(); ++i) {
            cutter->second.trace(path.poses[i - 1], path.poses[i], cda::Origin{1}, hulls);
        }
    });

    const TriangleMesh mesh = cda::triangulate(s.boundary);
    test::Random random(7);
    const auto unit = [&] { return static_cast<double>(random.next() >> 11) * 0x1p-53; };
    const double lattice_unit = s.tree.lattice.unit_mm;
    int disagreements = 0;
    for (int i = 0; i < 100000; ++i) {
        // A point on a random triangle, moved by up to 10 µm along each axis.
        const auto& t = mesh.triangles[random.next() % mesh.triangles.size()];
        double u = unit();
        double v = unit();
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        const Vec3 a = mesh.vertices[t[0]];
        Vec3 p = a + u * (mesh.vertices[t[1]] - a) + v * (mesh.vertices[t[2]] - a);
        for (int axis = 0; axis < 3; ++axis)
            p[axis] += 0.02 * (unit() - 0.5);
        // A tenth of a unit around every plane is left to rounding.
        const double slack = 0.1 * lattice_unit;
        bool is_near = false;
        const auto inside = [&](const std::vector<cda::Plane>& planes) {
            double highest = -1e300;
            for (const cda::Plane& h : planes) {
                highest = std::max(highest,
                                   dot(cda::unit_normal(h), p) - cda::offset_mm(h, s.tree.lattice));
                if (highest > slack) return false;
            }
            is_near = is_near || highest > -slack;
            return highest < 0.0;
        };
        const Box& stock = s.survey.stock->box;
        bool expected = stock.contains(p);
        for (const cda::Cell& hull : hulls) {
            if (!expected) break;
            if (hull.bounds.contains(p)) expected = !inside(hull.planes);
        }
        if (is_near) continue;
        disagreements += s.tree.part->contains(p) != expected;
        disagreements += s.flat.part->contains(p) != expected;
    }
    EXPECT_EQ(disagreements, 0);
}

// The hulls of the line that a wall names touch the triangle's plane from outside the material, and
// reach its middle. Uncut faces lie in the sides of the block.
TEST_P(Samples, NameTheLineThatCutEachTriangle) {
    const Sample& s = sample(GetParam());
    std::vector<cda::Cell> hulls;
    std::map<std::uint32_t, std::vector<std::size_t>> hulls_of;  // by line
    // The preceding line if a line continues it straight, and the length of each line.
    std::map<std::uint32_t, std::uint32_t> goes_on;
    std::map<std::uint32_t, double> length;
    std::uint32_t last_line = 0;
    Vec3 last_way;
    std::map<int, toolpath::Cutter> cutters;
    for (const auto& [number, used] : s.survey.tools) {
        cutters.try_emplace(number, used.tool, s.tree.lattice, toolpath::ToolAccuracy{});
    }
    gcode::interpret(s.plan.job.program, s.plan.job.interpreter, [&](const gcode::Motion& motion) {
        const auto cutter = cutters.find(motion.tool);
        if (cutter == cutters.end() || !toolpath::has_known_start(motion)) return;
        const auto path = toolpath::sample(motion, cutter->second.extent(), {});
        if (path.poses.empty()) return;
        const std::size_t first = hulls.size();
        for (std::size_t i = 1; i < path.poses.size(); ++i) {
            cutter->second.trace(path.poses[i - 1], path.poses[i], cda::Origin{1}, hulls);
        }
        const std::uint32_t line = motion.span.line;
        for (std::size_t i = first; i < hulls.size(); ++i)
            hulls_of[line].push_back(i);
        const Vec3 way = path.poses.back().translation - path.poses.front().translation;
        const bool is_straight = std::holds_alternative<gcode::Linear>(motion.action);
        const double both = norm(way) * norm(last_way);
        if (is_straight && both > 0.0 && dot(way, last_way) > (1.0 - 1e-12) * both)
            goes_on[line] = last_line;
        length[line] = norm(way);
        last_line = line;
        last_way = is_straight ? way : Vec3{};
    });

    const TriangleMesh mesh = cda::triangulate(s.boundary);
    test::Random random(11);
    const double slack = 2.0 * s.tree.lattice.unit_mm;
    int cut = 0;
    for (int i = 0; i < 1000; ++i) {
        const std::size_t t = random.next() % mesh.triangles.size();
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3 p = (1.0 / 3.0) * (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]);
        const cda::BoundaryFace& face = s.boundary.faces[mesh.face[t]];
        const auto line = s.tree.provenance.of(face.origin).nc_line;
        if (line == 0) {
            const Box& box = s.survey.stock->box;
            const Vec3 outside = p + 2.0 * slack * face.normal;
            EXPECT_TRUE(box.contains(p - slack * face.normal) && !box.contains(outside));
            continue;
        }
        ++cut;
        const auto is_made_by = [&](std::uint32_t made_by) {
            const std::vector<std::size_t>& its = hulls_of[made_by];
            return std::any_of(its.begin(), its.end(), [&](std::size_t h) {
                bool touches = false;
                for (const cda::Plane& plane : hulls[h].planes) {
                    const Vec3 n = cda::unit_normal(plane);
                    const double off = dot(n, p) - cda::offset_mm(plane, s.tree.lattice);
                    if (off > slack) return false;
                    touches |= off > -slack && dot(n, face.normal) < -1.0 + 1e-9;
                }
                return touches;
            });
        };
        // A preceding line on the same straight path, within the width of the tool, may have made
        // the wall.
        constexpr double kWidest = 6.2;  // mm, in wave.nc
        bool is_made = is_made_by(line);
        double back = length[line];
        for (std::uint32_t at = line; !is_made && goes_on.contains(at);) {
            at = goes_on[at];
            back += length[at];
            if (back > kWidest) break;
            is_made = is_made_by(at);
        }
        EXPECT_TRUE(is_made) << "line " << line;
    }
    EXPECT_GT(cut, 500);
}

// Faces of simple.nc, counted by hand. The tool has 20 sides, so a slot ends in 9 facets.
//
//  - the block: bottom, 4 sides                                                          5
//  - its top, between the ten grooves: 11 strips. The four slots cut the 3 outer strips per side
//    into 3 pieces (6 · 3), 5 in the middle are whole; behind each corner that was cut off,
//    a triangle is left (4)                                                             27
//  - 4 corners: a floor and two walls each                                              12
//  - 4 slots: a floor, two walls, 9 facets each                                         48
//  - grooves 4 to 7: a floor and two walls each                                         12
//  - grooves 3 and 8, which slots reach into from a side: that wall in 3 pieces, 5 each   10
//  - grooves 1, 2, 9, 10, which slots cross: floor and walls in 3 pieces, 9 each        36
constexpr std::size_t kFacesOfSimple = 5 + 27 + 12 + 48 + 12 + 10 + 36;

TEST(SampleFaces, OfSimpleAreThoseThatAPersonCounts) {
    const Sample& s = sample("simple");
    EXPECT_EQ(mesh::simplify(s.boundary, mesh::kFlatTolerance).boundary.faces.size(),
              kFacesOfSimple);
    EXPECT_EQ(mesh::simplify(s.flat_boundary, mesh::kFlatTolerance).boundary.faces.size(),
              kFacesOfSimple);
    // No two lines cut the same face: a tool that retracts along its axis cuts no more.
    const auto by_line = mesh::simplify(s.boundary, mesh::kFlatTolerance, &s.tree.provenance);
    EXPECT_EQ(by_line.boundary.faces.size(), kFacesOfSimple);
    std::map<std::uint32_t, std::size_t> faces;
    for (const auto& face : by_line.boundary.faces)
        ++faces[s.tree.provenance.of(face.origin).nc_line];
    EXPECT_EQ(faces[0], 5U + 27U);
    EXPECT_EQ(faces[15], 9U);
    EXPECT_EQ(faces[23], 5U);
    EXPECT_EQ(faces[27], 3U);
    EXPECT_EQ(faces[56], 12U);
    EXPECT_EQ(faces[60] + faces[61], 12U);
    EXPECT_EQ(faces[74], 3U);
    EXPECT_TRUE(cda::check(by_line.boundary).is_closed());
}

// Files have no seams either: STEP has a face for each, and triangles are as few as the faces
// permit.
TEST(SampleFaces, OfSimpleStandInFilesOnce) {
    const Sample& s = sample("simple");
    const cda::Boundary part =
        mesh::simplify(s.boundary, mesh::kFlatTolerance, &s.tree.provenance).boundary;
    std::ostringstream step;
    exporter::write_step(step, s.boundary, s.tree.provenance);
    EXPECT_EQ(test::count(step.str(), "ADVANCED_FACE("), kFacesOfSimple);
    std::size_t corners = 0;
    for (const auto& face : part.faces) {
        EXPECT_EQ(face.loops.size(), 1U);
        corners += face.loops.front().size();
    }
    // 3MF and PLY have triangles only: the least number into which the polygons can be cut.
    EXPECT_EQ(cda::triangulate(part).triangles.size(), corners - 2 * kFacesOfSimple);
}

// Compares with golden pictures: the picture of `ncsim run --png`, but smaller.
TEST_P(Samples, LookAsTheyDid) {
    const Sample& s = sample(GetParam());
    app::Options options = s.options;
    options.width = 480;
    options.height = 360;
    app::Outcome outcome{options, s.plan, s.survey, &s.tree};
    outcome.boundary = &s.boundary;
    test::expect_like_golden(app::picture(outcome), "samples/golden/" + GetParam() + ".png");
}

// Compares the stencil buffer of the thesis with the computed surface, pixel by pixel except at
// edges.
TEST_P(Samples, LookTheSameThroughTheStencilAndAsASurface) {
    const Sample& s = sample(GetParam());
    exporter::RenderOptions options;
    options.width = 640;
    options.height = 480;
    options.edges = false;
    options.samples = 1;
    options.camera = exporter::fit_camera(s.survey.stock->box, exporter::View::Iso, 640.0 / 480.0);
    const exporter::Image masked = exporter::render_model(
        dynamic_cast<const cda::CellModel&>(*s.flat.part), s.flat.provenance, options);
    const exporter::Image surface =
        exporter::render_boundary(s.boundary, s.tree.provenance, options);
    ASSERT_EQ(masked.pixels.size(), surface.pixels.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < masked.pixels.size(); ++i) {
        const exporter::Rgba8& a = masked.pixels[i];
        const exporter::Rgba8& b = surface.pixels[i];
        const int distance =
            std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        different += distance > 24;
    }
    // Pixels with an edge through their centre may show either face.
    EXPECT_LE(different, masked.pixels.size() / 200);
}

}  // namespace
}  // namespace ncsim
