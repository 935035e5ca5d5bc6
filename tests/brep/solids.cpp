// SPDX-License-Identifier: GPL-3.0-or-later
//
// Builds solids from vertices, edges and faces.
#include "brep/solids.h"

#include "ncsim/brep/frames.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace ncsim::brep::test {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr Vec3 kUp{0, 0, 1};

class Builder {
public:
    std::uint32_t vertex(Vec3 p) {
        part_.vertices.push_back(p);
        return static_cast<std::uint32_t>(part_.vertices.size() - 1);
    }
    std::uint32_t edge(std::uint32_t from, std::uint32_t to, Curve curve = Line{}) {
        part_.edges.push_back({from, to, std::move(curve)});
        return static_cast<std::uint32_t>(part_.edges.size() - 1);
    }
    // Adds a circle about the Z-axis or about a parallel to Z, counter-clockwise from above.
    std::uint32_t circle(Vec3 centre, double radius) {
        const std::uint32_t v = vertex(centre + Vec3{radius, 0, 0});
        return edge(v, v, Circle{centre, kUp, radius});
    }
    // Adds a face. `loops` are numbers of edges from 1; a negative number reverses the edge.
    void face(const Surface& surface, const std::vector<std::vector<int>>& loops) {
        Face face;
        face.surface = surface;
        for (const auto& numbers : loops) {
            Loop& loop = face.loops.emplace_back();
            for (const int n : numbers)
                loop.push_back({static_cast<std::uint32_t>(std::abs(n) - 1), n > 0});
        }
        face.origins = {cda::kStockOrigin};
        face.frame = frame_for(part_, face);
        part_.faces.push_back(std::move(face));
    }
    Part finish() {
        Solid solid;
        for (std::uint32_t f = 0; f < part_.faces.size(); ++f)
            solid.outside.push_back(f);
        part_.solids.push_back(std::move(solid));
        return std::move(part_);
    }

private:
    Part part_;
};

int number(std::uint32_t edge) {
    return static_cast<int>(edge) + 1;
}

