// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve in the parameters of a surface interpolates the places of points of the edge and their
// derivatives; pieces are halved until the curve is near enough.
#include "ncsim/brep/parameter_curve.h"

#include "ncsim/base/angles.h"
#include "ncsim/brep/frames.h"

#include "geometry/spline_surface.h"
#include "geometry/tolerances.h"
#include "topology/divided_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <variant>

namespace ncsim::brep {

namespace {

constexpr double kTurn = kTurnDegrees * kRadiansPerDegree;

double angle_rad(double x, double y) {
    return angle_of(x, y) * kRadiansPerDegree;
}

// Returns the factors of `u` and `v` in the projection of `w` on the plane of `u` and `v`. If `u`
// and `v` are parallel: the smallest factors if `any`, otherwise no value.
std::optional<Vec2> components(Vec3 u, Vec3 v, Vec3 w, bool any) {
    double uu = dot(u, u), vv = dot(v, v);
    const double uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
    if (!(uu * vv - uv * uv > kParallelAngle * kParallelAngle * uu * vv)) {
        if (!any) return std::nullopt;
        uu += kRounding * (uu + vv);
        vv += kRounding * (uu + vv);
    }
    const double det = uu * vv - uv * uv;
    if (!(det > 0.0)) return std::nullopt;
    return Vec2{(vv * uw - uv * vw) / det, (uu * vw - uv * uw) / det};
}

}  // namespace

// A circle in a file may miss the ends of the edge; the track contains both ends.
Vec3 point_in_file(const Track& track, Vec3 p) {
    const Circle* circle = track.circle();
    if (!circle) return p;
    return circle->centre + circle->radius * normalized(p - circle->centre);
}

// Edge with the parameter of the edge's curve in a file. Curves in parameters end in the corners,
// because CAD readers join curves there.
class ParameterSurface::FileCurve {
public:
    FileCurve(const Part& part, const Edge& edge)
        : track_(edge.curve, part.vertices[edge.from], part.vertices[edge.to]) {
        if (const auto* spline = std::get_if<Spline>(&edge.curve)) {
            begin_ = spline->knots.front();
            length_ = spline->knots.back() - begin_;
        } else if (track_.is_straight()) {
            length_ = norm(part.vertices[edge.to] - part.vertices[edge.from]);
        } else {
            begin_ = track_.start_degrees() * kRadiansPerDegree;
            // CAD readers begin at 0, not at a whole turn, if both differ by rounding.
            if (begin_ < -kRounding) begin_ += kTurn;
            if (begin_ > kTurn - kRounding) begin_ -= kTurn;
            length_ = track_.sweep_degrees() * kRadiansPerDegree;
        }
    }

    // Returns the parameter at which the rest of the edge begins if the rest is a separate edge.
    double begin_of_rest(double at) const {
        const double begin = begin_ + at * length_;
        if (!track_.is_ellipse()) return 0.0;
        return begin > kTurn - kRounding ? begin - kTurn : begin;
    }

