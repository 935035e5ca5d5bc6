// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boundaries and facets with masks of parts made of boxes.
#include "support/box_part.h"

#include <algorithm>
#include <map>
#include <utility>

namespace ncsim::test {

namespace {

// Side of a box, perpendicular to `axis` at `at`; `outwards` is +1 or -1.
struct Side {
    std::size_t axis;
    int outwards;
    int at;
};

Side side_of(const GridBox& box, std::size_t axis, int outwards) {
    return {axis, outwards, outwards > 0 ? box.max[axis] : box.min[axis]};
}

// Returns the corners of `box` on `side`, counter-clockwise seen from the tip of the side's normal.
std::vector<Vec3> rectangle(const BoxPart& part, const GridBox& box, const Side& side,
                            bool reversed) {
    const std::size_t u = (side.axis + 1) % 3;
    const std::size_t v = (side.axis + 2) % 3;
    std::vector<Vec3> corners;
    for (const auto& [pu, pv] : {std::pair(box.min[u], box.min[v]),
                                 {box.max[u], box.min[v]},
                                 {box.max[u], box.max[v]},
                                 {box.min[u], box.max[v]}}) {
        std::array<double, 3> p{};
        p[side.axis] = side.at;
        p[u] = pu;
        p[v] = pv;
        corners.push_back(part.to_W({p[0], p[1], p[2]}));
    }
    const bool is_counterclockwise = (side.outwards > 0) != reversed;
    if (!is_counterclockwise) std::reverse(corners.begin(), corners.end());
    return corners;
}

// Clips `box` to `other`, except along `axis`. Returns false if the result is empty.
bool clip_to(GridBox& box, const GridBox& other, std::size_t axis) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (i == axis) continue;
        box.min[i] = std::max(box.min[i], other.min[i]);
        box.max[i] = std::min(box.max[i], other.max[i]);
        if (box.min[i] >= box.max[i]) return false;
    }
    return true;
}

// True if box j removes the area that it covers on this side of box i, by the facet rule. The stock
// has i < 0.
bool masks_side(const Side& side, int i, const GridBox& j_box, int j) {
    if (j_box.min[side.axis] < side.at && side.at < j_box.max[side.axis]) return true;
    const bool same = side_of(j_box, side.axis, side.outwards).at == side.at;
    const bool opposite = side_of(j_box, side.axis, -side.outwards).at == side.at;
    if (i < 0) return same;
    return (same && j < i) || opposite;
}

Vec3 normal_of(const BoxPart& part, const Side& side, bool reversed) {
    const double sign = (side.outwards > 0) != reversed ? 1.0 : -1.0;
    return sign * part.axes[side.axis];
}

void draw_box(cda::FacetCanvas& canvas, const BoxPart& part, int i) {
    const bool is_stock = i < 0;
    const GridBox& box = is_stock ? part.stock : part.cuts[static_cast<std::size_t>(i)];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int outwards : {-1, 1}) {
            const Side side = side_of(box, axis, outwards);
            GridBox visible = box;
            if (!is_stock) {
                const bool inside =
                    part.stock.min[axis] < side.at && side.at < part.stock.max[axis];
                if (!inside || !clip_to(visible, part.stock, axis)) continue;
            }
            std::vector<std::vector<Vec3>> masks;
            for (int j = 0; j < static_cast<int>(part.cuts.size()); ++j) {
                const GridBox& other = part.cuts[static_cast<std::size_t>(j)];
                GridBox covered = visible;
                if (j != i && masks_side(side, i, other, j) && clip_to(covered, other, axis)) {
                    masks.push_back(rectangle(part, covered, side, !is_stock));
                }
            }
            const std::vector<Vec3> outline = rectangle(part, visible, side, !is_stock);
            canvas.draw({normal_of(part, side, !is_stock),
                         cda::Origin{static_cast<std::uint32_t>(i + 1)}, outline, masks});
        }
    }
}

constexpr int kOutside = -2;
constexpr int kMaterial = -1;

