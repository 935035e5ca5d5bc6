// SPDX-License-Identifier: GPL-3.0-or-later
//
// The workpiece as the simulation sees it: what can be done to it, whatever it is made
// of. Schüppel, Using Boolean Operations to Simulate CNC-Milling, 2001, chapter 1
// (CstaWpModel): create, subtract, render, clone.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/cell.h"
#include "ncsim/cda/vec.h"

#include <map>
#include <memory>
#include <span>
#include <vector>

namespace ncsim::cda {

/// One facet to be drawn and the regions of it that must not be: convex polygons in its plane,
/// corners counter-clockwise seen from outside the material, in mm.
struct MaskedFacet {
    Vec3 normal;  ///< Unit, out of the material.
    Origin origin = kStockOrigin;
    std::span<const Vec3> outline;
    std::span<const std::vector<Vec3>> masks;
};

/// Something that can draw facets, a stencil buffer for instance (thesis 5.1).
class FacetCanvas {
public:
    virtual ~FacetCanvas() = default;
    virtual void draw(const MaskedFacet& facet) = 0;
};

/// What the cells of an origin took from a part.
struct Taking {
    double volume = 0.0;  ///< mm³
    Box bounds;           ///< Around those of the cells that took something, mm; empty: none did.
    bool operator==(const Taking&) const = default;
};
using Account = std::map<Origin, Taking>;

/// A workpiece being machined. The one abstract class of the flow: the user picks the model by
/// name. A prototype: `create` makes a new workpiece of the same kind.
class WorkpieceModel {
public:
    virtual ~WorkpieceModel() = default;

    /// A new, unharmed workpiece of this kind. Throws std::invalid_argument if `stock` has no
    /// volume.
    virtual std::unique_ptr<WorkpieceModel> create(const Cell& stock,
                                                   const Lattice& lattice) const = 0;
    /// Takes `cell` away and returns how much of the part that was, in mm³; exactly 0 if the part
    /// lost nothing. Flat cells, and cells that only touch the part, change nothing.
    virtual double subtract(const Cell& cell) = 0;
    /// The same for callers that do not ask how much it was; many at a time are taken away faster.
    virtual void subtract_unmeasured(std::span<const Cell> cells) {
        for (const Cell& cell : cells)
            subtract(cell);
    }
    void subtract_unmeasured(const Cell& cell) { subtract_unmeasured(std::span(&cell, 1)); }
    /// From now on it is booked what the cells of each origin take away.
    virtual void keep_account() {}
    /// What is in the books; less than 1e-15 of the stock is told as 0.
    virtual Account account() const = 0;
    /// Draws every facet once with its masks, in an order that depends on the input only.
    virtual void render(FacetCanvas& canvas) const = 0;
    virtual std::unique_ptr<WorkpieceModel> clone() const = 0;

    /// Volume of what is left, in mm³.
    virtual double volume() const = 0;
    /// The surface of what is left.
    virtual Boundary boundary() const = 0;
    /// Is the point in the part? Points of the surface count as inside. Exact for the point rounded
    /// to 2^-16 of a lattice unit.
    virtual bool contains(Vec3 point) const = 0;
};

}  // namespace ncsim::cda