    std::vector<double> breaks() const {
        std::vector<double> result;
        for (std::size_t i = 0; i <= track_.pieces(); ++i)
            result.push_back(begin_ + length_ * track_.start_of(i));
        return result;
    }
    // Returns point and derivative by the parameter.
    Track::Step at(double t) const {
        Track::Step step = track_.step(std::clamp((t - begin_) / length_, 0.0, 1.0));
        step.derivative = (1.0 / length_) * step.derivative;
        return step;
    }

private:
    Track track_;
    double begin_ = 0.0, length_ = 0.0;
};

std::optional<ParameterSurface> ParameterSurface::of(const Part& part, const Face& face,
                                                     std::shared_ptr<const Patch> patch) {
    const Form& form = face.surface.form;
    if (std::holds_alternative<Plane>(form)) return std::nullopt;
    Frame frame = frame_in_file(part, face);
    const auto half = half_of_ramp(part, face);
    if (half) {
        const auto& ramp = std::get<Extrusion>(form);
        frame = {ramp.centre, ramp.axis, -cross(ramp.axis, *half)};
    }
    return ParameterSurface(form, frame, std::move(patch), half.has_value());
}

ParameterSurface::Point ParameterSurface::point(Place place) const {
    if (patch_) {
        const PatchPoint p = point_of(*patch_, place[0], place[1]);
        return {p.at, p.by_around, p.by_along};
    }
    const Vec3 x = frame_.x, z = frame_.axis, y = cross(z, x);
    if (is_half_) return point_of_half(place);
    const auto u = sin_cos(place[0] / kRadiansPerDegree);
    const Vec3 out = u.cos * x + u.sin * y, on = u.cos * y - u.sin * x;
    const auto turned = [&](double radius, double height, double radius_by_v, double height_by_v) {
        return Point{frame_.origin + radius * out + height * z, radius * on,
                     radius_by_v * out + height_by_v * z};
    };
    if (const auto* form = std::get_if<Cylinder>(&form_))
        return turned(form->radius, place[1], 0.0, 1.0);
    if (const auto* form = std::get_if<Cone>(&form_)) {
        const double height = dot(frame_.origin - form->apex, form->axis);
        return turned(form->slope * (height + place[1]), place[1], form->slope, 1.0);
    }
    if (const auto* form = std::get_if<Extrusion>(&form_))
        return {frame_.origin + form->radius * out + place[1] * form->along, form->radius * on,
                form->along};
    const double degrees = place[1] / kRadiansPerDegree;
    if (const auto* form = std::get_if<Sphere>(&form_)) {
        const auto v = sin_cos(degrees);
        const double r = form->radius;
        return turned(r * v.cos, r * v.sin, -r * v.sin, r * v.cos);
    }
    const auto& torus = std::get<Torus>(form_);
    const auto v = sin_cos(is_spindle(torus) ? degrees + tip_degrees(torus) : degrees);
    return turned(torus.major + torus.minor * v.cos, torus.minor * v.sin, -torus.minor * v.sin,
                  torus.minor * v.cos);
}

// The file has half of a circle as a rational cubic: the tangent of half the angle is u / (1 - u).
ParameterSurface::Point ParameterSurface::point_of_half(Place place) const {
    const auto& ramp = std::get<Extrusion>(form_);
    const Vec3 y = cross(frame_.axis, frame_.x);
    const double u = place[0], w = 1.0 - u, square = u * u + w * w;
    const double cosine = (w * w - u * u) / square, sine = 2.0 * u * w / square;
    return {frame_.origin + ramp.radius * (cosine * frame_.x + sine * y) + place[1] * ramp.along,
            (2.0 * ramp.radius / square) * (cosine * y - sine * frame_.x), ramp.along};
}

// Limits: on cones, lines of CAD readers end elsewhere; on patches, a point farther off may have
// several nearest points.
double ParameterSurface::farthest() const {
    if (patch_) return 10.0 * kPointError;
    return std::holds_alternative<Cone>(form_) ? 2.0 * kPointError : kTangencyGapMm;
}

// Searches from the four nearest knots, because steps from the nearest knot may miss the place if
// parameter lines touch.
std::optional<ParameterSurface::Place> ParameterSurface::place_on_patch(Vec3 p) const {
    std::vector<std::pair<double, Place>> knots;
    knots.reserve(patch_->around.size() * patch_->along.size());
    for (const double u : patch_->around) {
        for (const double v : patch_->along)
            knots.emplace_back(norm(point({u, v}).at - p), Place{u, v});
    }
    const auto nearer = [](const auto& a, const auto& b) { return a.first < b.first; };
    const auto last = knots.begin() + std::min<std::ptrdiff_t>(4, std::ssize(knots));
    std::ranges::partial_sort(knots, last, nearer);
    std::optional<Place> best;
    double nearest = std::numeric_limits<double>::infinity();
    for (auto knot = knots.begin(); knot != last && nearest > farthest(); ++knot) {
        const auto found = place(p, knot->second);
        const double away = found ? norm(point(*found).at - p) : nearest;
        if (!found || away >= nearest) continue;
        nearest = away;
        best = found;
    }
    return best;
}

std::optional<ParameterSurface::Place> ParameterSurface::first_place(Vec3 p) const {
    if (patch_) return place_on_patch(p);
    Vec3 at = p - frame_.origin;
    double along = dot(at, frame_.axis);
    if (const auto* form = std::get_if<Extrusion>(&form_)) {
        along /= dot(form->along, form->axis);
        at = at - along * form->along;
    }
    const double x = dot(at, frame_.x), y = dot(at, cross(frame_.axis, frame_.x));
    const double radius = std::sqrt(x * x + y * y);
    if (radius < kLeastSizeMm) return std::nullopt;  // The angle is undetermined.
    if (is_half_) {
        const auto half = sin_cos(0.5 * angle_of(x, y));
        return Place{half.sin / (half.sin + half.cos), along};
    }
    double u = angle_rad(x, y);
    if (u < 0.0) u += kTurn;
    if (std::holds_alternative<Sphere>(form_)) return Place{u, angle_rad(radius, along)};
    // The foot of the perpendicular, because CAD readers project in this way.
    if (const auto* cone = std::get_if<Cone>(&form_)) {
        const double height = dot(frame_.origin - cone->apex, cone->axis);
        const double slope = cone->slope;
        along = (height + along + slope * radius) / (1.0 + slope * slope) - height;
    }
    if (const auto* torus = std::get_if<Torus>(&form_)) {
        double v = angle_rad(radius - torus->major, along);
        if (is_spindle(*torus)) v -= tip_degrees(*torus) * kRadiansPerDegree;
        return Place{u, v < 0.0 ? v + kTurn : v};
    }
    return Place{u, along};
}

std::optional<ParameterSurface::Place> ParameterSurface::place(Vec3 p, Place nearby) const {
    if (!patch_) {
        auto found = first_place(p);
        if (!found || is_half_) return found;
        const std::size_t angles =
            std::holds_alternative<Sphere>(form_) || std::holds_alternative<Torus>(form_) ? 2 : 1;
        for (std::size_t k = 0; k < angles; ++k)
            (*found)[k] -= kTurn * std::round(((*found)[k] - nearby[k]) / kTurn);
        return found;
    }
    const std::array low{patch_->around.front(), patch_->along.front()};
    const std::array high{patch_->around.back(), patch_->along.back()};
    Place at = nearby;
    for (int i = 0; i < kMostSteps / 2; ++i) {
        const Point s = point(at);
        auto step = components(s.by_u, s.by_v, p - s.at, true);
        if (!step) return std::nullopt;
        // At an end of the patch, the step along the end.
        for (std::size_t k = 0; k < 2; ++k) {
            const bool is_outward = (*step)[k] < 0.0 ? at[k] <= low[k] : at[k] >= high[k];
            if (!is_outward) continue;
            const Vec3 along = k == 0 ? s.by_v : s.by_u;
            (*step)[k] = 0.0;
            (*step)[1 - k] = dot(along, p - s.at) / dot(along, along);
            break;
        }
        const Place before = at;
        for (std::size_t k = 0; k < 2; ++k)
            at[k] = std::clamp(at[k] + (*step)[k], low[k], high[k]);
        if (std::abs(at[0] - before[0]) + std::abs(at[1] - before[1]) <
            0.1 * kUnitRounding * (1.0 + std::abs(at[0]) + std::abs(at[1])))
            break;
    }
    return at;
}

// Interpolation of an edge in the parameters of a surface.
class ParameterSurface::Fitter {
public:
    Fitter(const ParameterSurface& surface, const FileCurve& curve)
        : surface_(surface), curve_(curve) {}

