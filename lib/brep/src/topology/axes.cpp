// SPDX-License-Identifier: GPL-3.0-or-later
//
// Local coordinates on domes and tori.
#include "topology/axes.h"

#include "ncsim/base/angles.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ncsim::brep {

Local local_on(const Dome& dome, const Axes& axes, Vec3 p) {
    const DomePlace place = project_onto(dome, p);
    Local local = axes(axes.origin + (p - dome.centre - dome.reach * place.up));
    local.z = dome.reach * place.degrees() * kRadiansPerDegree;
    return local;
}

double cut_of(const Part& part, const Face& face, const Axes& axes, const Torus& torus) {
    if (is_spindle(torus)) return tip_degrees(torus);
    struct Angle {
        double degrees;
        // The face continues to greater angles (1), to smaller angles (-1), or neither.
        int inwards;
        bool operator<(const Angle& o) const { return degrees < o.degrees; }
    };
    std::vector<Angle> angles;
    for_edges(part, face, [&](const Track& track, double sign) {
        for (int i = 0; i <= kSamples; ++i) {
            const double t = static_cast<double>(i) / kSamples;
            const Vec3 at = track.at(t);
            const Local p = axes(at);
            const Vec3 n = outward(face.surface, at);
            const Vec3 radial = (1.0 / p.radius) * (p.x * axes.x + p.y * axes.y);
            const Vec3 tangent = p.z * radial - (p.radius - torus.major) * axes.z;
            const double inwards =
                -dot(normalized(tangent), normalized(sign * cross(n, track.derivative(t))));
            angles.push_back({angle_of(p.radius - torus.major, p.z), inwards > 0.9    ? 1
                                                                     : inwards < -0.9 ? -1
                                                                                      : 0});
        }
    });
    std::sort(angles.begin(), angles.end());
    double widest = 0.0, cut = 0.0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const bool is_last = i + 1 == angles.size();
        const Angle& next = angles[is_last ? 0 : i + 1];
        const double gap = next.degrees + (is_last ? 360.0 : 0.0) - angles[i].degrees;
        if (gap <= widest || angles[i].inwards > 0 || next.inwards < 0) continue;
        widest = gap;
        cut = angles[i].degrees + 0.5 * gap;
    }
    return cut > 180.0 ? cut - 360.0 : cut;
}

double degrees_from(double cut, const Torus& torus, const Local& p) {
    const double degrees = angle_of(p.radius - torus.major, p.z) - cut;
    if (!is_spindle(torus)) return degrees < 0.0 ? degrees + kTurnDegrees : degrees;
    return std::max(0.0, degrees < -kQuarterTurnDegrees ? degrees + kTurnDegrees : degrees);
}

}  // namespace ncsim::brep
