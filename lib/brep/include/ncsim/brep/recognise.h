// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recognition of true surfaces from facets. The closed polyhedron determines which surfaces meet;
// the program determines the surfaces. Vertices and edges are computed anew on the surfaces, so the
// result keeps no trace of the polygons that stood for the tools.
#pragma once

#include "ncsim/brep/facets.h"
#include "ncsim/brep/part.h"
#include "ncsim/brep/swept_surfaces.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <vector>

namespace ncsim::brep {

/// Result of recognise().
struct Recognised {
    Part part;
    std::size_t facets_kept = 0;  ///< Number of faces that were not recognised.
    /// Number of kept facets that belong to the mesh of the stock (mark_tessellated()); set by the
    /// caller.
    std::size_t stock_facets = 0;
    std::vector<cda::Origin> of_facets{};  ///< Motions that cut the facets, ascending.
    std::size_t shells_kept = 0;           ///< Number of shells that consist of facets alone.
    /// Number of facets that fit a surface of their source but not the adjacent faces; smaller
    /// facets might fit both. For shells that are kept as facets, the number of the last attempt.
    std::size_t facets_demoted = 0;
    /// Counted work: a unit for each facet in each round of corrections.
    std::uint64_t work = 0;
    bool has_ended_early = false;  ///< True if a shell had more work than was allowed.
    bool has_lost_coils = false;   ///< True if facets of a coil were not recognised.
    /// Largest height in mm by which a removed lune is lower than the surface in its place. Balls
    /// leave lunes at corners of the path.
    double mitred_mm = 0.0;
    /// Worst values of FlatPart::tolerance_factor and FlatPart::is_sound over all shells that are
    /// facets alone.
    double tolerance_factor = 1.0;
    bool is_sound = true;
};

inline constexpr std::uint64_t kUnlimitedWork = std::numeric_limits<std::uint64_t>::max();

/// Returns the part with the facets `facets`, made of the surfaces of `sources`. Faces whose origin
/// has no source stay facets.
///
/// Facets that lie within the error of their source become faces on the surfaces of the source; all
/// remaining facets are kept. If a shell cannot satisfy the guarantees, some faces or the whole
/// shell stay facets. A shell as a whole comes from `kept`, which is called only in this case and
/// returns the same part, joined into as few planar faces as possible within `times` its tolerance.
/// After `most_work` units of work in a shell, all faces that fail become facets at once; after
/// twice as many, the whole shell does.
///
/// Guarantees: every shell with recognised faces is closed; edges lie on their surfaces within 3 µm
/// (Part::miss_mm has the measured value), next to kept facets within about 2.5 times the error of
/// these (Part::facet_miss_mm); loops are simple; the volume differs from the polyhedron's by at
/// most area times error. Equal input gives equal bytes.
/// Cost: expected O(n log n) for n facets.
Recognised recognise(const Facets& facets, const std::map<cda::Origin, SweptSurfaces>& sources,
                     const std::function<Facets(double times)>& kept,
                     std::uint64_t most_work = kUnlimitedWork);

}  // namespace ncsim::brep