    std::optional<ParameterCurve> fit() {
        const std::vector<double> breaks = curve_.breaks();
        const auto first = surface_.first_place(curve_.at(breaks.front()).at);
        if (!first) return std::nullopt;
        const auto last = node_at(breaks.front(), breaks[1], *first);
        if (!last) return std::nullopt;
        nodes_.push_back(*last);
        for (std::size_t i = 1; i < breaks.size(); ++i) {
            if (!add_piece(breaks[i], 14)) return std::nullopt;
        }
        ParameterCurve result;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const Node& node = nodes_[i];
            const auto handle = [&](double width) { return node.at + width / 3.0 * node.slope; };
            result.points.push_back(i == 0 ? node.at : handle(nodes_[i - 1].t - node.t));
            result.points.push_back(i + 1 == nodes_.size() ? node.at
                                                           : handle(nodes_[i + 1].t - node.t));
            result.knots.push_back(node.t);
        }
        result.miss_mm = miss_mm_;
        return result;
    }

private:
    struct Node {
        double t = 0.0;
        Place at{}, slope{};
    };

    // Returns the node at `t`. In a corner where the parameter lines touch, the slope is that of
    // points towards `inside`.
    std::optional<Node> node_at(double t, double inside, Place nearby) const {
        const Vec3 p = curve_.at(t).at;
        const auto at = surface_.place(p, nearby);
        if (!at || !(norm(surface_.point(*at).at - p) <= surface_.farthest())) return std::nullopt;
        if (const auto slope = slope_at(t, *at)) return Node{t, *at, *slope};
        std::array<Place, 2> slopes{};
        for (std::size_t i = 0; i < slopes.size(); ++i) {
            const double beside = t + 1e-3 * static_cast<double>(i + 1) * (inside - t);
            const auto place = surface_.place(curve_.at(beside).at, *at);
            const auto slope = place ? slope_at(beside, *place) : std::nullopt;
            if (!slope) return std::nullopt;
            slopes[i] = *slope;
        }
        const auto& [near, far] = slopes;
        return Node{t, *at, 2.0 * near - far};
    }

