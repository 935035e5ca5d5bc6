// SPDX-License-Identifier: GPL-3.0-or-later
//
// 1. Find the extent of the face. 2. At each knot, compute the point, both derivatives and the
// mixed derivative by differences; cubic (Ferguson) patches between the knots form a smooth spline.
// 3. Scale the pieces so that the cubics meet the surface in their middles, as cubics for arcs do.
// 4. Where the patch is too far off between knots, add a knot around or along, and repeat from 2.
#include "topology/envelope_patch.h"

#include "ncsim/base/angles.h"

#include "geometry/tolerances.h"
#include "topology/angular_extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ncsim::brep {

namespace {

// Point of the spline, with derivatives.
struct Bent {
    Vec3 at, around, along, both;
};

constexpr int kStepsAway = 2;
// Returns the derivative from points at 1 and 2 steps, exact for polynomials of degree 4.
template <typename At>
Vec3 slope_of(const At& steps_away, double step) {
    return (1.0 / (12.0 * step)) *
           (8.0 * (steps_away(1) - steps_away(-1)) - (steps_away(2) - steps_away(-2)));
}

class PatchMaker {
public:
    PatchMaker(const Envelope& envelope, std::vector<double> around, std::vector<double> along)
        : sweep_(*envelope.sweep),
          envelope_(envelope),
          around_(std::move(around)),
          along_(std::move(along)),
          step_around_(1e-4 * (around_.back() - around_.front())),
          step_along_(1e-4 * (along_.back() - along_.front())) {}

    Patch make() {
        bend();
        for (int pass = 0; pass < 12 && refine(); ++pass)
            bend();
        return patch();
    }

private:
    // Tool positions at a time, and at steps before and after.
    using ToolFrames = std::array<ToolFrame, 2 * kStepsAway + 1>;
    static std::size_t index_of(int step) { return static_cast<std::size_t>(step) + kStepsAway; }
    ToolFrames tool_frames_at(double t) const {
        ToolFrames tool_frames;
        for (int i = -kStepsAway; i <= kStepsAway; ++i)
            tool_frames[index_of(i)] = sweep_.at(t + i * step_along_);
        return tool_frames;
    }

    Bent bent(double across, const ToolFrames& tool_frames) const {
        const auto point = [&](int ahead, int cross_step) {
            return point_across(sweep_, tool_frames[index_of(ahead)],
                                across + cross_step * step_around_);
        };
        const auto on_way = [&](int ahead) { return point(ahead, 0); };
        const auto slope_around = [&](int ahead) {
            return slope_of([&](int cross_step) { return point(ahead, cross_step); }, step_around_);
        };
        return {point(0, 0), slope_around(0), slope_of(on_way, step_along_),
                slope_of(slope_around, step_along_)};
    }

    void bend() {
        std::vector<ToolFrames> tool_frames;
        for (const double t : along_)
            tool_frames.push_back(tool_frames_at(t));
        knots_.clear();
        for (const double across : around_) {
            for (const ToolFrames& here : tool_frames)
                knots_.push_back(bent(across, here));
        }
        share_around_.assign(around_.size() - 1, 1.0);
        share_along_.assign(along_.size() - 1, 1.0);
        for (std::size_t i = 0; i + 1 < around_.size(); ++i) {
            Middle middle;
            for (std::size_t j = 0; j + 1 < along_.size(); ++j) {
                const Vec3 bow = knot(i, j).around - knot(i + 1, j).around;
                middle.take(closest(i, j, 0.5, 0.0), (0.125 * (around_[i + 1] - around_[i])) * bow);
            }
            share_around_[i] = middle.share();
        }
        for (std::size_t j = 0; j + 1 < along_.size(); ++j) {
            Middle middle;
            for (std::size_t i = 0; i + 1 < around_.size(); ++i) {
                const Vec3 bow = knot(i, j).along - knot(i, j + 1).along;
                middle.take(closest(i, j, 0.0, 0.5), (0.125 * (along_[j + 1] - along_[j])) * bow);
            }
            share_along_[j] = middle.share();
        }
    }

    // Factor by which pieces are scaled to meet the surface in their middles, by least squares.
    struct Middle {
        void take(const ClosestPoint& closest, Vec3 bow) {
            const double out = dot(closest.normal, bow);
            deviation += closest.deviation * out;
            square += out * out;
        }
        double share() const {
            return square > kUnitRounding ? 1.0 - std::clamp(deviation / square, -0.2, 0.2) : 1.0;
        }
        double deviation = 0.0, square = 0.0;
    };
    double width(std::size_t i) const { return share_around_[i] * (around_[i + 1] - around_[i]); }
    double length(std::size_t j) const { return share_along_[j] * (along_[j + 1] - along_[j]); }

    const Bent& knot(std::size_t i, std::size_t j) const { return knots_[i * along_.size() + j]; }

    // Returns the point between knots i and i + 1, j and j + 1; u and v from 0 to 1.
    Vec3 at(std::size_t i, std::size_t j, double u, double v) const {
        const auto weights = [](double x, double size) {
            const double y = 1.0 - x;
            return std::array{y * y * (1.0 + 2.0 * x), x * x * (3.0 - 2.0 * x), size * x * y * y,
                              -size * x * x * y};
        };
        const auto a = weights(u, width(i)), b = weights(v, length(j));
        Vec3 sum;
        for (std::size_t k = 0; k < 2; ++k) {
            for (std::size_t l = 0; l < 2; ++l) {
                const Bent& c = knot(i + k, j + l);
                sum = sum + (a[k] * b[l]) * c.at + (a[k + 2] * b[l]) * c.around +
                      (a[k] * b[l + 2]) * c.along + (a[k + 2] * b[l + 2]) * c.both;
            }
        }
        return sum;
    }

