// SPDX-License-Identifier: GPL-3.0-or-later
//
// Interface between the simulation and workpiece models.
// Source: Schüppel, Using Boolean Operations to Simulate CNC-Milling, 2001, chapter 1
// (CstaWpModel): create, subtract, render, clone.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/surface_recorder.h"
#include "ncsim/cda/sweep.h"

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

/// A facet to be drawn and the regions to be left out: convex polygons in the facet's plane,
/// corners counter-clockwise seen from outside the material, in mm.
struct MaskedFacet {
    Vec3 normal;  ///< Unit vector out of the material.
    Origin origin = kStockOrigin;
    std::span<const Vec3> outline;
    std::span<const std::vector<Vec3>> masks;
};

/// A canvas that can draw facets, for instance with a stencil buffer (thesis 5.1).
class FacetCanvas {
public:
    virtual ~FacetCanvas() = default;
    virtual void draw(const MaskedFacet& facet) = 0;
};

/// Volume that the cells of one origin removed from a part.
struct RemovedVolume {
    double volume = 0.0;  ///< mm³
    Box bounds;           ///< Box around the cells that removed volume, mm; empty if no cell did.
    bool operator==(const RemovedVolume&) const = default;
};
/// Removed volumes by origin.
using RemovalByMotion = std::map<Origin, RemovedVolume>;

/// Places where a part is thinner than a model of limited resolution can represent.
struct ThinPlaces {
    std::uint64_t count = 0;    ///< Number of rays that cross a thin place.
    std::uint64_t missing = 0;  ///< Number of such rays on which the surface lacks the thin place.
    /// Volume of the missing places, by the ray direction that finds the largest.
    double missing_mm3 = 0.0;
    double thinnest_mm = 0.0;      ///< Smallest thickness along a ray; 0: no thin place.
    Vec3 at;                       ///< Position of the smallest thickness, mm.
    Origin origin = kStockOrigin;  ///< The later of the two motions that made the place.
};
/// Thin places of a model with limited resolution.
struct Aliasing {
    ThinPlaces material, gaps;
    bool checks_only_along_z = false;  ///< True if walls and slots are not checked.
};

/// Thrown if a model does not support a query; models.h lists the abilities of each model.
class CannotAnswer : public std::logic_error {
public:
    /// Builds the message from the name of the model and the missing answer.
    CannotAnswer(std::string_view model, std::string_view what)
        : std::logic_error("the model " + std::string(model) + " does not tell " +
                           std::string(what)) {}
};

/// A workpiece being machined. The only abstract class of the data flow: the user selects the model
/// by name (models.h). A prototype: `create` makes a new workpiece of the same model.
///
/// Callers do not depend on the dynamic type. Queries that not every model supports throw
/// CannotAnswer by default.
class WorkpieceModel {
public:
    virtual ~WorkpieceModel() = default;

    /// Returns the name in models().
    virtual std::string_view name() const = 0;
    virtual const Lattice& lattice() const = 0;

    /// Returns a new, uncut workpiece of this model. Throws: std::invalid_argument if `stock` has
    /// no volume.
    virtual std::unique_ptr<WorkpieceModel> create(const Cell& stock,
                                                   const Lattice& lattice) const = 0;
    /// Removes `cell` and returns the removed volume of the part in mm³; exactly 0 if the part lost
    /// none. Flat cells, and cells that only touch the part, change nothing. For a tile the result
    /// is the tile's summand of the volume and may be negative; the sum over all tiles is the
    /// volume.
    virtual double subtract(const Cell& cell) = 0;
    /// The same without the volume; many cells at a time are removed faster.
    virtual void subtract_unmeasured(std::span<const Cell> cells) {
        for (const Cell& cell : cells)
            subtract(cell);
    }
    void subtract_unmeasured(const Cell& cell) { subtract_unmeasured(std::span(&cell, 1)); }
    /// True if the model subtracts round tools directly. Callers then pass sweeps for upright tools
    /// on straight motions, and cells otherwise.
    virtual bool supports_sweeps() const { return false; }
    virtual void subtract_sweep(const RoundSweep&) {
        throw CannotAnswer(name(), "what a round tool takes away");
    }
    /// Starts the account of the volume that the cells of each origin remove.
    virtual void track_removal() {}
    /// Returns the account. Volumes below 1e-15 of the stock are returned as 0.
    virtual RemovalByMotion account() const = 0;
    /// Draws every facet once with masks, in an order that depends only on the input.
    virtual void render(FacetCanvas& canvas) const = 0;
    virtual std::unique_ptr<WorkpieceModel> clone() const = 0;

    /// Returns the volume of the part, in mm³.
    virtual double volume() const = 0;
    /// Returns the largest error of volume() in either direction, as far as the model can bound the
    /// error; 0 if the model is exact.
    virtual double volume_error() const { return 0.0; }
    /// Returns thin places; only for models with a resolution.
    virtual std::optional<Aliasing> aliasing() const { return std::nullopt; }
    /// Returns the surface of the part.
    virtual Boundary boundary() const = 0;
    /// Records the surface of the part as the next state. Default: records boundary().
    virtual void record_surface(SurfaceRecorder& recorder) const;
    /// True if the point is in the part or on the surface. Exact for the point rounded to 2^-16 of
    /// a lattice unit.
    virtual bool contains(Vec3 point) const = 0;

    // Queries of models that support verification.

    /// Returns a point (mm) whose every neighbourhood contains inner points of the cell and of the
    /// part; empty if the two touch at most. Exact, and cheaper than the volume.
    virtual std::optional<Vec3> contact(const Cell&) const {
        throw CannotAnswer(name(), "where a body meets the part");
    }
    /// Returns the common volume (mm³) of the cell and the part; exactly 0 if the two touch at
    /// most. For a tile: a summand, as in subtract().
    virtual double common_volume(const Cell&) const {
        throw CannotAnswer(name(), "what a body has in common with the part");
    }

    // Operations of models that support tiles.

    /// Removes the cells of one step of a tool near the stock: all cells near wanted(), and perhaps
    /// more. Waiting cells are inserted after a fixed number of steps, not cells, so that a tile
    /// that receives fewer cells produces bit-identical results. `merged_cells`: cells within the
    /// space removed by `cells`. If the model inserts `merged_cells`, the model may drop cells that
    /// `merged_cells` contains. `preceding_merged_cells`: the same, within the space removed by
    /// previous steps.
    virtual void subtract_step(std::span<const Cell> cells, std::span<const Cell> merged_cells = {},
                               std::span<const Cell> preceding_merged_cells = {}) {
        subtract_unmeasured(preceding_merged_cells);
        subtract_unmeasured(cells);
        subtract_unmeasured(merged_cells);
    }
    /// Returns the box (mm) near which cells are needed; empty: near the whole part.
    virtual std::optional<Box> wanted() const { return std::nullopt; }
    /// Writes the tile's data for Tiles.
    virtual void write_tile(std::ostream&) const { throw CannotAnswer(name(), "tiles of it"); }

    // Output of models made of cells.

    /// Writes one row per subtraction, comma-separated, after a row of names: costs in milliseconds
    /// and numbers of facets as in thesis figures 7.1, 7.2 and 7.6.
    virtual void write_statistics(std::ostream&) const {
        throw CannotAnswer(name(), "what each hull cost");
    }
    /// Writes the whole structure as XML: cells with corners (mm), facets with planes and bindings.
    virtual void write_cells(std::ostream&) const { throw CannotAnswer(name(), "its cells"); }
};

}  // namespace ncsim::cda
