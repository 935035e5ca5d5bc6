// SPDX-License-Identifier: GPL-3.0-or-later
#include "heal/non_simple_faces.h"

#include "ncsim/brep/frames.h"
#include "ncsim/brep/measure.h"

#include "geometry/no_index.h"
#include "geometry/tolerances.h"
#include "query/part_check.h"
#include "topology/angular_extent.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

namespace ncsim::brep {

namespace {

// Implementation of join_touching_corners().
class TouchingCorners {
public:
    TouchingCorners(Part& part, double near_mm)
        : part_(part),
          near_(near_mm),
          widths_(reader_widths(part)),
          is_flat_edge_(part.edges.size(), true),
          is_flat_(flat_vertices(part)) {
        for (const Face& face : part.faces) {
            for (const EdgeUse& use : uses_of(face)) {
                if (!is_plane(face) || !is_straight(part.edges[use.edge]))
                    is_flat_edge_[use.edge] = false;
            }
        }
    }

    bool join(const Numbers& faces) {
        for (const std::uint32_t f : faces) {
            if (is_plane(part_.faces[f])) find_touches(part_.faces[f]);
        }
        for (auto& [edge, on] : points_on_edge_)
            merge_into(on, current(part_.edges[edge].from), current(part_.edges[edge].to));
        std::erase_if(points_on_edge_, [](const auto& edge) { return edge.second.empty(); });
        for (Edge& edge : part_.edges) {
            edge.from = current(edge.from);
            edge.to = current(edge.to);
        }
        if (!merged_into_.empty()) drop_points();
        divide();
        return !merged_into_.empty() || !points_on_edge_.empty();
    }

private:
    // Joins near corners of a face, and corners with near edges. Corners are sorted along the
    // longest axis of the face; only pairs that are near along this axis are tested.
    void find_touches(const Face& face) {
        Numbers corners = corners_of(part_, face);
        Vec3 low = part_.vertices[corners.front()], high = low;
        for (const std::uint32_t v : corners) {
            const Vec3 p = part_.vertices[v];
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
        const Vec3 size = high - low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto place = [&](std::uint32_t v) { return part_.vertices[v][axis]; };
        std::sort(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(place(a), a) < std::pair(place(b), b);
        });
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            for (std::size_t j = i + 1; j < corners.size(); ++j) {
                if (place(corners[j]) > place(corners[i]) + near_) break;
                join_corners(face, corners[i], corners[j]);
            }
        }
        for (const EdgeUse& use : uses_of(face)) {
            if (!is_flat_edge_[use.edge]) continue;
            const Edge& edge = part_.edges[use.edge];
            const auto [from, to] = std::minmax({place(edge.from), place(edge.to)});
            const double most = std::max(near_, kFlat);
            const auto first = std::ranges::lower_bound(corners, from - most, {}, place);
            for (auto v = first; v != corners.end() && place(*v) <= to + most; ++v)
                join_to_edge(*v, use.edge);
        }
    }

    // Merges two near corners unless no corner is flat, or both are the ends of an edge of the
    // face: the merged edge would have no length.
    void join_corners(const Face& face, std::uint32_t a, std::uint32_t b) {
        if (norm(part_.vertices[b] - part_.vertices[a]) > near_) return;
        a = current(a);
        b = current(b);
        if (a == b) return;
        if (!is_flat_[b]) std::swap(a, b);
        const bool is_edge = std::ranges::any_of(uses_of(face), [&](const EdgeUse& use) {
            const std::uint32_t from = current(part_.edges[use.edge].from);
            const std::uint32_t to = current(part_.edges[use.edge].to);
            return (from == a && to == b) || (from == b && to == a);
        });
        if (is_flat_[b] && !is_edge) merged_into_[b] = a;
    }

    void join_to_edge(std::uint32_t v, std::uint32_t number) {
        const Edge& edge = part_.edges[number];
        const Vec3 p = part_.vertices[v], from = part_.vertices[edge.from];
        const Vec3 to = part_.vertices[edge.to], along = to - from;
        if (v == edge.from || v == edge.to || norm(p - from) <= near_ || norm(p - to) <= near_)
            return;
        const double t = dot(p - from, along) / dot(along, along);
        const double wide = std::min(kFlat, widths_.corners[v] + widths_.edges[number]);
        if (t <= 0.0 || t >= 1.0 || norm(p - from - t * along) > std::max(near_, wide)) return;
        auto& on = points_on_edge_[number];
        if (std::ranges::find(on, current(v), [&](const auto& at) { return current(at.second); }) ==
            on.end())
            on.emplace_back(t, v);
    }

