// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of an edge from the adjacent surfaces, as measured by CAD readers.
#pragma once

#include "ncsim/brep/parameter_curve.h"
#include "ncsim/brep/part.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ncsim::brep {

/// Distance of an edge from the surfaces of its faces.
///
/// OpenCASCADE measures an edge at both ends and at 21 places between, and takes the largest
/// distance as the tolerance of the edge. The check before Boolean operations searches the maximum
/// and rejects an edge whose maximum lies between the measured places. If the edge is split at the
/// maximum, OpenCASCADE measures there, because the place is an end.
class EdgeDeviation {
public:
    /// Requires: `part`, `edge` and the arguments of add() outlive this object.
    EdgeDeviation(const Part& part, const Edge& edge);

    /// Adds a surface onto which CAD readers project the edge.
    void add(const Form& form) { forms_.push_back(&form); }
    /// Adds a surface in whose parameters the file has the edge.
    void add(const ParameterSurface& surface, const ParameterCurve& curve);

    /// Returns the largest distance at `t`, 0 to 1 of the parameter of the edge, mm.
    double at(double t) const;

    /// Returns the place of the largest distance, 0 to 1, if OpenCASCADE does not measure there: if
    /// the distance is more than 1e-7 mm and larger than at each measured place, and the place is
    /// at least 1e-4 mm and four times the distance from both ends of the edge.
    /// Cost: at most 23 distances from forms for an edge on all its surfaces, otherwise some
    /// hundred evaluations of at().
    std::optional<double> unmeasured_maximum() const;

private:
    struct InParameters {
        const ParameterSurface* surface;
        const ParameterCurve* curve;
    };
    // Largest distance, mm, among places `step` apart.
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
    // Largest error of the fits of curves in parameters, and distance of a circle from the corners.
    double miss_mm_ = 0.0;
};

}  // namespace ncsim::brep
