// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/brep/flat_part.h"

#include "ncsim/brep/measure.h"

#include "geometry/tolerances.h"
#include "heal/degenerate_planes.h"
#include "heal/vertex_distance.h"
#include "sources/label.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace ncsim::brep {

namespace {

// True if all loops are connected, with at least two edges, and each edge is unused or used twice,
// in opposite directions.
bool is_closed(const Part& part) {
    struct Passed {
        int times = 0, net = 0;
    };
    std::vector<Passed> passed(part.edges.size());
    const auto end = [&](const EdgeUse& use, bool is_last) {
        const Edge& edge = part.edges[use.edge];
        return use.is_forward == is_last ? edge.to : edge.from;
    };
    for (const Face& face : part.faces) {
        for (const Loop& loop : face.loops) {
            if (loop.size() < 2) return false;
            for (std::size_t i = 0; i < loop.size(); ++i) {
                if (end(loop[i], true) != end(loop[(i + 1) % loop.size()], false)) return false;
                Passed& edge = passed[loop[i].edge];
                ++edge.times;
                edge.net += loop[i].is_forward ? 1 : -1;
            }
        }
    }
    return std::ranges::all_of(passed, [](const Passed& edge) {
        return (edge.times == 0 || edge.times == 2) && edge.net == 0;
    });
}

double area_of_faces(const Part& part) {
    double area = 0.0;
    for (const Face& face : part.faces)
        area += measure(part, face, face.frame.origin).area;
    return area;
}

// True if the part is closed and has the volume.
bool is_whole(const Part& part, double volume_mm3) {
    return is_closed(part) && std::abs(volume(part) - volume_mm3) <= kFlat * area_of_faces(part);
}

}  // namespace

bool is_sound_polyhedron(const Part& part, double volume_mm3) {
    return is_whole(part, volume_mm3) && degenerate_planes(part).empty();
}

FlatPart flat_part(const std::function<Facets(double times)>& facets) {
    FlatPart finest;
    for (const double times : {1.0, 4.0, 16.0, 64.0}) {
        const Facets joined = facets(times);
        FlatPart made{faceted(joined.boundary, joined.origins), times};
        bool are_planes_sound = true;
        enforce_min_vertex_distance(made.part, &are_planes_sound);
        // At the original tolerance, an empty part means that there are no facets. At larger
        // factors, a body thinner than the tolerance has vanished.
        const bool is_empty = made.part.faces.empty();
        made.is_sound = is_empty
                            ? times == 1.0
                            : are_planes_sound && is_whole(made.part, cda::volume(joined.boundary));
        if (made.is_sound) return made;
        if (times == 1.0) finest = std::move(made);
    }
    return finest;
}

}  // namespace ncsim::brep
