// SPDX-License-Identifier: GPL-3.0-or-later
//
// From facets to true surfaces. The polyhedron is closed and says which surfaces meet where; the
// program says what the surfaces are. Vertices and edges are computed anew on the surfaces, so that
// nothing of the polygons of the tools is left.
#pragma once

#include "ncsim/brep/facets.h"
#include "ncsim/brep/part.h"
#include "ncsim/brep/swept.h"

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace ncsim::brep {

struct Recognised {
    Part part;
    std::size_t facets_kept = 0;           ///< Faces that were not recognised.
    std::vector<cda::Origin> of_facets{};  ///< Who cut them, ascending.
    std::size_t shells_kept = 0;           ///< Shells all of whose faces are facets.
    /// Facets of the polyhedron that fit a surface of theirs, but not what is beside them: with
    /// smaller ones they might. Of shells that are kept, those of the last attempt.
    std::size_t facets_given_up = 0;
    /// Lunes that balls leave where their way bends were left out, so much lower than what is in
    /// their place, at most.
    double mitred_mm = 0.0;
    /// Of shells that are facets alone (flat_part.h): those of one at least were joined within so
    /// many times the tolerance, and whether all of them are sound.
    double coarser = 1.0;
    bool is_sound = true;
};

/// The part whose facets are `facets`, made of the surfaces of `sources` (an origin that has none
/// is what it is).
///
/// Facets that lie within the error of their source become faces on its surfaces; others stay
/// what they are. The result was checked: every shell is closed, its edges lie on their surfaces
/// within 3 µm (Part::miss_mm tells; beside facets that are kept within about two and a half times
/// their error, Part::facet_miss_mm), loops are simple, and its volume is that of the polyhedron
/// within area times error. Where that cannot be had, facets are kept: of some faces, or of the
/// whole shell, as `kept` gives it, if it is asked: the same part with as few faces as flat ones
/// can be, joined within so many times its tolerance. Equal input gives equal bytes. Expected O(n
/// log n) for n facets.
Recognised recognise(const Facets& facets, const std::map<cda::Origin, Source>& sources,
                     const std::function<Facets(double times)>& kept);

}  // namespace ncsim::brep