// Numbers the shells. Faces that share a vertex belong to the same shell, because parts that only
// touch do not occur here.
void number_shells(cda::Boundary& boundary) {
    constexpr std::uint32_t kNone = 0xFFFFFFFF;
    std::vector<std::vector<std::size_t>> faces_at(boundary.vertices.size());
    for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
        boundary.faces[f].shell = kNone;
        for (const std::uint32_t v : boundary.faces[f].loops[0])
            faces_at[v].push_back(f);
    }
    boundary.shells = 0;
    for (std::size_t start = 0; start < boundary.faces.size(); ++start) {
        if (boundary.faces[start].shell != kNone) continue;
        std::vector<std::size_t> open{start};
        boundary.faces[start].shell = boundary.shells;
        while (!open.empty()) {
            const std::size_t f = open.back();
            open.pop_back();
            for (const std::uint32_t v : boundary.faces[f].loops[0]) {
                for (const std::size_t other : faces_at[v]) {
                    if (boundary.faces[other].shell != kNone) continue;
                    boundary.faces[other].shell = boundary.shells;
                    open.push_back(other);
                }
            }
        }
        ++boundary.shells;
    }
}

// Returns the state of a cell: the number of the cut that removed its material, `kMaterial`, or
// `kOutside` of the stock.
int state_of(const BoxPart& part, std::array<int, 3> cell) {
    if (!part.stock.contains_cell(cell)) return kOutside;
    for (std::size_t i = 0; i < part.cuts.size(); ++i) {
        if (part.cuts[i].contains_cell(cell)) return static_cast<int>(i);
    }
    return kMaterial;
}

}  // namespace

bool GridBox::contains_cell(std::array<int, 3> cell) const {
    for (std::size_t i = 0; i < 3; ++i) {
        if (cell[i] < min[i] || cell[i] >= max[i]) return false;
    }
    return true;
}

Vec3 BoxPart::to_W(Vec3 p_G) const {
    return shift + cell_mm * (p_G.x * axes[0] + p_G.y * axes[1] + p_G.z * axes[2]);
}

BoxPart BoxPart::tilted() const {
    const auto turn = [](Vec3 v) {
        const Vec3 about_z{0.8 * v.x - 0.6 * v.y, 0.6 * v.x + 0.8 * v.y, v.z};
        const double c = 12.0 / 13.0;
        const double s = 5.0 / 13.0;
        return Vec3{about_z.x, c * about_z.y - s * about_z.z, s * about_z.y + c * about_z.z};
    };
    BoxPart result = *this;
    for (Vec3& axis : result.axes)
        axis = turn(axis);
    return result;
}

cda::Boundary boundary_of(const BoxPart& part) {
    cda::Boundary boundary;
    std::map<std::array<int, 3>, std::uint32_t> vertices;
    const auto vertex = [&](std::array<int, 3> p) {
        const auto next = static_cast<std::uint32_t>(boundary.vertices.size());
        const auto [found, is_new] = vertices.try_emplace(p, next);
        if (is_new) {
            boundary.vertices.push_back(part.to_W(
                {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])}));
        }
        return found->second;
    };
    const auto add_face = [&](std::array<int, 3> cell, std::size_t axis, int outwards) {
        std::array<int, 3> neighbour = cell;
        neighbour[axis] += outwards;
        const int beyond = state_of(part, neighbour);
        if (beyond == kMaterial) return;
        const GridBox box{cell, {cell[0] + 1, cell[1] + 1, cell[2] + 1}};
        const Side side = side_of(box, axis, outwards);
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        std::vector<std::uint32_t> loop;
        for (const auto& [pu, pv] : {std::pair(box.min[u], box.min[v]),
                                     {box.max[u], box.min[v]},
                                     {box.max[u], box.max[v]},
                                     {box.min[u], box.max[v]}}) {
            std::array<int, 3> p{};
            p[axis] = side.at;
            p[u] = pu;
            p[v] = pv;
            loop.push_back(vertex(p));
        }
        if (outwards < 0) std::reverse(loop.begin(), loop.end());
        cda::BoundaryFace face;
        face.normal = normal_of(part, side, false);
        face.offset = dot(face.normal, boundary.vertices[loop[0]]);
        face.origin = beyond == kOutside ? cda::kStockOrigin
                                         : cda::Origin{static_cast<std::uint32_t>(beyond + 1)};
        face.loops.push_back(std::move(loop));
        boundary.faces.push_back(std::move(face));
    };
    const auto& [min, max] = part.stock;
    for (int x = min[0]; x < max[0]; ++x) {
        for (int y = min[1]; y < max[1]; ++y) {
            for (int z = min[2]; z < max[2]; ++z) {
                if (state_of(part, {x, y, z}) != kMaterial) continue;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    add_face({x, y, z}, axis, -1);
                    add_face({x, y, z}, axis, 1);
                }
            }
        }
    }
    number_shells(boundary);
    return boundary;
}

