// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of an edge from its surfaces, as readers of files measure them.
#pragma once

#include "ncsim/brep/parameter_curve.h"
#include "ncsim/brep/part.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ncsim::brep {

/// Distance of an edge from the surfaces of its faces.
///
/// OpenCASCADE measures an edge at its ends and at 21 places between, and takes the largest
/// distance as the tolerance of the edge. Its check before Booleans searches the maximum and
/// refuses an edge whose maximum lies between these places. A vertex at the maximum makes it an
/// end, which is measured.
class EdgeDeviation {
public:
    /// Requires: `part` and `edge` outlive this object, and so do the arguments of add().
    EdgeDeviation(const Part& part, const Edge& edge);

    /// Adds a surface onto which readers project the edge.
    void add(const Form& form) { forms_.push_back(&form); }
    /// Adds a surface in whose parameters the file has the edge.
    void add(const ParameterSurface& surface, const ParameterCurve& curve);

    /// Returns the largest distance at `t`, 0 to 1 of the parameter of the edge, mm.
    double at(double t) const;

    /// Returns the place of the largest distance, 0 to 1, if readers do not measure it: if it is
    /// more than 1e-7 mm, larger than the distance at each measured place, and at least 1e-4 mm and
    /// four times that distance from both ends of the edge.
    /// Cost: at most 23 distances from forms for an edge on its surfaces, otherwise some hundred
    /// evaluations of at().
    std::optional<double> unmeasured_maximum() const;

private:
    struct InParameters {
        const ParameterSurface* surface;
        const ParameterCurve* curve;
    };
    // The largest distance, mm, among places `step` apart.
    struct Maximum {
        double t = 0.0, mm = 0.0, step = 0.0;
    };
    double from_forms(Vec3 p) const;
    Maximum largest_of(double from, double to, std::size_t parts) const;
    Maximum maximum() const;
    Maximum climb(Maximum from) const;

    Track track_;
    std::vector<const Form*> forms_;
    std::vector<InParameters> in_parameters_;
    double miss_mm_ = 0.0;  // of curves in parameters by their fits, of circles from their corners
};

}  // namespace ncsim::brep