    // Returns the closest point of the patch's point, near the time of the adjacent knots.
    ClosestPoint closest(std::size_t i, std::size_t j, double u, double v) const {
        const double time = along_[j] + v * (along_[j + 1] - along_[j]);
        return project_onto(envelope_, at(i, j, u, v), time);
    }
    double deviation(std::size_t i, std::size_t j, double u, double v) const {
        return std::abs(closest(i, j, u, v).deviation);
    }

    // Adds a knot in the middle of pieces that are too far off, in both directions. Returns true if
    // a knot was added.
    bool refine() {
        const double most = 0.3 * kReaderMm;
        std::vector<bool> wide(around_.size(), false), lengthy(along_.size(), false);
        for (std::size_t i = 0; i + 1 < around_.size(); ++i) {
            for (std::size_t j = 0; j + 1 < along_.size(); ++j) {
                double across = 0.0, ahead = 0.0, inside = 0.0;
                for (const double x : {0.25, 0.5, 0.75}) {
                    across = std::max({across, deviation(i, j, x, 0.0), deviation(i, j, x, 1.0)});
                    ahead = std::max({ahead, deviation(i, j, 0.0, x), deviation(i, j, 1.0, x)});
                    inside = std::max({inside, deviation(i, j, x, 0.5), deviation(i, j, 0.5, x)});
                }
                if (std::max({across, ahead, inside}) <= most) continue;
                wide[i] = wide[i] || across > most || across >= ahead;
                lengthy[j] = lengthy[j] || ahead > most || ahead > across;
            }
        }
        const bool more_around = halve(around_, wide);
        return halve(along_, lengthy) || more_around;
    }

    static bool halve(std::vector<double>& knots, const std::vector<bool>& which) {
        std::vector<double> finer;
        for (std::size_t i = 0; i < knots.size(); ++i) {
            finer.push_back(knots[i]);
            if (which[i]) finer.push_back(0.5 * (knots[i] + knots[i + 1]));
        }
        if (finer.size() == knots.size() || finer.size() > 400) return false;
        knots = std::move(finer);
        return true;
    }

    // Returns the patch. A cubic with given end derivatives has control points at a third of the
    // derivatives from the ends.
    Patch patch() const {
        std::vector<double> widths, lengths;
        for (std::size_t i = 0; i + 1 < around_.size(); ++i)
            widths.push_back(width(i));
        for (std::size_t j = 0; j + 1 < along_.size(); ++j)
            lengths.push_back(length(j));
        // Offsets to the control points before and after a knot; at the ends, a control point
        // coincides with the knot.
        const auto thirds = [](const std::vector<double>& pieces, std::size_t i) {
            return std::array{i > 0 ? -pieces[i - 1] / 3.0 : 0.0,
                              i < pieces.size() ? pieces[i] / 3.0 : 0.0};
        };
        Patch patch{{}, sums_of(widths), sums_of(lengths)};
        for (std::size_t i = 0; i < around_.size(); ++i) {
            for (const double u : thirds(widths, i)) {
                auto& row = patch.net.emplace_back();
                for (std::size_t j = 0; j < along_.size(); ++j) {
                    const Bent& k = knot(i, j);
                    for (const double v : thirds(lengths, j))
                        row.push_back(k.at + u * k.around + v * k.along + (u * v) * k.both);
                }
            }
        }
        return patch;
    }

    static std::vector<double> sums_of(const std::vector<double>& pieces) {
        std::vector<double> knots{0.0};
        for (const double piece : pieces)
            knots.push_back(knots.back() + piece);
        return knots;
    }

    const Sweep& sweep_;
    Envelope envelope_;
    std::vector<double> around_, along_;  // Coordinates of place_across(); t.
    double step_around_, step_along_;
    std::vector<Bent> knots_;
    std::vector<double> share_around_, share_along_;  // Scale factors of pieces.
};

std::vector<double> evenly(double from, double to, double piece) {
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / piece)));
    std::vector<double> knots;
    knots.reserve(static_cast<std::size_t>(pieces) + 1);
    for (int i = 0; i < pieces; ++i)
        knots.push_back(from + i * ((to - from) / pieces));
    knots.push_back(to);
    return knots;
}

}  // namespace

Patch patch_of_envelope(const Part& part, const Face& face, const Envelope& envelope) {
    const Sweep& sweep = *envelope.sweep;
    double first = 1e9, last = -1e9, begin = 1e9, end = -1e9;
    for (const auto& points : points_along(part, face)) {
        ProjectionSeed seed;
        for (const Vec3& p : points) {
            const ClosestPoint closest = project_onto(envelope, p, seed);
            const double across = place_across(sweep, closest.tool, p);
            first = std::min(first, across);
            last = std::max(last, across);
            begin = std::min(begin, closest.t);
            end = std::max(end, closest.t);
        }
    }
    const double beyond = 0.02 * std::max(end - begin, 0.02);
    const double from = begin - beyond, to = end + beyond;
    const bool is_straight = std::holds_alternative<StraightPath>(sweep.path());
    const double piece = 4.0 / static_cast<double>(sweep.samples().size() - 1);
    const auto along = evenly(from, to, is_straight ? to - from : piece);
    if (sweep.flank()) {
        const double margin = 0.02 * (last - first) + 0.02;
        const double low = first - margin, high = last + margin;
        return PatchMaker(envelope, evenly(low, high, high - low), along).make();
    }
    const double low = std::max(0.0, first - 4.0);
    const double high = std::min(kTurnDegrees, last + 4.0);
    return PatchMaker(envelope, evenly(low, high, 15.0), along).make();
}

}  // namespace ncsim::brep
