// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splitting of arcs next to corners of the same face.
#include "topology/chords.h"

#include "geometry/tolerances.h"
#include "topology/edge_splitter.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

namespace ncsim::brep {

namespace {

// Depth of a chord that a CAD reader may draw, mm.
constexpr double kChordDepth = 0.02;

// Centre of a circle or an ellipse, and largest distance from the centre.
struct Arc {
    Vec3 centre;
    double reach;
};

std::optional<Arc> arc_of(const Curve& curve) {
    if (const auto* circle = std::get_if<Circle>(&curve))
        return Arc{circle->centre, circle->radius};
    if (const auto* ellipse = std::get_if<Ellipse>(&curve))
        return Arc{ellipse->centre, ellipse->major_radius};
    return std::nullopt;
}

// Returns the parameter at which a track is nearest to `p`, if that is between the ends.
std::optional<double> nearest_inside(const Track& track, Vec3 p) {
    const auto ahead = [&](double t) {
        const Track::Step step = track.step(t);
        return dot(p - step.at, step.derivative);
    };
    std::optional<double> best;
    double least = 0.0;
    for (std::size_t i = 0; i < track.pieces(); ++i) {
        double low = track.start_of(i), high = track.start_of(i + 1);
        if (ahead(low) <= 0.0 || ahead(high) >= 0.0) continue;
        for (int k = 0; k < 50; ++k) {
            const double middle = 0.5 * (low + high);
            (ahead(middle) > 0.0 ? low : high) = middle;
        }
        const double deviation = norm(track.at(low) - p);
        if (best && deviation >= least) continue;
        best = low;
        least = deviation;
    }
    return best;
}

// Corners of a planar face, in the order of X.
class CornersOfPlane {
public:
    CornersOfPlane(const Part& part, const Face& face)
        : part_(part), corners_(corners_of(part, face)) {
        std::ranges::sort(corners_, {}, [&](std::uint32_t v) { return part.vertices[v].x; });
    }

    // Returns the fraction of the arc at which to split, next to a corner.
    std::optional<double> split_position(const Edge& edge, const Arc& arc) const {
        const Track track = track_of(part_, edge);
        const double reach = arc.reach + kChordDepth;
        const auto first =
            std::ranges::lower_bound(corners_, arc.centre.x - reach, {},
                                     [&](std::uint32_t v) { return part_.vertices[v].x; });
        for (auto v = first; v != corners_.end(); ++v) {
            const Vec3 p = part_.vertices[*v];
            if (p.x > arc.centre.x + reach) break;
            if (*v == edge.from || *v == edge.to) continue;
            if (const auto at = split_position_near(track, arc, p)) return at;
        }
        return std::nullopt;
    }

private:
    // Returns the fraction nearest to `corner` if a chord of the arc may pass on the wrong side of
    // the corner.
    static std::optional<double> split_position_near(const Track& track, const Arc& arc,
                                                     Vec3 corner) {
        if (norm(corner - arc.centre) > arc.reach) return std::nullopt;
        const auto at = nearest_inside(track, corner);
        if (!at) return std::nullopt;
        const Vec3 foot = track.at(*at), in = corner - foot;
        const Vec3 before = track.at(0.0) - foot, after = track.at(1.0) - foot;
        // A corner nearer to an end than the least size coincides with the end.
        const double nearer = std::min(norm(before), norm(after));
        const double deviation = norm(in);
        if (deviation > kChordDepth || nearer < kLeastSizeMm || dot(in, arc.centre - foot) <= 0.0)
            return std::nullopt;
        // Depth of the whole arc's chord below the foot.
        const Vec3 along = normalized(after - before);
        const double depth = norm(before - dot(before, along) * along);
        const bool is_long = track.sweep_degrees() > 90.0;
        if (!is_long && depth < 0.5 * deviation) return std::nullopt;
        return at;
    }

    const Part& part_;
    Numbers corners_;
};

// Returns true if an edge was split.
bool divide_once(Part& part) {
    bool any = false;
    EdgeSplitter halving(part);
    for (const Face& face : part.faces) {
        if (!is_plane(face)) continue;
        std::optional<CornersOfPlane> corners;
        for (const EdgeUse& use : uses_of(face)) {
            const auto arc = arc_of(part.edges[use.edge].curve);
            if (!arc) continue;
            if (!corners) corners.emplace(part, face);
            const auto at = corners->split_position(part.edges[use.edge], *arc);
            any = (at && halving.halve(use.edge, *at)) || any;
        }
    }
    halving.finish();
    return any;
}

}  // namespace

void split_arcs_near_corners(Part& part) {
    // An arc may need a split for each of several corners.
    for (int i = 0; i < 100 && divide_once(part); ++i) {
    }
}

}  // namespace ncsim::brep