    // Returns the corner into which `v` has been merged; `v` if there was no merge.
    std::uint32_t current(std::uint32_t v) const {
        for (auto at = merged_into_.find(v); at != merged_into_.end(); at = merged_into_.find(v))
            v = at->second;
        return v;
    }

    // Sorts the corners on an edge from `from` to `to` along the edge, replaces each by the corner
    // into which it has been merged, and erases duplicates and the ends of the edge.
    void merge_into(std::vector<std::pair<double, std::uint32_t>>& on, std::uint32_t from,
                    std::uint32_t to) const {
        std::sort(on.begin(), on.end());
        for (auto& at : on)
            at.second = current(at.second);
        std::erase_if(
            on, [&](const auto& at) { return from == to || at.second == from || at.second == to; });
        const auto is_same = [](const auto& a, const auto& b) { return a.second == b.second; };
        on.erase(std::unique(on.begin(), on.end(), is_same), on.end());
    }

    // Erases straight edges of all faces whose ends have been merged.
    void drop_points() {
        for (Face& face : part_.faces) {
            for (Loop& loop : face.loops) {
                std::erase_if(loop, [&](const EdgeUse& use) {
                    const Edge& edge = part_.edges[use.edge];
                    return edge.from == edge.to && std::holds_alternative<Line>(edge.curve);
                });
            }
            if (face.loops.size() > 1)
                std::erase_if(face.loops, [](const Loop& loop) { return loop.empty(); });
        }
    }

    // Divides edges at the corners on them, in all loops.
    void divide() {
        std::map<std::uint32_t, Numbers> pieces;
        for (const auto& [number, on] : points_on_edge_) {
            const std::uint32_t end = part_.edges[number].to;
            Numbers& made = pieces[number] = {number};
            for (const auto& [t, v] : on) {
                part_.edges[made.back()].to = v;
                made.push_back(static_cast<std::uint32_t>(part_.edges.size()));
                part_.edges.push_back({v, end, Line{}});
            }
        }
        if (pieces.empty()) return;
        for (Face& face : part_.faces) {
            for (Loop& loop : face.loops) {
                Loop divided;
                for (const EdgeUse& use : loop) {
                    const auto found = pieces.find(use.edge);
                    if (found == pieces.end()) {
                        divided.push_back(use);
                        continue;
                    }
                    Numbers order = found->second;
                    if (!use.is_forward) std::ranges::reverse(order);
                    for (const std::uint32_t e : order)
                        divided.push_back({e, use.is_forward});
                }
                loop = std::move(divided);
            }
        }
    }

