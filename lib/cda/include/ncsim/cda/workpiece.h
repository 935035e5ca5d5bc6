// SPDX-License-Identifier: GPL-3.0-or-later
//
// Interface between the simulation and workpiece models.
// Source: Schüppel, Using Boolean Operations to Simulate CNC-Milling, 2001, chapter 1
// (CstaWpModel): create, subtract, clone.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/surface_recorder.h"
#include "ncsim/cda/sweep.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace ncsim::cda {

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

/// A workpiece being machined. The user selects the model by name (models.h). A prototype: `create`
/// makes a new workpiece of the same model.
///
/// Every model answers all queries of this class. A model that can do more also inherits
/// SweepModel, AccountingModel, VerifyingModel or CellModel (cell_model.h). A caller finds out with
/// one dynamic_cast; simulation::ModelInfo has the same facts before a part exists.
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
    /// True if the point is in the part or on the surface. Exact models decide for the point
    /// rounded to 2^-16 of a lattice unit. Default: decides by boundary(). Requires: for the
    /// default, the point is farther from the surface than rounding errors.
    virtual bool contains(Vec3 point) const;
};

/// Interface of models that subtract round tools directly. Callers pass sweeps for upright tools on
/// straight motions, and cells otherwise.
class SweepModel {
public:
    virtual ~SweepModel() = default;
    virtual void subtract_sweep(const RoundSweep& sweep) = 0;
};

/// Interface of models that account for the volume that the cells of each origin remove.
class AccountingModel {
public:
    virtual ~AccountingModel() = default;
    /// Starts the account.
    virtual void track_removal() = 0;
    /// Returns the account. Volumes below 1e-15 of the stock are returned as 0.
    virtual RemovalByMotion account() const = 0;
};

/// A workpiece that supports verification. clone() returns one, too.
class VerifyingModel : public WorkpieceModel, public AccountingModel {
public:
    /// Returns a point (mm) whose every neighbourhood contains inner points of the cell and of the
    /// part; empty if the two touch at most. Exact, and cheaper than the volume.
    virtual std::optional<Vec3> contact(const Cell& cell) const = 0;
    /// Returns the common volume (mm³) of the cell and the part; exactly 0 if the two touch at
    /// most. For a tile: a summand, as in subtract().
    virtual double common_volume(const Cell& cell) const = 0;
};

}  // namespace ncsim::cda
