// SPDX-License-Identifier: GPL-3.0-or-later
//
// The workpiece as the simulation sees it: what can be done to it, whatever it is made
// of. Schüppel, Using Boolean Operations to Simulate CNC-Milling, 2001, chapter 1
// (CstaWpModel): create, subtract, render, clone.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/sweep.h"
#include "ncsim/cda/vec.h"

#include <cstdint>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
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

/// Where a part is thinner than what a model of limited resolution can show.
struct ThinPlaces {
    std::uint64_t count = 0;    ///< Of rays that cross one.
    std::uint64_t missing = 0;  ///< Those of them that the surface does not have.
    double missing_mm3 = 0.0;   ///< What these amount to, as the direction has it that sees most.
    double thinnest_mm = 0.0;   ///< Along a ray; 0: there is none.
    Vec3 at;                    ///< There, mm.
    Origin origin = kStockOrigin;  ///< The later of the two motions that made it.
};
struct Aliasing {
    ThinPlaces material, gaps;
    bool is_seen_along_z_alone = false;  ///< Walls and slots are not looked for then.
};

/// A model was asked what it does not know; models.h tells beforehand what each is for.
class CannotAnswer : public std::logic_error {
public:
    /// "the model cda-flat does not tell `what`"
    CannotAnswer(std::string_view model, std::string_view what)
        : std::logic_error("the model " + std::string(model) + " does not tell " +
                           std::string(what)) {}
};

/// A workpiece being machined. The one abstract class of the flow: the user picks the model by
/// name (models.h). A prototype: `create` makes a new workpiece of the same kind.
///
/// Nobody asks what class a part is of. Questions that not every model can answer have an answer
/// here, which is to throw CannotAnswer.
class WorkpieceModel {
public:
    virtual ~WorkpieceModel() = default;

    /// As in models().
    virtual std::string_view name() const = 0;
    virtual const Lattice& lattice() const = 0;

    /// A new, unharmed workpiece of this kind. Throws std::invalid_argument if `stock` has no
    /// volume.
    virtual std::unique_ptr<WorkpieceModel> create(const Cell& stock,
                                                   const Lattice& lattice) const = 0;
    /// Takes `cell` away and returns how much of the part that was, in mm³; exactly 0 if the part
    /// lost nothing. Flat cells, and cells that only touch the part, change nothing. Of a tile:
    /// what it adds to the volume, less than nothing maybe; of all tiles together it is that.
    virtual double subtract(const Cell& cell) = 0;
    /// The same for callers that do not ask how much it was; many at a time are taken away faster.
    virtual void subtract_unmeasured(std::span<const Cell> cells) {
        for (const Cell& cell : cells)
            subtract(cell);
    }
    void subtract_unmeasured(const Cell& cell) { subtract_unmeasured(std::span(&cell, 1)); }
    /// Does it take round tools as they are? Then it is given these where they are upright and go
    /// straight ahead, and cells where not.
    virtual bool takes_sweeps() const { return false; }
    virtual void subtract_sweep(const RoundSweep&) {
        throw CannotAnswer(name(), "what a round tool takes away");
    }
    /// From now on it is booked what the cells of each origin take away.
    virtual void keep_account() {}
    /// What is in the books; less than 1e-15 of the stock is told as 0.
    virtual Account account() const = 0;
    /// Draws every facet once with its masks, in an order that depends on the input only.
    virtual void render(FacetCanvas& canvas) const = 0;
    virtual std::unique_ptr<WorkpieceModel> clone() const = 0;

    /// Volume of what is left, in mm³.
    virtual double volume() const = 0;
    /// How much that may be off to either side, as far as the model itself can tell; exact: 0.
    virtual double volume_error() const { return 0.0; }
    /// Of models that have a resolution.
    virtual std::optional<Aliasing> aliasing() const { return std::nullopt; }
    /// The surface of what is left.
    virtual Boundary boundary() const = 0;
    /// Is the point in the part? Points of the surface count as inside. Exact for the point rounded
    /// to 2^-16 of a lattice unit.
    virtual bool contains(Vec3 point) const = 0;

    // Of models that programs can be verified with.

    /// Where the cell and the part have volume in common: a point (mm) with inner points of both as
    /// near to it as anybody likes; nothing if they touch at most. Exact, and cheaper than the
    /// volume.
    virtual std::optional<Vec3> contact(const Cell&) const {
        throw CannotAnswer(name(), "where a body meets the part");
    }
    /// Volume (mm³) that the cell has in common with the part; exactly 0 if they touch at most. Of
    /// a tile: as of subtract().
    virtual double common_volume(const Cell&) const {
        throw CannotAnswer(name(), "what a body has in common with the part");
    }

    // Of models that may be cut in tiles.

    /// Takes away the cells of one step of a tool near the stock: those that are wanted, and maybe
    /// others. When what waits is taken in depends on the number of steps then, not on their cells:
    /// who gets fewer of them makes of his share the same, to the last bit.
    /// `covering`: lie within what was taken away with these; who takes them in may forget the
    /// others. `before`: within what was taken away before, likewise.
    virtual void subtract_step(std::span<const Cell> cells, std::span<const Cell> covering = {},
                               std::span<const Cell> before = {}) {
        subtract_unmeasured(before);
        subtract_unmeasured(cells);
        subtract_unmeasured(covering);
    }
    /// Near which place (mm) cells are wanted; nothing: near all of the part.
    virtual std::optional<Box> wanted() const { return std::nullopt; }
    /// What this tile of a part knows, for Tiles.
    virtual void write_tile(std::ostream&) const { throw CannotAnswer(name(), "tiles of it"); }

    // Of models that are made of cells which people look at.

    /// One row a subtraction, comma-separated, after a row of names: costs in milliseconds and
    /// numbers of facets as in thesis figures 7.1, 7.2 and 7.6.
    virtual void write_statistics(std::ostream&) const {
        throw CannotAnswer(name(), "what each hull cost");
    }
    /// The whole structure as XML: cells with their corners (mm), facets with plane and bindings.
    virtual void write_cells(std::ostream&) const { throw CannotAnswer(name(), "its cells"); }
};

}  // namespace ncsim::cda