    std::optional<Place> slope_at(double t, Place at) const {
        const Point point = surface_.point(at);
        return components(point.by_u, point.by_v, curve_.at(t).derivative, false);
    }

    // Adds nodes up to `t`; halves the piece at most `halvings` times. False if the curve stays too
    // far from the edge.
    bool add_piece(double t, int halvings) {
        const Node from = nodes_.back();
        const double width = t - from.t;
        const auto to = node_at(t, from.t, from.at + width * from.slope);
        if (to && is_near(from, *to)) {
            nodes_.push_back(*to);
            return true;
        }
        return halvings > 0 && add_piece(from.t + 0.5 * width, halvings - 1) &&
               add_piece(t, halvings - 1);
    }

    // True if the curve between two nodes is within 0.7 kReaderMm of the edge, or hardly farther
    // from the edge than the surface.
    bool is_near(const Node& from, const Node& to) {
        const double width = to.t - from.t;
        return std::ranges::all_of(std::array{0.2, 0.4, 0.6, 0.8}, [&](double s) {
            const double r = 1.0 - s;
            const Place at = r * r * (1.0 + 2.0 * s) * from.at + s * r * r * width * from.slope +
                             s * s * (3.0 - 2.0 * s) * to.at - s * s * r * width * to.slope;
            const Vec3 p = curve_.at(from.t + s * width).at;
            const double away = norm(surface_.point(at).at - p);
            if (away <= 0.7 * kReaderMm) return true;
            if (away > surface_.farthest()) return false;
            const auto nearest = surface_.place(p, at);
            if (!nearest) return false;
            const double least = norm(surface_.point(*nearest).at - p);
            if (away > (surface_.patch_ ? 1.5 * least : 1.0001 * least + 0.3 * kReaderMm))
                return false;
            miss_mm_ = std::max(miss_mm_, away);
            return true;
        });
    }

    const ParameterSurface& surface_;
    const FileCurve& curve_;
    std::vector<Node> nodes_;
    double miss_mm_ = 0.0;
};

Vec3 ParameterSurface::point_on(const ParameterCurve& curve, double t) const {
    const auto& k = curve.knots;
    const double place = k.front() + t * (k.back() - k.front());
    const std::size_t i = piece_at(curve, place);
    const double share = (place - k[i]) / (k[i + 1] - k[i]);
    return point(SplinePiece<ParameterCurve>(curve, i).divided(share)[3]).at;
}

double ParameterSurface::begin_of_rest(const Part& part, const Edge& edge, double at) {
    return FileCurve(part, edge).begin_of_rest(at);
}

std::optional<ParameterCurve> ParameterSurface::curve_of(const Part& part, const Edge& edge) const {
    const auto is_along = [](Vec3 a, Vec3 b) { return norm(cross(a, b)) < kRounding; };
    if (const auto* circle = std::get_if<Circle>(&edge.curve); circle && !patch_ && !is_half_) {
        const bool is_parallel = is_along(circle->axis, frame_.axis);
        const Vec3 v = circle->centre - frame_.origin;
        const bool is_about = norm(v - dot(v, frame_.axis) * frame_.axis) < kRounding;
        if (is_parallel && (is_about || std::holds_alternative<Extrusion>(form_)))
            return std::nullopt;
    }
    if (std::holds_alternative<Line>(edge.curve) && !patch_ && !is_half_) return std::nullopt;
    const FileCurve curve(part, edge);
    return Fitter(*this, curve).fit();
}

}  // namespace ncsim::brep
