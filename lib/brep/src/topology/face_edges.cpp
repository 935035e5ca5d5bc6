// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/face_edges.h"

#include "geometry/no_index.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace ncsim::brep {

std::vector<EdgeUse> uses_of(const std::vector<Loop>& loops) {
    std::vector<EdgeUse> uses;
    for (const Loop& loop : loops)
        uses.insert(uses.end(), loop.begin(), loop.end());
    return uses;
}

Numbers corners_of(const Part& part, const Face& face) {
    Numbers corners;
    for (const EdgeUse& use : uses_of(face))
        corners.push_back(begin_of(part, use));
    return corners;
}

bool is_straight(const Part& part, const Face& face) {
    return std::ranges::all_of(
        uses_of(face), [&](const EdgeUse& use) { return is_straight(part.edges[use.edge]); });
}

std::vector<std::array<std::uint32_t, 2>> sides_of_edges(const Part& part) {
    std::vector<std::array<std::uint32_t, 2>> sides(part.edges.size(), {kNone, kNone});
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        for (const EdgeUse& use : uses_of(part.faces[f]))
            sides[use.edge][use.is_forward ? 0 : 1] = f;
    }
    return sides;
}

std::vector<Numbers> faces_at_vertices(const Part& part) {
    std::vector<Numbers> faces(part.vertices.size());
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        for (const std::uint32_t v : corners_of(part, part.faces[f])) {
            if (faces[v].empty() || faces[v].back() != f) faces[v].push_back(f);
        }
    }
    return faces;
}

std::vector<bool> flat_vertices(const Part& part) {
    std::vector<bool> is_flat(part.vertices.size(), true);
    for (const Face& face : part.faces) {
        for (const EdgeUse& use : uses_of(face)) {
            const Edge& edge = part.edges[use.edge];
            if (!is_plane(face) || !is_straight(edge))
                is_flat[edge.from] = is_flat[edge.to] = false;
        }
    }
    return is_flat;
}

ReaderWidths reader_widths(const Part& part) {
    ReaderWidths widths{std::vector<double>(part.edges.size(), 0.0),
                        std::vector<double>(part.vertices.size(), 0.0)};
    for (const Face& face : part.faces) {
        for (const EdgeUse& use : uses_of(face)) {
            const Edge& edge = part.edges[use.edge];
            if (!is_straight(edge)) continue;
            const Vec3 from = part.vertices[edge.from], to = part.vertices[edge.to];
            double& width = widths.edges[use.edge];
            for (const Vec3 p : {from, to, 0.5 * (from + to)})
                width = std::max(width, std::abs(distance(face.surface.form, p)));
            for (const std::uint32_t v : {edge.from, edge.to})
                widths.corners[v] = std::max(widths.corners[v], width);
        }
    }
    return widths;
}

std::vector<double> reader_lengths(const Part& part) {
    const ReaderWidths widths = reader_widths(part);
    std::vector<double> lengths(part.edges.size(), 0.0);
    for (const Face& face : part.faces) {
        for (const EdgeUse& use : uses_of(face)) {
            const Edge& edge = part.edges[use.edge];
            lengths[use.edge] =
                widths.corners[edge.from] + widths.corners[edge.to] + 2.0 * widths.edges[use.edge];
        }
    }
    return lengths;
}

void erase_uses(std::vector<Loop>& loops, UsePlace a, UsePlace b) {
    const auto [first, second] = std::minmax(a, b);
    const auto place = [](Loop& loop, std::size_t i) {
        return loop.begin() + static_cast<std::ptrdiff_t>(i);
    };
    Loop& one = loops[first.first];
    std::rotate(one.begin(), place(one, first.second), one.end());
    if (first.first == second.first) {
        const auto at = place(one, second.second - first.second);
        Loop rest(at + 1, one.end());
        one.erase(at, one.end());
        one.erase(one.begin());
        loops.push_back(std::move(rest));
        return;
    }
    Loop& other = loops[second.first];
    std::rotate(other.begin(), place(other, second.second), other.end());
    one.insert(one.end(), other.begin() + 1, other.end());
    one.erase(one.begin());
    other.clear();
}

std::uint32_t append_face(Part& part, std::uint32_t f, Face face) {
    const auto number = static_cast<std::uint32_t>(part.faces.size());
    part.faces.push_back(std::move(face));
    for (Solid& solid : part.solids) {
        for_shells(solid, [&](Shell& shell) {
            if (std::ranges::find(shell, f) != shell.end()) shell.push_back(number);
        });
    }
    return number;
}

}  // namespace ncsim::brep
