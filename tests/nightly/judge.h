// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is a point material after a program? Said of the round tools on their true ways, and only where
// it is certain whatever docs/accuracy.md allows the simulation.
#pragma once

#include "nightly/closest_approach.h"
#include "nightly/program_generator.h"

#include <string>
#include <vector>

namespace ncsim::nightly {

/// What a simulation says of its own accuracy, mm.
struct StatedAccuracy {
    double unit = 1e-5;              ///< Of the lattice.
    std::vector<double> tool_error;  ///< By tool: of the polygons.
    double missed = 0.0;             ///< The worst of all moves.
    double gained = 0.0;
};

enum class Verdict : std::uint8_t {
    Material,  ///< Must be in the part.
    Empty,     ///< Must not be.
    Open,      ///< Within what is allowed of a surface.
};

/// By how much the trace of a move may differ from the sweep of its tool, mm.
struct Allowance {
    double missed = 0.0;  ///< Inside of the sweep, to its surface.
    double gained = 0.0;  ///< Beyond what the tool as a polygon sweeps.
    double tool = 0.0;    ///< Of that polygon beyond the tool.
    double beyond() const { return gained + tool; }
};

class Judge {
public:
    Judge(const Program& program, const StatedAccuracy& stated);

    Verdict operator()(const Vec& p_W) const;

    /// Bounds of the signed distance from the sweep of move `i`, as narrow as is cheap.
    Bounds distance(std::size_t i, const Vec& p_W) const;
    const Allowance& allowance(std::size_t i) const { return allowances_[i]; }
    /// Why the verdict is what it is: the moves that matter, with their bounds.
    std::string explain(const Vec& p_W) const;

private:
    enum class Effect : std::uint8_t { None, Removes, Perhaps };
    Effect effect(std::size_t i, const Vec& p_W) const;
    bool is_beyond_box(std::size_t i, const Vec& p_W) const;
    bool is_inside_stock(const Vec& p_W) const;
    bool is_outside_stock(const Vec& p_W) const;
    double off_lattice(double mm) const;
    double rounding_of(double mm) const;
    double rounded_up(double mm) const;
    double widest(const RoundTool& tool) const;

    const Program& program_;
    StatedAccuracy stated_;
    std::vector<Allowance> allowances_;
};

/// The finest lattice of 10, 20, 50, 100 … nm on which the stock has coordinates of 25 bits, mm.
double lattice_unit(const StockShape& stock);

}  // namespace ncsim::nightly
