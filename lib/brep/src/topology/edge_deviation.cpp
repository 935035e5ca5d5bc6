// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/brep/edge_deviation.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::brep {

EdgeDeviation::EdgeDeviation(const Part& part, const Edge& edge)
    : track_(edge.curve, part.vertices[edge.from], part.vertices[edge.to]) {
    for (const double t : {0.0, 1.0})
        miss_mm_ = std::max(miss_mm_, norm(point_in_file(track_, track_.at(t)) - track_.at(t)));
}

void EdgeDeviation::add(const ParameterSurface& surface, const ParameterCurve& curve) {
    in_parameters_.push_back({&surface, &curve});
    miss_mm_ = std::max(miss_mm_, curve.miss_mm);
}

double EdgeDeviation::at(double t) const {
    const Vec3 p = point_in_file(track_, track_.at(t));
    double most = from_forms(p);
    for (const auto& [surface, curve] : in_parameters_)
        most = std::max(most, norm(surface->point_on(*curve, t) - p));
    return most;
}

std::optional<double> EdgeDeviation::unmeasured_maximum() const {
    // A line is farthest from a plane at an end.
    const auto is_plane = [](const Form* form) { return std::holds_alternative<Plane>(*form); };
    if (track_.is_straight() && in_parameters_.empty() && std::ranges::all_of(forms_, is_plane))
        return std::nullopt;
    // OpenCASCADE measures at 23 places, ends included.
    const std::size_t parts = 22;
    const auto is_on_forms = [&] {
        for (std::size_t i = 0; i <= parts; ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(parts);
            if (from_forms(point_in_file(track_, track_.at(t))) > kReaderMm) return false;
        }
        return true;
    };
    if (miss_mm_ <= 0.7 * kReaderMm && is_on_forms()) return std::nullopt;
    const Maximum measured = largest_of(0.0, 1.0, parts);
    const Maximum most = maximum();
    // OpenCASCADE enlarges the measured distance by a hundred thousandth.
    if (most.mm <= (1.0 + 0.5 * kParallelAngle) * std::max(measured.mm, kReaderMm))
        return std::nullopt;
    const Vec3 p = track_.at(most.t);
    const double least = std::max(kFlat, 4.0 * most.mm);
    const bool is_at_end = norm(p - track_.at(0.0)) < least || norm(p - track_.at(1.0)) < least;
    return is_at_end ? std::nullopt : std::optional(most.t);
}

double EdgeDeviation::from_forms(Vec3 p) const {
    double most = 0.0;
    for (const Form* form : forms_)
        most = std::max(most, std::abs(distance(*form, p)));
    return most;
}

EdgeDeviation::Maximum EdgeDeviation::largest_of(double from, double to, std::size_t parts) const {
    Maximum largest{from, 0.0, (to - from) / static_cast<double>(parts)};
    for (std::size_t i = 0; i <= parts; ++i) {
        const double t = from + static_cast<double>(i) * largest.step;
        if (const double mm = at(t); mm > largest.mm) {
            largest.t = t;
            largest.mm = mm;
        }
    }
    return largest;
}

EdgeDeviation::Maximum EdgeDeviation::maximum() const {
    std::vector<Maximum> peaks;
    double least = 0.0;  // Smaller peaks are not refined.
    const auto add_peaks = [&](double from, double to, std::size_t parts) {
        const double step = (to - from) / static_cast<double>(parts);
        double before = 0.0, here = at(from);
        for (std::size_t i = 0; i <= parts; ++i) {
            const double t = from + static_cast<double>(i) * step;
            const double after = i < parts ? at(t + step) : 0.0;
            if (here >= before && here >= after && here >= least) {
                peaks.push_back({t, here, step});
                least = std::max(least, 0.8 * here);
            }
            before = std::exchange(here, after);
        }
    };
    // Each piece of a curve or of a patch may have separate maxima.
    add_peaks(0.0, 1.0, 200);
    for (std::size_t i = 0; i < track_.pieces(); ++i)
        add_peaks(track_.start_of(i), track_.start_of(i + 1), 8);
    for (const auto& [surface, curve] : in_parameters_) {
        const auto& knots = curve->knots;
        const auto share = [&](double knot) {
            return (knot - knots.front()) / (knots.back() - knots.front());
        };
        for (std::size_t i = 1; i < knots.size(); ++i)
            add_peaks(share(knots[i - 1]), share(knots[i]), 16);
    }
    Maximum most;
    for (const Maximum& peak : peaks) {
        if (peak.mm < least) continue;
        if (const Maximum top = climb(peak); top.mm > most.mm) most = top;
    }
    return most;
}

// Refines a maximum: moves to the greater of both neighbours, and halves the step if there is none.
EdgeDeviation::Maximum EdgeDeviation::climb(Maximum from) const {
    for (; from.step > kRounding; from.step *= 0.5) {
        for (const double t : {from.t - from.step, from.t + from.step}) {
            const double mm = t >= 0.0 && t <= 1.0 ? at(t) : 0.0;
            if (mm > from.mm) from = {t, mm, from.step};
        }
    }
    return from;
}

}  // namespace ncsim::brep
