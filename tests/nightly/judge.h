// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides if a point is material after a program, from round tools on their exact paths. The
// verdict is certain for any simulation with the accuracy of docs/accuracy.md, or open.
#pragma once

#include "nightly/closest_approach.h"
#include "nightly/program_generator.h"

#include <string>
#include <vector>

namespace ncsim::nightly {

/// Accuracy that a simulation states, mm.
struct StatedAccuracy {
    double unit = 1e-5;              ///< Lattice unit.
    std::vector<double> tool_error;  ///< Error of the polygons, by tool.
    double missed = 0.0;             ///< Maximum over all moves.
    double gained = 0.0;
};

enum class Verdict : std::uint8_t {
    Material,  ///< Must be in the part.
    Empty,     ///< Must not be in the part.
    Open,      ///< Within the tolerance of a surface.
};

/// Permitted deviation of the trace of a move from the sweep of the tool, mm.
struct Allowance {
    double missed = 0.0;  ///< Inside the sweep, from its surface.
    double gained = 0.0;  ///< Outside the sweep of the polygonal tool.
    double tool = 0.0;    ///< Excess of the polygonal tool over the round tool.
    double beyond() const { return gained + tool; }
};

class Judge {
public:
    Judge(const Program& program, const StatedAccuracy& stated);

    Verdict operator()(const Vec& p_W) const;

    /// Returns bounds of the signed distance from the sweep of move `i`, as narrow as is cheap.
    Bounds distance(std::size_t i, const Vec& p_W) const;
    const Allowance& allowance(std::size_t i) const { return allowances_[i]; }
    /// Explains the verdict: the relevant moves with their bounds.
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

/// Returns the finest lattice unit of 10, 20, 50, 100 … nm for which the coordinates of the stock
/// have 25 bits, mm.
double lattice_unit(const StockShape& stock);

}  // namespace ncsim::nightly