// Outer loops of the top and the bottom of a box on Z0. Both have no face yet, so more loops can be
// added.
struct Box {
    std::vector<int> top, bottom;
};
Box box(Builder& b, double x, double y, double z) {
    std::vector<std::uint32_t> low, high;
    const std::vector<std::pair<double, double>> corners{{0, 0}, {x, 0}, {x, y}, {0, y}};
    for (const auto& [u, v] : corners) {
        low.push_back(b.vertex({u, v, 0}));
        high.push_back(b.vertex({u, v, z}));
    }
    std::vector<int> l, h, up;
    for (std::size_t i = 0; i < 4; ++i) {
        l.push_back(number(b.edge(low[i], low[(i + 1) % 4])));
        h.push_back(number(b.edge(high[i], high[(i + 1) % 4])));
        up.push_back(number(b.edge(low[i], high[i])));
    }
    const std::vector<Vec3> normals{{0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 at{corners[i].first, corners[i].second, 0};
        b.face({Plane{at, normals[i]}}, {{l[i], up[(i + 1) % 4], -h[i], -up[i]}});
    }
    return {h, {-l[3], -l[2], -l[1], -l[0]}};
}

Surface floor_at(double z) {
    return {Plane{{0, 0, z}, kUp}};
}
Surface ceiling_at(double z) {
    return {Plane{{0, 0, z}, -kUp}};
}

NamedPart cylinder() {
    Builder b;
    const int low = number(b.circle({0, 0, 0}, 5)), high = number(b.circle({0, 0, 8}, 5));
    b.face(ceiling_at(0), {{-low}});
    b.face(floor_at(8), {{high}});
    b.face({Cylinder{{}, kUp, 5}}, {{low}, {-high}});
    return {"cylinder", b.finish(), kPi * 25 * 8, 3};
}

NamedPart frustum() {
    Builder b;
    const int low = number(b.circle({0, 0, 0}, 6)), high = number(b.circle({0, 0, 4}, 3));
    b.face(ceiling_at(0), {{-low}});
    b.face(floor_at(4), {{high}});
    b.face({Cone{{0, 0, 8}, -kUp, 0.75}}, {{low}, {-high}});
    return {"frustum", b.finish(), kPi * 4 / 3 * (36 + 18 + 9), 3};
}

NamedPart bored_box() {
    Builder b;
    const Box sides = box(b, 20, 16, 10);
    const int low = number(b.circle({10, 8, 0}, 3)), high = number(b.circle({10, 8, 10}, 3));
    b.face(ceiling_at(0), {sides.bottom, {low}});
    b.face(floor_at(10), {sides.top, {-high}});
    b.face({Cylinder{{10, 8, 0}, kUp, 3}, true}, {{-low}, {high}});
    return {"bored_box", b.finish(), 20 * 16 * 10 - kPi * 9 * 10, 7};
}

NamedPart drilled_box() {
    Builder b;
    const Box sides = box(b, 20, 16, 10);
    const int low = number(b.circle({10, 8, 5}, 3)), high = number(b.circle({10, 8, 10}, 3));
    b.face(ceiling_at(0), {sides.bottom});
    b.face(floor_at(10), {sides.top, {-high}});
    b.face({Cylinder{{10, 8, 0}, kUp, 3}, true}, {{-low}, {high}});
    b.face({Cone{{10, 8, 3}, kUp, 1.5}, true}, {{low}});
    return {"drilled_box", b.finish(), 20 * 16 * 10 - kPi * 9 * (5 + 2.0 / 3), 8};
}

NamedPart dimpled_box() {
    Builder b;
    const Box sides = box(b, 20, 16, 10);
    const int high = number(b.circle({10, 8, 10}, 4));
    b.face(ceiling_at(0), {sides.bottom});
    b.face(floor_at(10), {sides.top, {-high}});
    b.face({Sphere{{10, 8, 10}, 4}, true}, {{high}});
    return {"dimpled_box", b.finish(), 20 * 16 * 10 - kPi * 64 * 2 / 3, 7};
}

// Returns a box with a slot from (6, 8) to (14, 8), 6 mm wide and 4 mm deep.
NamedPart slotted_box() {
    Builder b;
    const Box sides = box(b, 20, 16, 10);
    std::vector<int> low, high, up;
    for (const double z : {6.0, 10.0}) {
        const std::uint32_t v[4] = {b.vertex({6, 5, z}), b.vertex({14, 5, z}),
                                    b.vertex({14, 11, z}), b.vertex({6, 11, z})};
        auto& to = z < 10 ? low : high;
        to = {number(b.edge(v[0], v[1])), number(b.edge(v[1], v[2], Circle{{14, 8, z}, kUp, 3})),
              number(b.edge(v[2], v[3])), number(b.edge(v[3], v[0], Circle{{6, 8, z}, kUp, 3}))};
        if (z < 10) continue;
        for (std::uint32_t i = 0; i < 4; ++i)
            up.push_back(number(b.edge(v[i] - 4, v[i])));
    }
    b.face(ceiling_at(0), {sides.bottom});
    b.face(floor_at(10), {sides.top, {-high[3], -high[2], -high[1], -high[0]}});
    b.face(floor_at(6), {low});
    const std::vector<Surface> walls{{Plane{{6, 5, 0}, {0, 1, 0}}},
                                     {Cylinder{{14, 8, 0}, kUp, 3}, true},
                                     {Plane{{6, 11, 0}, {0, -1, 0}}},
                                     {Cylinder{{6, 8, 0}, kUp, 3}, true}};
    for (std::size_t i = 0; i < 4; ++i)
        b.face(walls[i], {{-low[i], up[i], high[i], -up[(i + 1) % 4]}});
    return {"slotted_box", b.finish(), 20 * 16 * 10 - 4 * (8 * 6 + kPi * 9), 11};
}

// Returns a bar of radius 20, 10 high, with a groove of a ball of radius 2 along the circle of
// radius 12 (mm).
NamedPart grooved_bar() {
    Builder b;
    const int low = number(b.circle({0, 0, 0}, 20)), high = number(b.circle({0, 0, 10}, 20));
    const int in = number(b.circle({0, 0, 10}, 10)), out = number(b.circle({0, 0, 10}, 14));
    b.face(ceiling_at(0), {{-low}});
    b.face({Cylinder{{}, kUp, 20}}, {{low}, {-high}});
    b.face(floor_at(10), {{high}, {-out}});
    b.face(floor_at(10), {{in}});
    b.face({Torus{{0, 0, 10}, kUp, 12, 2}, true}, {{-in}, {out}});
    return {"grooved_bar", b.finish(), kPi * 400 * 10 - 2 * kPi * 12 * kPi * 4 / 2, 5};
}

Extrusion slanting() {
    return {{7, 8, 0}, kUp, {0.6, 0, 0.8}, 4};
}

NamedPart slanting_cylinder() {
    Builder b;
    const int low = number(b.circle({7, 8, 0}, 4)), high = number(b.circle({13, 8, 8}, 4));
    b.face(ceiling_at(0), {{-low}});
    b.face(floor_at(8), {{high}});
    b.face({slanting()}, {{low}, {-high}});
    return {"slanting_cylinder", b.finish(), kPi * 16 * 8, 3};
}

NamedPart slanting_bore() {
    Builder b;
    const Box sides = box(b, 20, 16, 8);
    const int low = number(b.circle({7, 8, 0}, 4)), high = number(b.circle({13, 8, 8}, 4));
    b.face(ceiling_at(0), {sides.bottom, {low}});
    b.face(floor_at(8), {sides.top, {-high}});
    b.face({slanting(), true}, {{-low}, {high}});
    return {"slanting_bore", b.finish(), 20 * 16 * 8 - kPi * 16 * 8, 7};
}

}  // namespace

std::vector<NamedPart> solids() {
    return {cylinder(),    frustum(),     bored_box(),         drilled_box(),  dimpled_box(),
            slotted_box(), grooved_bar(), slanting_cylinder(), slanting_bore()};
}

}  // namespace ncsim::brep::test
