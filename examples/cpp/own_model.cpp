// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts a slot with a model of the workpiece that has a height for each point of a grid, 0.5 mm
// apart: not exact, and for tools from above alone.
//     own_model
#include "ncsim/cda/tree.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/trace.h"

#include <algorithm>
#include <iostream>

using namespace ncsim;

namespace {

class HeightMap : public cda::WorkpieceModel {
public:
    HeightMap(const cda::Cell& stock, const cda::Lattice& lattice)
        : lattice_(lattice), box_(stock.bounds) {
        for (double y = box_.min.y + kStep / 2; y < box_.max.y; y += kStep)
            for (double x = box_.min.x + kStep / 2; x < box_.max.x; x += kStep)
                tops_.push_back({x, y, box_.max.z});
    }
    std::string_view name() const override { return "heights"; }
    const cda::Lattice& lattice() const override { return lattice_; }
    std::unique_ptr<cda::WorkpieceModel> create(const cda::Cell& stock,
                                                const cda::Lattice& lattice) const override {
        return std::make_unique<HeightMap>(stock, lattice);
    }
    double subtract(const cda::Cell& cell) override {
        const double before = volume();
        for (Vec3& top : tops_)
            top.z = std::min(top.z, std::max(box_.min.z, lowest(cell, top)));
        return before - volume();
    }
    double volume() const override {
        double sum = 0.0;
        for (const Vec3& top : tops_)
            sum += top.z - box_.min.z;
        return sum * kStep * kStep;
    }
    std::unique_ptr<cda::WorkpieceModel> clone() const override {
        return std::make_unique<HeightMap>(*this);
    }
    // Returns the surface of the stock without the box above each point of the grid.
    cda::Boundary boundary() const override {
        constexpr Vec3 kHalf{kStep / 2, kStep / 2, 0};
        cda::TreeCda part(
            cda::box_cell(lattice_.round(box_.min), lattice_.round(box_.max), lattice_), lattice_);
        for (const Vec3& top : tops_)
            part.subtract_unmeasured(cda::box_cell(
                lattice_.round(top - kHalf),
                lattice_.round(Vec3{top.x, top.y, box_.max.z + 1} + kHalf), lattice_));
        return part.boundary();
    }

private:
    static constexpr double kStep = 0.5;  // mm

    // Returns the lower end of the vertical line through `p` within `cell`; p.z if the line misses
    // it.
    double lowest(const cda::Cell& cell, Vec3 p) const {
        double low = -1e9, high = 1e9;
        for (const cda::Plane& plane : cell.planes) {
            const double rest = static_cast<double>(plane.d) * lattice_.unit_mm - plane.nx * p.x -
                                plane.ny * p.y;  // nz z <= rest
            if (plane.nz == 0 && rest < 0.0) return p.z;
            if (plane.nz > 0) high = std::min(high, rest / plane.nz);
            if (plane.nz < 0) low = std::max(low, rest / plane.nz);
        }
        return low < high ? low : p.z;
    }

    cda::Lattice lattice_;
    Box box_;
    std::vector<Vec3> tops_;  // of the columns
};

}  // namespace

int main() {
    const gcode::SourceFile program{"slot.nc", "G21 G90\nG0 X-5 Y20 Z-5\nG1 X45 F300\nM30\n"};
    const cda::Lattice lattice;
    HeightMap part(cda::box_cell(lattice.round({0, 0, -10}), lattice.round({40, 40, 0}), lattice),
                   lattice);
    toolpath::Cutter cutter(toolpath::flat_end_mill(6.0, 20.0), lattice, {});
    gcode::interpret(program, {}, [&](const gcode::Motion& motion) {
        if (!toolpath::has_known_start(motion)) return;
        const auto path = toolpath::sample(motion, cutter.extent(), {});
        std::vector<cda::Cell> hulls;
        for (std::size_t i = 1; i < path.poses.size(); ++i)
            cutter.trace(path.poses[i - 1], path.poses[i], {}, hulls);
        part.subtract_unmeasured(hulls);
    });
    std::cout << part.volume() << " mm3 are left, with " << part.boundary().faces.size()
              << " faces\n";
}
