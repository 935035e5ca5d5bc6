// SPDX-License-Identifier: GPL-3.0-or-later
//
// Interface of models made of cells, which show the cells: drawn behind masks, and written.
// Source: Schüppel, Using Boolean Operations to Simulate CNC-Milling, 2001, section 5.1.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/origin.h"

#include <iosfwd>
#include <span>
#include <vector>

namespace ncsim::cda {

/// A facet to be drawn and the regions to be left out: convex polygons in the facet's plane,
/// corners counter-clockwise seen from outside the material, in mm.
struct MaskedFacet {
    Vec3 normal;  ///< Unit vector out of the material.
    Origin origin = kStockOrigin;
    std::span<const Vec3> outline;
    std::span<const std::vector<Vec3>> masks;
};

/// A canvas that can draw facets, for instance with a stencil buffer.
class FacetCanvas {
public:
    virtual ~FacetCanvas() = default;
    virtual void draw(const MaskedFacet& facet) = 0;
};

/// A body that is drawn facet by facet, without a boundary.
class FacetModel {
public:
    virtual ~FacetModel() = default;
    /// Draws every facet once with masks, in an order that depends only on the input.
    virtual void render(FacetCanvas& canvas) const = 0;
};

/// Interface of models made of cells.
class CellModel : public FacetModel {
public:
    /// Writes one row per subtraction, comma-separated, after a row of names: costs in milliseconds
    /// and numbers of facets as in thesis figures 7.1, 7.2 and 7.6.
    virtual void write_statistics(std::ostream& out) const = 0;
    /// Writes the whole structure as XML: cells with corners (mm), facets with planes and bindings.
    virtual void write_cells(std::ostream& out) const = 0;
};

}  // namespace ncsim::cda