    Part& part_;
    double near_;
    ReaderWidths widths_;
    // True for edges and vertices at which only planes and lines meet.
    std::vector<bool> is_flat_edge_, is_flat_;
    std::map<std::uint32_t, std::uint32_t> merged_into_;
    // Corners on each edge, with the share of the edge's length up to the corner.
    std::map<std::uint32_t, std::vector<std::pair<double, std::uint32_t>>> points_on_edge_;
};

bool revisits_vertex(const Part& part, const Loop& loop) {
    Numbers corners;
    for (const EdgeUse& use : loop)
        corners.push_back(begin_of(part, use));
    std::sort(corners.begin(), corners.end());
    return std::ranges::adjacent_find(corners) != corners.end();
}

// Divides a loop into loops that visit each corner once.
std::vector<Loop> simple_loops(const Part& part, const Loop& loop) {
    std::vector<Loop> simple;
    Loop path;
    for (const EdgeUse& use : loop) {
        path.push_back(use);
        const auto back = std::ranges::find(
            path, end_of(part, use), [&](const EdgeUse& before) { return begin_of(part, before); });
        if (back == path.end()) continue;
        simple.emplace_back(back, path.end());
        path.erase(back, path.end());
    }
    return simple;
}

Face copy_with_loops(const Face& face, std::vector<Loop> loops) {
    return {face.surface, face.frame, std::move(loops), face.origin, face.origins, face.is_facet};
}

// Returns the face with a single loop, for measurements: like copy_with_loops(), without the list
// of motions that cut the face.
Face copy_with_loop(const Face& face, const Loop& loop) {
    return {face.surface, face.frame, {loop}, face.origin, {}, face.is_facet};
}

// Returns the loops of each face into which `face` is split, the outline first. Empty if a hole
// lies in no outline.
std::vector<std::vector<Loop>> parts_of(const Part& part, const Face& face) {
    std::vector<std::vector<Loop>> parts;
    std::vector<Loop> holes;
    for (const Loop& loop : face.loops) {
        for (Loop& simple : simple_loops(part, loop)) {
            const double area = measure(part, copy_with_loop(face, simple), face.frame.origin).area;
            if (area > 0.0) {
                parts.push_back({std::move(simple)});
            } else {
                holes.push_back(std::move(simple));
            }
        }
    }
    for (Loop& hole : holes) {
        const auto enclosing = std::ranges::find_if(parts, [&](const auto& loops) {
            return parts.size() == 1 || encloses(part, face, loops.front(), hole);
        });
        if (enclosing == parts.end()) return {};
        enclosing->push_back(std::move(hole));
    }
    return parts;
}

// True if the first of several loops is not an outline, or a later loop is an outline.
bool has_other_outline(const Part& part, const Face& face) {
    if (face.loops.size() < 2) return false;
    for (std::size_t l = 0; l < face.loops.size(); ++l) {
        const double area =
            measure(part, copy_with_loop(face, face.loops[l]), face.frame.origin).area;
        if ((area > 0.0) != (l == 0)) return true;
    }
    return false;
}

// True if the only loop of a planar face turns left in each corner, by an angle that CAD readers
// distinguish from 0, and by a single turn in total.
bool is_convex(const Part& part, const Face& face) {
    if (face.loops.size() != 1 || face.loops.front().size() < 3) return false;
    const Vec3 normal = std::get<Plane>(face.surface.form).normal;
    const Loop& loop = face.loops.front();
    const auto point = [&](std::size_t i) {
        return part.vertices[begin_of(part, loop[i % loop.size()])];
    };
    const Vec3 first = point(1) - point(0);
    int changes = 0;  // changes of the side of the first edge to which edges point
    double before = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 in = point(i + 1) - point(i), out = point(i + 2) - point(i + 1);
        if (dot(normal, cross(in, out)) <= 0.1 * kParallelAngle * norm(in) * norm(out))
            return false;
        const double side = dot(normal, cross(first, out));
        if (before * side < 0.0) ++changes;
        if (side != 0.0) before = side;
    }
    return changes <= 1;
}

}  // namespace

bool encloses(const Part& part, const Face& face, const Loop& outline, const Loop& loop) {
    const Edge& edge = part.edges[loop.front().edge];
    const Vec3 p = track_of(part, edge).at(0.5);
    const Vec3 x = face.frame.x, y = cross(face.frame.axis, x);
    const auto points = points_along(part, copy_with_loop(face, outline)).front();
    bool is_inside = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 a = points[i] - p, b = points[(i + 1) % points.size()] - p;
        const double ax = dot(a, x), ay = dot(a, y), bx = dot(b, x), by = dot(b, y);
        if ((ay > 0.0) != (by > 0.0) && (ax * by - bx * ay > 0.0) == (by > ay))
            is_inside = !is_inside;
    }
    return is_inside;
}

std::vector<std::uint32_t> crossed_planes(const Part& part) {
    Numbers crossed;
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        const Face& face = part.faces[f];
        double miss = 0.0;
        if (is_plane(face) && is_straight(part, face) && !is_convex(part, face) &&
            !faults_of(part, f, 1.0, miss, 2.0 * kReaderMm).empty())
            crossed.push_back(f);
    }
    return crossed;
}

bool join_touching_corners(Part& part, const std::vector<std::uint32_t>& faces, double near_mm) {
    return TouchingCorners(part, near_mm).join(faces);
}

std::vector<std::uint32_t> split_non_simple_faces(Part& part) {
    std::vector<std::uint32_t> whole;
    const auto count = static_cast<std::uint32_t>(part.faces.size());
    const auto is_pinched = [&](const Loop& loop) { return revisits_vertex(part, loop); };
    for (std::uint32_t f = 0; f < count; ++f) {
        if (!is_plane(part.faces[f]) || (std::ranges::none_of(part.faces[f].loops, is_pinched) &&
                                         !has_other_outline(part, part.faces[f])))
            continue;
        std::vector<std::vector<Loop>> parts = parts_of(part, part.faces[f]);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            Face made = copy_with_loops(part.faces[f], std::move(parts[i]));
            made.frame = frame_for(part, made);
            if (i == 0) {
                part.faces[f] = std::move(made);
                continue;
            }
            append_face(part, f, std::move(made));
            whole.push_back(f);
        }
    }
    return whole;
}

}  // namespace ncsim::brep
