// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads fixtures.
#include "machines/fixture_reader.h"

#include "ncsim/setup/coordinate_systems.h"

#include "meshes/mesh_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace ncsim::setup {

namespace {

/// A part of a vise or a clamp.
struct NamedBox {
    std::string name;
    Box box;
};

/// Box whose coordinates are: along a horizontal direction, across this direction, height.
Box box_along(int axis, Vec3 at, Vec3 low, Vec3 high) {
    Box box;
    for (const Vec3& corner : {low, high}) {
        Vec3 p = at;
        p[axis] += corner.x;
        p[1 - axis] += corner.y;
        p.z += corner.z;
        box.add(p);
    }
    return box;
}

// Reads required keys, each followed by its value. Throws the error of the first missing key.
void read_required(const TomlReader&, const TomlTable&) {}
template <class Value, class... Rest>
void read_required(const TomlReader& r, const TomlTable& t, const char* key, Value& value,
                   Rest&... rest) {
    if (!t[key]) r.fail(t.node(), fmt::format("'{}' needs {}", t.name(), key));
    t.read(key, value);
    read_required(r, t, rest...);
}

std::vector<NamedBox> read_vise(const TomlReader& r, const TomlTable& t) {
    Vec3 at;
    std::string along = "Y";
    double opening = 0.0, width = 0.0, height = 0.0, depth = 0.0, base = 0.0;
    std::optional<std::array<double, 2>> parallels;
    read_required(r, t, "at", at, "opening", opening, "jaw_width", width, "jaw_height", height,
                  "jaw_depth", depth);
    t.read("along", along);
    t.read("base_height", base);
    t.read("parallels", parallels);
    const int axis = along[0] - 'X';
    const double half = opening / 2, end = half + depth, side = width / 2;
    std::vector<NamedBox> parts{
        {"fixed jaw", box_along(axis, at, {-end, -side, 0}, {-half, side, height})},
        {"moving jaw", box_along(axis, at, {half, -side, 0}, {end, side, height})}};
    if (base > 0.0)
        parts.push_back({"base", box_along(axis, at, {-end, -side, -base}, {end, side, 0})});
    if (parallels) {
        const auto& [thick, high] = *parallels;
        if (2 * thick > opening)
            r.fail(*t["parallels"], "the parallels are wider than the opening");
        if (high >= height)
            r.fail(*t["parallels"], "the parallels are as high as the jaws: nothing is clamped");
        parts.push_back(
            {"parallel", box_along(axis, at, {-half, -side, 0}, {thick - half, side, high})});
        parts.push_back(
            {"parallel", box_along(axis, at, {half - thick, -side, 0}, {half, side, high})});
    }
    return parts;
}

std::vector<NamedBox> read_clamp(const TomlReader& r, const TomlTable& t) {
    Vec3 at;
    std::string toward = "+X";
    double length = 0.0, width = 0.0, height = 0.0, heel = 0.0;
    std::optional<double> table;
    std::optional<Vec3> bolt;
    read_required(r, t, "at", at, "toward", toward, "length", length, "width", width, "height",
                  height);
    t.read("heel", heel);
    t.read("table", table);
    t.read("bolt", bolt);
    const int axis = toward[1] - 'X';
    const double sign = toward[0] == '-' ? -1.0 : 1.0;
    if (table && *table >= at.z)
        r.fail(*t["table"], "the table is at the height of the clamp or above");
    if ((heel > 0.0) != table.has_value()) r.fail(t.node(), "heel and table belong together");
    if (heel > length) r.fail(*t["heel"], "the heel is longer than the clamp");
    const double side = width / 2;
    const double floor = table ? *table - at.z : 0.0;
    std::vector<NamedBox> parts{
        {"arm", box_along(axis, at, {0, -side, 0}, {sign * length, side, height})}};
    if (heel > 0.0) {
        parts.push_back({"heel", box_along(axis, at, {sign * (length - heel), -side, floor},
                                           {sign * length, side, 0})});
    }
    if (bolt) {
        const double nut = bolt->y / 2;
        if (bolt->x + nut > length) r.fail(*t["bolt"], "the bolt is outside the clamp");
        parts.push_back({"bolt", box_along(axis, at, {sign * bolt->x - nut, -nut, floor},
                                           {sign * bolt->x + nut, nut, height + bolt->z})});
    }
    return parts;
}

}  // namespace

void read_fixture(const TomlReader& r, const std::string& folder, InputSet& inputs,
                  const TomlTable& t, std::vector<verify::Fixture>& fixtures) {
    verify::Fixture fixture;
    std::vector<NamedBox> parts;
    std::string kind = "fixture";
    if (const toml::node* const box = t["box"]) {
        const auto corners = TomlReader::value<std::array<Vec3, 2>>(*box);
        for (const Vec3& corner : corners)
            fixture.box.add(corner);
        const Vec3 size = fixture.box.size();
        if (size.x <= 0.0 || size.y <= 0.0 || size.z <= 0.0)
            r.fail(*box, fmt::format("'{}': the box has no volume", t.name_of("box")));
    }
    for (const char* const shape : {"clamp", "vise"}) {
        if (!t[shape]) continue;
        kind = shape;
        parts = kind == "vise" ? read_vise(r, t.table(shape)) : read_clamp(r, t.table(shape));
    }
    t.read("clearance", fixture.clearance_mm);
    t.read("name", fixture.name);
    if (const toml::node* const offset = t["offset"]) {
        const auto system = system_named(TomlReader::text(*offset));
        if (!system) {
            r.fail(*offset,
                   fmt::format("'{}': expected a system such as \"G55\"", t.name_of("offset")));
        }
        fixture.system = *system;
    }
    if (auto mesh = read_mesh(r, folder, inputs, t)) {
        fixture.mesh = std::move(mesh->file.mesh);
        fixture.deflection_mm = mesh->file.deflection_mm;
        fixture.assumed = std::move(mesh->file.assumed);
        fixture.mesh_at = std::move(mesh->place);
        fixture.as_hull = mesh->as_hull;
        for (const Vec3& v : fixture.mesh.vertices)
            fixture.box.add(v);
    }
    const auto shapes = std::ranges::count_if(std::array{"box", "clamp", "mesh", "stl", "vise"},
                                              [&t](const char* key) { return t[key] != nullptr; });
    if (shapes == 0) r.fail(t.node(), "a fixture needs a box or a mesh, a vise or a clamp");
    if (shapes > 1) {
        r.fail(t.node(), parts.empty()
                             ? "a fixture has a box or a mesh, not both"
                             : "a fixture has one shape: a box, a mesh, a vise or a clamp");
    }
    if (fixture.name.empty()) fixture.name = kind;
    if (parts.empty()) {
        fixtures.push_back(std::move(fixture));
        return;
    }
    for (NamedBox& part : parts) {
        verify::Fixture body = fixture;
        body.name = fmt::format("{}: {}", fixture.name, part.name);
        body.box = part.box;
        fixtures.push_back(std::move(body));
    }
}

}  // namespace ncsim::setup
