// SPDX-License-Identifier: GPL-3.0-or-later
//
// Approximation of splines by biarcs, with bisection until the tolerance is met.
#include "ncsim/toolpath/spline_arcs.h"

#include "ncsim/base/angles.h"
#include "ncsim/toolpath/tool_pose.h"

#include "motion/axis_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace ncsim::toolpath {

namespace {

// Radius, mm, above which an arc counts as a line.
constexpr double kStraight = 1e5;

Vec3 left_normal(Vec3 v) {
    return {-v.y, v.x, 0.0};
}

using Biarc = std::array<SplinePiece, 2>;

// A point of the curve and the curve's direction there.
struct Place {
    double u;
    Vec3 at, direction;
};

class ArcFitter {
public:
    ArcFitter(const gcode::Spline& spline, double tolerance_mm)
        : curve_(spline), tolerance_(tolerance_mm) {}

    std::vector<SplinePiece> fit() {
        if (!curve_.is_sound()) return {};
        const std::vector<double> breaks = curve_.breaks();
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
            const double width = breaks[i + 1] - breaks[i];
            const auto from = place(breaks[i], width), to = place(breaks[i + 1], -width);
            if (!from || !to || !fit(*from, *to, 0)) return {};
        }
        return std::move(pieces_);
    }

private:
    Vec3 at(double u) const { return linear_axes(curve_.at(u)); }

    // Returns the point at `u` and the direction towards the side of `aside`; the curve has no
    // corner between `u` and u + `aside`. The differences are exact for polynomials of degree 4.
    // Empty if the curve stands still there.
    std::optional<Place> place(double u, double aside) const {
        const double step = 1e-3 * aside;
        const Vec3 d = -25.0 * at(u) + 48.0 * at(u + step) - 36.0 * at(u + 2.0 * step) +
                       16.0 * at(u + 3.0 * step) - 3.0 * at(u + 4.0 * step);
        constexpr double kStill = 1e-9;  // mm
        if (norm(d) <= kStill) return std::nullopt;
        return Place{u, at(u), normalized(aside > 0.0 ? d : -d)};
    }

    bool fit(const Place& from, const Place& to, int depth) {
        constexpr int kMostDepth = 12;
        constexpr std::size_t kMostPieces = 4096;
        if (pieces_.size() > kMostPieces) return false;
        if (const auto pair = biarc(from, to); pair && is_near(*pair, from, to)) {
            for (const SplinePiece& piece : *pair)
                add(piece);
            return true;
        }
        if (depth == kMostDepth) return false;
        const double middle = 0.5 * (from.u + to.u);
        const auto between = place(middle, 0.5 * (to.u - from.u));
        return between && fit(from, *between, depth + 1) && fit(*between, to, depth + 1);
    }

    // Returns two arcs with a common tangent. The tangents at both ends have the same length.
    static std::optional<Biarc> biarc(const Place& from, const Place& to) {
        const Vec3 chord = to.at - from.at;
        const double square = dot(chord, chord);
        if (!(square > 0.0)) return std::nullopt;
        const double along = dot(chord, from.direction + to.direction);
        const double apart = 2.0 * (1.0 - dot(from.direction, to.direction));
        constexpr double kParallel = 1e-12;
        if (apart <= kParallel && along <= 0.0) return std::nullopt;
        const double far = apart <= kParallel
                               ? 0.5 * square / along
                               : (std::sqrt(along * along + apart * square) - along) / apart;
        const Vec3 joint = 0.5 * (from.at + to.at + far * (from.direction - to.direction));
        const auto first = arc(from.at, joint, from.direction, from.at);
        const auto second = arc(joint, to.at, to.direction, to.at);
        if (!first || !second) return std::nullopt;
        return Biarc{*first, *second};
    }

    // Returns the line or arc with the direction `direction` at `end`, which is `from` or `to`.
    static std::optional<SplinePiece> arc(Vec3 from, Vec3 to, Vec3 direction, Vec3 end) {
        SplinePiece piece{from, to, {}, 0.0, 0.0, true};
        const Vec3 chord = to - from, left = left_normal(direction);
        const double square = dot(chord, chord);
        // Both ends of an arc are on the same side of the tangent at the first end.
        const double aside = dot(left, end == from ? chord : -chord);
        if (!(square > 0.0) || square >= 2.0 * kStraight * std::abs(aside)) {
            return dot(chord, direction) > 0.0 ? std::optional(piece) : std::nullopt;
        }
        const double signed_radius = 0.5 * square / aside;
        piece.centre = end + signed_radius * left;
        piece.radius = std::abs(signed_radius);
        const Vec3 start = from - piece.centre, stop = to - piece.centre;
        double degrees = angle_of(dot(stop, start), dot(stop, left_normal(start)));
        if (signed_radius > 0.0 && degrees < 0.0) degrees += 360.0;
        if (signed_radius < 0.0 && degrees > 0.0) degrees -= 360.0;
        piece.swept_degrees = degrees;
        constexpr double kMost = 180.0;
        return std::abs(degrees) < kMost ? std::optional(piece) : std::nullopt;
    }

    bool is_near(const Biarc& pair, const Place& from, const Place& to) const {
        constexpr int kSamples = 16;
        for (int i = 0; i < kSamples; ++i) {
            const Vec3 p = at(lerp(from.u, to.u, (i + 0.5) / kSamples));
            if (!(std::min(distance_from(pair[0], p), distance_from(pair[1], p)) <= tolerance_))
                return false;
        }
        return true;
    }

    static double distance_from(const SplinePiece& piece, Vec3 p) {
        const Vec3 chord = piece.to - piece.from;
        if (piece.radius > 0.0) {
            const Vec3 middle = 0.5 * (piece.from + piece.to) - piece.centre, v = p - piece.centre;
            const Vec3 half = piece.from - piece.centre;
            const double least = dot(half, middle) / norm(middle);
            // Beyond its ends, the distance from the nearer end counts.
            if (dot(v, middle) / norm(middle) >= least - 1e-3 * piece.radius)
                return std::abs(norm(v) - piece.radius);
        } else if (const double square = dot(chord, chord); square > 0.0) {
            const double t = std::clamp(dot(p - piece.from, chord) / square, 0.0, 1.0);
            return norm(p - piece.from - t * chord);
        }
        return std::min(norm(p - piece.from), norm(p - piece.to));
    }

    void add(SplinePiece piece) {
        constexpr double kSame = 1e-6;
        if (!(norm(piece.to - piece.from) > 0.0)) return;
        if (!pieces_.empty())
            piece.begins_in_corner = norm(start_of(piece) - end_of(pieces_.back())) > kSame;
        pieces_.push_back(piece);
    }
    static Vec3 direction_at(const SplinePiece& piece, Vec3 p) {
        if (!(piece.radius > 0.0)) return normalized(piece.to - piece.from);
        const Vec3 left = (1.0 / piece.radius) * left_normal(p - piece.centre);
        return piece.swept_degrees > 0.0 ? left : -left;
    }
    static Vec3 start_of(const SplinePiece& piece) { return direction_at(piece, piece.from); }
    static Vec3 end_of(const SplinePiece& piece) { return direction_at(piece, piece.to); }

    SplineCurve curve_;
    double tolerance_;
    std::vector<SplinePiece> pieces_;
};

}  // namespace

std::vector<SplinePiece> arcs_of(const gcode::Spline& spline, double tolerance_mm) {
    return ArcFitter(spline, tolerance_mm).fit();
}

}  // namespace ncsim::toolpath