void BoxModel::render(cda::FacetCanvas& canvas) const {
    for (int i = -1; i < static_cast<int>(part_.cuts.size()); ++i)
        draw_box(canvas, part_, i);
}

BoxPart grooved_part() {
    BoxPart part;
    part.stock = {{0, 0, 0}, {30, 20, 10}};
    part.cell_mm = 2.0;
    part.cuts = {{{-1, 6, 6}, {31, 8, 12}},   {{-1, 8, 6}, {31, 10, 12}},
                 {{-1, 10, 6}, {31, 11, 12}}, {{18, -1, 7}, {22, 21, 12}},
                 {{3, 13, 8}, {12, 17, 12}},  {{3, 13, 5}, {12, 15, 8}}};
    return part;
}

BoxPart raster_part() {
    BoxPart part;
    part.stock = {{0, 0, 0}, {24, 24, 8}};
    part.cell_mm = 2.5;
    for (int row = 0; row < 6; ++row) {
        part.cuts.push_back({{-1, 4 * row, 7 - row % 3}, {25, 4 * row + 4, 9}});
    }
    for (int column = 0; column < 8; ++column) {
        part.cuts.push_back({{3 * column, -1, 6 - column % 4}, {3 * column + 3, 25, 9}});
    }
    return part;
}

BoxPart hollow_part() {
    BoxPart part;
    part.stock = {{0, 0, 0}, {6, 5, 4}};
    part.cuts = {{{2, 2, 1}, {4, 3, 3}}};
    return part;
}

BoxPart halved_part() {
    BoxPart part;
    part.stock = {{0, 0, 0}, {7, 5, 4}};
    part.cuts = {{{3, -1, -1}, {4, 6, 5}}};
    return part;
}

BoxPart vanished_part() {
    BoxPart part;
    part.stock = {{0, 0, 0}, {4, 4, 4}};
    part.cuts = {{{-1, -1, -1}, {5, 5, 2}}, {{-1, -1, 2}, {5, 5, 5}}};
    return part;
}

mesh::Provenance provenance_of(const BoxPart& part) {
    mesh::Provenance provenance;
    provenance.program = "boxes.nc";
    provenance.entries.push_back({});
    for (std::uint32_t i = 0; i < part.cuts.size(); ++i) {
        provenance.entries.push_back({10 * (i + 1), i % 2 == 0 ? 1U : 7U});
    }
    return provenance;
}

cda::Boundary plate_with_hole() {
    cda::Boundary plate;
    const auto ring = [&](double half, double z) {
        for (const auto& [x, y] :
             {std::pair(-half, -half), {half, -half}, {half, half}, {-half, half}}) {
            plate.vertices.push_back({x, y, z});
        }
    };
    ring(20, 0);  //  0 …  3: outside, below
    ring(20, 5);  //  4 …  7: outside, above
    ring(8, 0);   //  8 … 11: hole, below
    ring(8, 5);   // 12 … 15: hole, above
    const cda::Origin cut{1};
    plate.faces = {{{0, 0, 1}, 5, cda::kStockOrigin, 0, {{4, 5, 6, 7}, {15, 14, 13, 12}}},
                   {{0, 0, -1}, 0, cda::kStockOrigin, 0, {{3, 2, 1, 0}, {8, 9, 10, 11}}}};
    const std::array<Vec3, 4> sides{{{0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}};
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t j = (i + 1) % 4;
        plate.faces.push_back({sides[i], 20, cda::kStockOrigin, 0, {{i, j, 4 + j, 4 + i}}});
        plate.faces.push_back({-sides[i], -8, cut, 0, {{8 + j, 8 + i, 12 + i, 12 + j}}});
    }
    plate.shells = 1;
    return plate;
}

}  // namespace ncsim::test
