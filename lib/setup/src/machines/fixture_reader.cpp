// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads fixtures.
#include "machines/fixture_reader.h"

#include "ncsim/setup/coordinate_systems.h"

#include "meshes/mesh_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
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

const toml::node& required(const TomlReader& r, const toml::table& t, const std::string& where,
                           const char* key) {
    const toml::node* const node = t.get(key);
    if (!node) r.fail(t, fmt::format("'{}' needs {}", where, key));
    return *node;
}

std::vector<NamedBox> read_vise(const TomlReader& r, const toml::node& node,
                                const std::string& key) {
    const toml::table& t = TomlReader::table(node);
    Vec3 at;
    std::string along = "Y";
    double opening = 0.0, width = 0.0, height = 0.0, depth = 0.0, base = 0.0;
    std::optional<std::pair<double, double>> parallels;
    TomlReader::each(t, key,
                     {{"at", into(at)},
                      {"along", into(along)},
                      {"opening", into(opening)},
                      {"jaw_width", into(width)},
                      {"jaw_height", into(height)},
                      {"jaw_depth", into(depth)},
                      {"base_height", into(base)},
                      {"parallels", [&](const toml::node& n, const std::string&) {
                           const toml::array& two = TomlReader::list(n);
                           parallels.emplace(TomlReader::number(two[0]),
                                             TomlReader::number(two[1]));
                       }}});
    const int axis = along[0] - 'X';
    for (const char* name : {"at", "opening", "jaw_width", "jaw_height", "jaw_depth"})
        (void)required(r, t, key, name);
    const double half = opening / 2, end = half + depth, side = width / 2;
    std::vector<NamedBox> parts{
        {"fixed jaw", box_along(axis, at, {-end, -side, 0}, {-half, side, height})},
        {"moving jaw", box_along(axis, at, {half, -side, 0}, {end, side, height})}};
    if (base > 0.0)
        parts.push_back({"base", box_along(axis, at, {-end, -side, -base}, {end, side, 0})});
    if (parallels) {
        const auto& [thick, high] = *parallels;
        if (2 * thick > opening)
            r.fail(*t.get("parallels"), "the parallels are wider than the opening");
        if (high >= height)
            r.fail(*t.get("parallels"),
                   "the parallels are as high as the jaws: nothing is clamped");
        parts.push_back(
            {"parallel", box_along(axis, at, {-half, -side, 0}, {thick - half, side, high})});
        parts.push_back(
            {"parallel", box_along(axis, at, {half - thick, -side, 0}, {half, side, high})});
    }
    return parts;
}

std::vector<NamedBox> read_clamp(const TomlReader& r, const toml::node& node,
                                 const std::string& key) {
    const toml::table& t = TomlReader::table(node);
    Vec3 at;
    std::string toward = "+X";
    double length = 0.0, width = 0.0, height = 0.0, heel = 0.0;
    std::optional<double> table;
    std::optional<Vec3> bolt;
    TomlReader::each(t, key,
                     {{"at", into(at)},
                      {"toward", into(toward)},
                      {"length", into(length)},
                      {"width", into(width)},
                      {"height", into(height)},
                      {"heel", into(heel)},
                      {"table", into(table)},
                      {"bolt", into(bolt)}});
    const int axis = toward[1] - 'X';
    const double sign = toward[0] == '-' ? -1.0 : 1.0;
    for (const char* name : {"at", "toward", "length", "width", "height"})
        (void)required(r, t, key, name);
    if (table && *table >= at.z)
        r.fail(*t.get("table"), "the table is at the height of the clamp or above");
    if ((heel > 0.0) != table.has_value()) r.fail(t, "heel and table belong together");
    if (heel > length) r.fail(*t.get("heel"), "the heel is longer than the clamp");
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
        if (bolt->x + nut > length) r.fail(*t.get("bolt"), "the bolt is outside the clamp");
        parts.push_back({"bolt", box_along(axis, at, {sign * bolt->x - nut, -nut, floor},
                                           {sign * bolt->x + nut, nut, height + bolt->z})});
    }
    return parts;
}

}  // namespace

void read_fixture(const TomlReader& r, const std::string& folder, InputSet& inputs,
                  const toml::node& node, const std::string& key,
                  std::vector<verify::Fixture>& fixtures) {
    verify::Fixture fixture;
    MeshKeys mesh(r, folder, inputs);
    std::vector<NamedBox> parts;
    std::string kind = "fixture";
    int shapes = 0;
    const auto take_mesh = [&](const auto& n, const auto& k) {
        mesh.take_mesh(n, k);
        ++shapes;
    };
    const auto take_parts = [&](const char* of, auto read_parts) {
        return [&, of, read_parts](const toml::node& n, const std::string& k) {
            parts = read_parts(r, n, k);
            kind = of;
            ++shapes;
        };
    };
    TomlReader::each(TomlReader::table(node), key,
                     {{"name", into(fixture.name)},
                      {"mesh", take_mesh},
                      {"stl", take_mesh},  // alternative name
                      {"scale", [&](const auto& n, const auto&) { mesh.take_scale(n); }},
                      {"hull", [&](const auto& n, const auto&) { mesh.take_hull(n); }},
                      {"clearance", into(fixture.clearance_mm)},
                      {"offset",
                       [&](const auto& n, const auto& k) {
                           const auto system = system_named(TomlReader::text(n));
                           if (!system)
                               r.fail(n, fmt::format("'{}': expected a system such as \"G55\"", k));
                           fixture.system = *system;
                       }},
                      {"vise", take_parts("vise", read_vise)},
                      {"clamp", take_parts("clamp", read_clamp)},
                      {"box", [&](const toml::node& n, const std::string& k) {
                           ++shapes;
                           const toml::array& corners = TomlReader::list(n);
                           fixture.box.add(TomlReader::vector(corners[0]));
                           fixture.box.add(TomlReader::vector(corners[1]));
                           const Vec3 size = fixture.box.size();
                           if (size.x <= 0.0 || size.y <= 0.0 || size.z <= 0.0) {
                               r.fail(n, fmt::format("'{}': the box has no volume", k));
                           }
                       }}});
    if (auto file = mesh.finish()) {
        fixture.mesh = std::move(file->mesh);
        fixture.deflection_mm = file->deflection_mm;
        fixture.assumed = std::move(file->assumed);
        fixture.mesh_at = mesh.place();
        fixture.as_hull = mesh.as_hull();
        for (const Vec3& v : fixture.mesh.vertices)
            fixture.box.add(v);
    }
    if (shapes == 0) r.fail(node, "a fixture needs a box or a mesh, a vise or a clamp");
    if (shapes > 1) {
        r.fail(node, parts.empty() ? "a fixture has a box or a mesh, not both"
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
