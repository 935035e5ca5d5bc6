// SPDX-License-Identifier: GPL-3.0-or-later
//
// A workpiece of rays, for pictures of long programs: three grids of rays, one along each axis,
// that remember where they are in the material. What is cut away is an interval of each ray; the
// surface is put between the ends of rays by dual contouring.
//
// Van Hook, "Real-Time Shaded NC Milling Display", SIGGRAPH 1986 (one direction); the Intersecting
// Ray Model of the thesis, section 2.2 (three).
#pragma once

#include "ncsim/cda/workpiece.h"
#include "ncsim/dexel/mesher.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

namespace ncsim::dexel {

enum class Directions {
    Three,
    /// Along z alone: of parts without undercuts, several times as fast. Walls are where they are
    /// to half a pitch.
    OnlyZ,
};

struct DexelParameters {
    std::size_t threads = 0;     ///< 0: as many as the machine has. Changes nothing else.
    double resolution_mm = 0.0;  ///< Between rays; 0: default_resolution().
    Directions directions = Directions::Three;
    Mesher mesher = Mesher::DualContouring;
};

/// Where nobody tells one: of stock with this longest side, the same unit.
inline double default_resolution(double longest) {
    return longest / 250.0;
}

/// Of stock of this size, mm: finer ones take more rays than are kept, two million.
double finest_resolution(cda::Vec3 size);

/// Between rays, a wall or a slot may be missing; on a ray, the surface is that of the round tool
/// (cda::RoundSweep), or, of other tools and those that do not stand upright, of its polytope, to a
/// lattice unit. The surface is closed whatever is cut, and each of its corners within one cell of
/// the grid (the resolution, along each axis) of ends of rays. 48 bytes a ray of one interval.
class Dexel : public cda::WorkpieceModel {
public:
    static constexpr std::string_view kName = "dexel";

    /// A prototype. Parts of it throw std::invalid_argument where the resolution is finer than
    /// finest_resolution().
    explicit Dexel(const DexelParameters& parameters = {});
    ~Dexel() override;

    std::string_view name() const override { return kName; }
    const cda::Lattice& lattice() const override;
    std::unique_ptr<cda::WorkpieceModel> create(const cda::Cell& stock,
                                                const cda::Lattice& lattice) const override;
    /// To how much the difference of two volumes() comes: never exact.
    double subtract(const cda::Cell& cell) override;
    void subtract_unmeasured(std::span<const cda::Cell> cells) override;
    using cda::WorkpieceModel::subtract_unmeasured;
    bool takes_sweeps() const override { return true; }
    void subtract_sweep(const cda::RoundSweep& sweep) override;
    /// Throws cda::CannotAnswer.
    cda::Account account() const override;
    void render(cda::FacetCanvas& canvas) const override;
    std::unique_ptr<cda::WorkpieceModel> clone() const override;
    /// The mean of what the rays of each direction have.
    double volume() const override;
    /// As far as the rays can tell, whichever direction is right: half the resolution times the
    /// walls that its rays are parallel to, and how far its volume is from the mean of all. What is
    /// thinner than the resolution, and lies between all rays, is not in it.
    double volume_error() const override;
    std::optional<cda::Aliasing> aliasing() const override;
    /// Triangles; each names the motion that left the end of a ray on one of its sides.
    cda::Boundary boundary() const override;
    /// Asked of the nearest ray along z.
    bool contains(cda::Vec3 point) const override;

    /// The largest distance between neighbouring rays, mm.
    double resolution() const;
    std::size_t rays() const;
    /// What they take in memory.
    std::size_t bytes() const;

private:
    class Impl;
    explicit Dexel(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace ncsim::dexel
