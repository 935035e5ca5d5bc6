// SPDX-License-Identifier: GPL-3.0-or-later
#include "heal/nonplanar_faces.h"

#include "ncsim/base/disjoint_sets.h"
#include "ncsim/base/triangle_mesh.h"
#include "ncsim/brep/frames.h"
#include "ncsim/cda/triangulate.h"

#include "geometry/no_index.h"
#include "geometry/tolerances.h"
#include "heal/non_simple_faces.h"
#include "sources/label.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>

namespace ncsim::brep {

namespace {

// Returns the vertices of each loop in order.
std::vector<std::vector<std::uint32_t>> corners_around(const Part& part, const Face& face) {
    std::vector<std::vector<std::uint32_t>> loops;
    for (const Loop& loop : face.loops) {
        auto& corners = loops.emplace_back();
        for (const EdgeUse& use : loop)
            corners.push_back(begin_of(part, use));
    }
    return loops;
}

// Returns the largest distance of a corner of the face from `plane`, mm.
double distance_from_plane(const Part& part, const Face& face, const Plane& plane) {
    double deviation = 0.0;
    for (const EdgeUse& use : uses_of(face)) {
        const Vec3 p = part.vertices[begin_of(part, use)];
        deviation = std::max(deviation, std::abs(dot(plane.normal, p - plane.origin)));
    }
    return deviation;
}

// Returns the plane through the mean of all corners, perpendicular to the vector area of the loops.
// No value if the vector area is 0.
std::optional<Plane> mean_plane(const Part& part, const Face& face) {
    Vec3 sum, area;
    double count = 0.0;
    const Vec3 apex = part.vertices[begin_of(part, face.loops.front().front())];
    for (const auto& corners : corners_around(part, face)) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3 a = part.vertices[corners[i]] - apex;
            area = area + cross(a, part.vertices[corners[(i + 1) % corners.size()]] - apex);
            sum = sum + a;
            count += 1.0;
        }
    }
    if (dot(area, area) == 0.0) return std::nullopt;
    return Plane{apex + (1.0 / count) * sum, normalized(area)};
}

void set_plane(const Part& part, Face& face, const Plane& plane) {
    face.surface.form = plane;
    face.frame = frame_for(part, face);
}

// Triangulation of a nonplanar facet, and planar pieces of these triangles.
class NonplanarFacet {
public:
    NonplanarFacet(Part& part, const Face& face)
        : part_(part), face_(face), plane_(std::get<Plane>(face.surface.form)) {}

    // Returns the faces that replace the facet; empty if the facet cannot be divided.
    std::vector<Face> pieces() {
        if (!gather_edges() || !cut() || !pair_triangles()) return {};
        merge_coplanar();
        std::vector<Face> made;
        std::vector<std::uint32_t> number(triangles_.size(), kNone);  // of the face of a piece
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            std::uint32_t& piece = number[pieces_->find(t)];
            if (piece == kNone) {
                piece = static_cast<std::uint32_t>(made.size());
                made.push_back(face_);
                made.back().loops.clear();
            }
            add_loops(t, made[piece].loops);
        }
        for (Face& face : made)
            finish(face);
        return made;
    }

