// SPDX-License-Identifier: GPL-3.0-or-later
//
// A workpiece of rays, for pictures of long programs: three grids of rays, one along each axis,
// with the intervals in the material. A cut removes an interval of each ray; dual contouring builds
// the surface between the ends of rays.
//
// Source: Van Hook, "Real-Time Shaded NC Milling Display", SIGGRAPH 1986 (one direction); the
// Intersecting Ray Model of the thesis, section 2.2 (three).
#pragma once

#include "ncsim/cda/workpiece.h"
#include "ncsim/dexel/mesher.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

namespace ncsim::dexel {

/// Directions of rays.
enum class Directions {
    Three,
    /// Rays along z only: for parts without undercuts, several times as fast. The error of walls is
    /// at most half a pitch.
    OnlyZ,
};

/// Parameters of the dexel model.
struct DexelParameters {
    /// 0: one per hardware thread. The result does not depend on the number.
    std::size_t threads = 0;
    double resolution_mm = 0.0;  ///< Distance of rays; 0: default_resolution().
    Directions directions = Directions::Three;
    Mesher mesher = Mesher::DualContouring;
};

/// Returns the resolution if none is specified, for stock with this longest side, in the unit of
/// `longest`.
inline double default_resolution(double longest) {
    return longest / 250.0;
}

/// Returns the finest possible resolution for stock of this size, mm. Finer resolutions exceed the
/// limit of two million rays.
double finest_resolution(Vec3 size);

/// Workpiece model of rays. Walls and slots between rays may be missing. On a ray, the surface is
/// exact to a lattice unit: the surface of the round tool (cda::RoundSweep), or of the polytope of
/// any other or inclined tool. The surface is closed for any cuts. Each vertex is within one cell
/// of the grid (the resolution, along each axis) of ends of rays.
/// Cost: 40 bytes per ray with one interval.
class Dexel : public cda::WorkpieceModel, public cda::SweepModel {
public:
    static constexpr std::string_view kName = "dexel";

    /// Creates a prototype. create() throws std::invalid_argument if the resolution is finer than
    /// finest_resolution().
    explicit Dexel(const DexelParameters& parameters = {});
    ~Dexel() override;

    std::string_view name() const override { return kName; }
    const cda::Lattice& lattice() const override;
    std::unique_ptr<cda::WorkpieceModel> create(const cda::Cell& stock,
                                                const cda::Lattice& lattice) const override;
    /// Returns the difference of two volumes(), which is never exact.
    double subtract(const cda::Cell& cell) override;
    void subtract_unmeasured(std::span<const cda::Cell> cells) override;
    using cda::WorkpieceModel::subtract_unmeasured;
    void subtract_sweep(const cda::RoundSweep& sweep) override;
    std::unique_ptr<cda::WorkpieceModel> clone() const override;
    /// Returns the mean of the volumes of the directions.
    double volume() const override;
    /// Returns the error bound as far as rays can detect errors, if any direction may be right:
    /// half the resolution times the walls parallel to the rays, plus the deviation of the
    /// direction's volume from the mean. Features thinner than the resolution between all rays are
    /// not included.
    double volume_error() const override;
    std::optional<cda::Aliasing> aliasing() const override;
    /// Returns triangles; the origin of each is the motion that left an end of a ray on one side.
    cda::Boundary boundary() const override;
    /// Decided by the nearest ray along z.
    bool contains(Vec3 point) const override;

    /// Returns the largest distance of adjacent rays, mm.
    double resolution() const;
    std::size_t rays() const;
    /// Returns the memory of the rays in bytes.
    std::size_t bytes() const;

private:
    class Impl;
    explicit Dexel(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace ncsim::dexel