private:
    using Triangle = std::array<std::uint32_t, 3>;         // corners
    using Ends = std::pair<std::uint32_t, std::uint32_t>;  // start and end of a directed side

    // Lists the edges of the facet by their ends. False if the facet is on both sides of an edge,
    // or has two edges between the same corners.
    bool gather_edges() {
        for (const EdgeUse& use : uses_of(face_)) {
            const std::uint32_t from = begin_of(part_, use);
            const std::uint32_t to = end_of(part_, use);
            if (uses_.contains({to, from}) || !uses_.insert({{from, to}, use}).second) return false;
        }
        return true;
    }

    // Triangulates the projection of the facet on its plane. False if the loops cross there.
    bool cut() {
        cda::Boundary only;
        std::vector<std::uint32_t> corners;  // of each vertex
        std::map<std::uint32_t, std::uint32_t> vertices;
        cda::BoundaryFace flat;
        flat.normal = plane_.normal;
        flat.offset = dot(plane_.normal, plane_.origin);
        for (const auto& loop : corners_around(part_, face_)) {
            auto& made = flat.loops.emplace_back();
            for (const std::uint32_t v : loop) {
                const auto [at, is_new] =
                    vertices.insert({v, static_cast<std::uint32_t>(corners.size())});
                if (is_new) corners.push_back(v);
                made.push_back(at->second);
            }
        }
        for (const std::uint32_t v : corners)
            only.vertices.push_back(part_.vertices[v]);
        only.faces.push_back(std::move(flat));
        only.shells = 1;
        const TriangleMesh mesh = cda::triangulate(only);
        if (mesh.vertices.size() != corners.size()) return false;
        for (const auto& [a, b, c] : mesh.triangles)
            triangles_.push_back({corners[a], corners[b], corners[c]});
        return std::ranges::all_of(triangles_, [&](const Triangle& t) {
            const Vec3 a = part_.vertices[t[0]];
            return dot(plane_.normal, cross(part_.vertices[t[1]] - a, part_.vertices[t[2]] - a)) >
                   0.0;
        });
    }

    // Finds the triangle at each directed side. False unless each side is either an edge of the
    // facet or common to two triangles.
    bool pair_triangles() {
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                if (!at_side_.insert({side_of(t, i), t}).second) return false;
            }
        }
        return std::ranges::all_of(at_side_, [&](const auto& side) {
            const auto& [ends, t] = side;
            return uses_.contains(ends) != at_side_.contains({ends.second, ends.first});
        });
    }

    Ends side_of(std::uint32_t t, std::size_t i) const {
        return {triangles_[t][i], triangles_[t][(i + 1) % 3]};
    }

    // Unites adjacent triangles whose corners all lie in the plane of the facet.
    void merge_coplanar() {
        pieces_.emplace(triangles_.size());
        const auto is_flat = [&](std::uint32_t t) {
            return std::ranges::all_of(triangles_[t], [&](std::uint32_t v) {
                return std::abs(dot(plane_.normal, part_.vertices[v] - plane_.origin)) <= kFlat;
            });
        };
        for (const auto& [ends, t] : at_side_) {
            const auto other = at_side_.find({ends.second, ends.first});
            if (other != at_side_.end() && is_flat(t) && is_flat(other->second))
                pieces_->unite(t, other->second);
        }
    }

    // Returns the triangle on the far side of `ends` if both triangles are in the same piece;
    // otherwise kNone.
    std::uint32_t triangle_across(const Ends& ends) {
        const auto other = at_side_.find({ends.second, ends.first});
        if (other == at_side_.end()) return kNone;
        const bool is_same =
            pieces_->find(other->second) == pieces_->find(at_side_.find(ends)->second);
        return is_same ? other->second : kNone;
    }

    // Appends the loops of the piece that run along a side of triangle `t`, except loops that an
    // earlier triangle has appended.
    void add_loops(std::uint32_t t, std::vector<Loop>& loops) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Ends first = side_of(t, i);
            if (is_used_.contains(first) || triangle_across(first) != kNone) continue;
            Loop& loop = loops.emplace_back();
            for (Ends ends = first; is_used_.insert(ends).second; ends = next(ends))
                loop.push_back(use_of(ends));
        }
    }

    // Returns the side that follows `ends` on the border of the piece: turns about the end of
    // `ends` through all triangles of the piece at this corner.
    Ends next(Ends ends) {
        for (;;) {
            const Triangle& t = triangles_[at_side_.find(ends)->second];
            const auto* const tip = std::ranges::find_if(
                t, [&](std::uint32_t v) { return v != ends.first && v != ends.second; });
            const Ends after{ends.second, *tip};
            if (triangle_across(after) == kNone) return after;
            ends = {*tip, ends.second};
        }
    }

    // Returns the use of the edge along `ends`. Makes an edge if the side is between two pieces.
    EdgeUse use_of(const Ends& ends) {
        const auto found = uses_.find(ends);
        if (found != uses_.end()) return found->second;
        const auto number = static_cast<std::uint32_t>(part_.edges.size());
        part_.edges.push_back({ends.first, ends.second, Line{}});
        uses_[{ends.second, ends.first}] = {number, false};
        return uses_[ends] = {number, true};
    }

    // Puts the outline first. A face off the plane of the facet gets its own mean plane.
    void finish(Face& face) const {
        const auto goes_left = [&](const Loop& loop) {
            Face only = face;
            only.loops = {loop};
            const auto plane = mean_plane(part_, only);
            return plane && dot(plane->normal, plane_.normal) > 0.0;
        };
        std::stable_partition(face.loops.begin(), face.loops.end(), goes_left);
        const auto own = mean_plane(part_, face);
        set_plane(part_, face,
                  own && distance_from_plane(part_, face, plane_) > kFlat ? *own : plane_);
    }

    Part& part_;
    const Face face_;
    const Plane plane_;
    std::map<Ends, EdgeUse> uses_;
    std::vector<Triangle> triangles_;
    std::map<Ends, std::uint32_t> at_side_;  // triangle of each directed side
    std::optional<DisjointSets> pieces_;
    std::set<Ends> is_used_;
};

}  // namespace

bool is_nonplanar(const Part& part, const Face& face) {
    const auto* plane = std::get_if<Plane>(&face.surface.form);
    return plane && is_straight(part, face) && distance_from_plane(part, face, *plane) > kFlat;
}

std::vector<std::uint32_t> triangulate_nonplanar_faces(Part& part) {
    std::vector<std::uint32_t> whole;
    const auto count = static_cast<std::uint32_t>(part.faces.size());
    for (std::uint32_t f = 0; f < count; ++f) {
        if (!part.faces[f].is_facet || !is_nonplanar(part, part.faces[f])) continue;
        const Vec3 normal = std::get<Plane>(part.faces[f].surface.form).normal;
        const auto mean = mean_plane(part, part.faces[f]);
        if (mean && distance_from_plane(part, part.faces[f], *mean) <= kFlat &&
            dot(mean->normal, normal) > 0.0) {
            set_plane(part, part.faces[f], *mean);
            continue;
        }
        std::vector<Face> pieces = NonplanarFacet(part, part.faces[f]).pieces();
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (i == 0) {
                part.faces[f] = std::move(pieces[i]);
                continue;
            }
            append_face(part, f, std::move(pieces[i]));
            whole.push_back(f);
        }
    }
    return whole;
}

}  // namespace ncsim::brep
