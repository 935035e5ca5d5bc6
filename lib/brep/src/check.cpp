// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces are looked at on a map: each surface can be laid out flat, so that what is one face there
// is one face here, without seams. Cones are seen along their axis, strips of cylinders from in
// front; other cylinders and rings become rings of paper; of spheres the point opposite the face is
// where the map has none.
#include "ncsim/brep/check.h"

#include "ncsim/trig/angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::brep {

using trig::kRadiansPerDegree;

namespace {

using cda::cross;
using cda::dot;
using cda::norm;
using cda::normalized;

// Gauss-Legendre on (0, 1): exact for polynomials of degree 15.
constexpr std::array<double, 4> kAbscissae{0.1834346424956498, 0.5255324099163290,
                                           0.7966664774136267, 0.9602898564975363};
constexpr std::array<double, 4> kWeights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                         0.1012285362903763};

template <typename F>
void integrate(const Track& track, const F& f) {
    const std::size_t pieces = track.pieces();
    const double width = 1.0 / static_cast<double>(pieces);
    for (std::size_t i = 0; i < pieces; ++i) {
        const double middle = (static_cast<double>(i) + 0.5) * width;
        for (std::size_t k = 0; k < kAbscissae.size(); ++k) {
            for (const double sign : {-1.0, 1.0}) {
                const double t = middle + sign * 0.5 * width * kAbscissae[k];
                f(0.5 * width * kWeights[k], track.at(t), track.derivative(t));
            }
        }
    }
}

// A point in the frame of a surface of revolution.
struct Local {
    double x, y, z, away;  // away: from the axis
};

struct Axes {
    Vec3 origin, x, y, z;

    Axes(Vec3 at, const Frame& frame)
        : origin(at), x(frame.x), y(cross(frame.axis, frame.x)), z(frame.axis) {}
    Vec3 turned(Vec3 v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
    Local operator()(Vec3 p) const {
        const Vec3 v = turned(p - origin);
        return {v.x, v.y, v.z, std::sqrt(v.x * v.x + v.y * v.y)};
    }
};

// Integrals over the second parameter from a fixed start to where a point is: of the area, and of
// the volume of the cone from a point -w, in the frame of the surface, three times. What is left
// is an integral along the edges, over the angle around the axis (Green).
struct Below {
    double area = 0.0, volume = 0.0;
};

struct BelowCylinder {
    double radius;
    Vec3 w;
    Below operator()(const Local& p) const {
        const double side = radius + (w.x * p.x + w.y * p.y) / p.away;
        return {radius * p.z, radius * side * p.z};
    }
};

struct BelowCone {
    double slope;
    Vec3 w;
    Below operator()(const Local& p) const {
        const double half = 0.5 * p.z * p.z * slope;
        if (p.away <= 0.0) return {};
        return {half * std::sqrt(1.0 + slope * slope),
                half * ((w.x * p.x + w.y * p.y) / p.away - w.z * slope)};
    }
};

struct BelowSphere {
    double radius;
    Vec3 w;
    double pole;  // 1 or -1: from where on
    Below operator()(const Local& p) const {
        if (p.away <= 0.0) return {};
        const double s = p.z / radius, c = p.away / radius;
        const double angle = trig::angle_of(c, s) * kRadiansPerDegree;
        const double side = (w.x * p.x + w.y * p.y) / p.away;
        const double half_pi = pole * 0.5 * std::numbers::pi;
        const double r2 = radius * radius;
        return {r2 * (s - pole),
                r2 * (radius * (s - pole) + side * 0.5 * (angle - half_pi + s * c) +
                      0.5 * w.z * (s * s - 1.0))};
    }
};

struct BelowTorus {
    double major, minor;
    Vec3 w;
    double cut;  // degrees, where the angle around the tube jumps
    Below operator()(const Local& p) const {
        const double out = p.away - major;
        const double length = std::sqrt(out * out + p.z * p.z);
        const double s = p.z / length, c = out / length;
        double degrees = trig::angle_of(out, p.z);
        if (degrees < cut) degrees += 360.0;
        const double f = degrees * kRadiansPerDegree;
        const double a = (w.x * p.x + w.y * p.y) / p.away;
        return {minor * (major * f + minor * s),
                minor * (major * minor * f + major * (major + a) * s - major * w.z * c +
                         minor * minor * s + minor * (major + a) * 0.5 * (f + s * c) +
                         0.5 * minor * w.z * s * s)};
    }
};

template <typename Visit>
void for_edges(const Part& part, const Face& face, const Visit& visit) {
    for (const Loop& loop : face.loops) {
        for (const EdgeUse& use : loop) {
            const Edge& edge = part.edges[use.edge];
            visit(Track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]),
                  use.is_forward ? 1.0 : -1.0);
        }
    }
}

// The angle around the axis that a step makes, per its parameter.
double turn(const Local& p, Vec3 step) {
    return (p.x * step.y - p.y * step.x) / (p.away * p.away);
}

template <typename B>
Measure around(const Part& part, const Face& face, const Axes& axes, const B& below) {
    Measure sum;
    constexpr double kAtTip = 1e-12;
    for_edges(part, face, [&](const Track& track, double sign) {
        integrate(track, [&](double weight, Vec3 at, Vec3 derivative) {
            const Local p = axes(at);
            sum.length += weight * norm(derivative);
            if (p.away <= kAtTip) return;
            const double turned = sign * weight * turn(p, axes.turned(derivative));
            const Below b = below(p);
            sum.area -= turned * b.area;
            sum.volume -= turned * b.volume / 3.0;
        });
    });
    if (face.surface.is_hollow) sum.area = -sum.area;
    return sum;
}

double turns_about(const Part& part, const Face& face, const Axes& axes) {
    double sum = 0.0;
    for_edges(part, face, [&](const Track& track, double sign) {
        integrate(track, [&](double weight, Vec3 at, Vec3 derivative) {
            const Local p = axes(at);
            if (p.away > 0.0) sum += sign * weight * turn(p, axes.turned(derivative));
        });
    });
    return sum / (2.0 * std::numbers::pi);
}

// Where the face is not, on the way around the tube of a ring: in the middle of the widest gap
// between points of its edges, of those that are not between two edges with the face between them.
double cut_of(const Part& part, const Face& face, const Axes& axes, double major) {
    constexpr int kSteps = 32;
    struct Angle {
        double degrees;
        int inwards;  // which way the face goes on: 1 to greater angles, -1 to smaller ones
        bool operator<(const Angle& o) const { return degrees < o.degrees; }
    };
    std::vector<Angle> angles;
    for_edges(part, face, [&](const Track& track, double sign) {
        for (int i = 0; i <= kSteps; ++i) {
            const double t = static_cast<double>(i) / kSteps;
            const Vec3 at = track.at(t);
            const Local p = axes(at);
            const Vec3 n = outward(face.surface, at);
            const Vec3 away = (1.0 / p.away) * (p.x * axes.x + p.y * axes.y);
            const Vec3 around = p.z * away - (p.away - major) * axes.z;
            const double inwards =
                -dot(normalized(around), normalized(sign * cross(n, track.derivative(t))));
            constexpr double kAcross = 0.9;
            angles.push_back({trig::angle_of(p.away - major, p.z), inwards > kAcross    ? 1
                                                                   : inwards < -kAcross ? -1
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

Measure measure_plane(const Part& part, const Face& face, const Plane& plane, Vec3 apex) {
    Measure sum;
    Vec3 twice;
    for_edges(part, face, [&](const Track& track, double sign) {
        integrate(track, [&](double weight, Vec3 at, Vec3 derivative) {
            sum.length += weight * norm(derivative);
            twice = twice + (sign * weight) * cross(at - plane.origin, derivative);
        });
    });
    sum.area = 0.5 * dot(twice, plane.normal);
    sum.volume = sum.area * dot(plane.origin - apex, plane.normal) / 3.0;
    return sum;
}

// --- The map ------------------------------------------------------------------------------

struct Point {
    double x, y;
};

class Map {
public:
    Map(const Part& part, const Face& face)
        : form_(&face.surface.form), axes_(face.frame.origin, face.frame) {
        if (const auto* f = std::get_if<Cylinder>(form_)) {
            low_ = std::numeric_limits<double>::infinity();
            for_edges(part, face, [&](const Track& track, double) {
                for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                    const Local p = axes_(track.at(t));
                    low_ = std::min(low_, p.z);
                    // The x axis points away from the face.
                    constexpr double kSteep = 0.2;
                    faces_one_way_ = faces_one_way_ && p.x < -kSteep * p.away;
                }
            });
            low_ -= 2.0 * f->radius;
        } else if (const auto* c = std::get_if<Cone>(form_)) {
            axes_.origin = c->apex;
        } else if (const auto* s = std::get_if<Sphere>(form_)) {
            Vec3 sum;
            for_edges(part, face, [&](const Track& track, double) {
                for (const double t : {0.0, 0.25, 0.5, 0.75})
                    sum = sum + (track.at(t) - s->centre);
            });
            // Loops about in one plane: the face is on their left of two sides.
            Vec3 middle = normalized(sum);
            if (norm(sum) < 0.1 * s->radius) middle = face.frame.axis;
            axes_ = Axes(s->centre, {s->centre, middle, across(middle)});
        } else if (const auto* t = std::get_if<Torus>(form_)) {
            cut_ = cut_of(part, face, axes_, t->major);
        }
    }

    Point operator()(Vec3 at) const {
        const Local p = axes_(at);
        if (std::holds_alternative<Plane>(*form_) || std::holds_alternative<Cone>(*form_))
            return {p.x, p.y};
        if (std::holds_alternative<Cylinder>(*form_))
            return faces_one_way_ ? Point{p.y, p.z} : out(p, p.z - low_);
        if (const auto* s = std::get_if<Sphere>(form_)) {
            const double scale = 2.0 * s->radius / std::max(1e-9 * s->radius, s->radius + p.z);
            return {scale * p.x, scale * p.y};
        }
        const auto& t = std::get<Torus>(*form_);
        double degrees = trig::angle_of(p.away - t.major, p.z);
        if (degrees < cut_) degrees += 360.0;
        return out(p, t.minor * (1.0 + (degrees - cut_) * kRadiansPerDegree));
    }

    // Is what is straight straight on the map?
    bool keeps_lines() const {
        return std::holds_alternative<Plane>(*form_) || std::holds_alternative<Cone>(*form_) ||
               (std::holds_alternative<Cylinder>(*form_) && faces_one_way_);
    }

private:
    static Point out(const Local& p, double radius) {
        return {radius * p.x / p.away, radius * p.y / p.away};
    }

    const Form* form_;
    Axes axes_;
    double low_ = 0.0, cut_ = 0.0;
    bool faces_one_way_ = true;  // seen from there, nothing of it hides anything
};

struct Segment {
    Point a, b;
    std::uint64_t from, to;  // what they are called: neighbours have one in common
    const Track* track;      // of which it is the chord, between two parameters
    double begin, end;
    bool is_straight;  // on the map, too
    double off = 0.0;  // how far it may be from what it stands for
    double low() const { return std::min(a.y, b.y) - off; }
    double high() const { return std::max(a.y, b.y) + off; }
    double left() const { return std::min(a.x, b.x) - off; }
    double right() const { return std::max(a.x, b.x) + off; }
};

double turn(Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double squared_distance(Point p, const Segment& s) {
    const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
    const double length = dx * dx + dy * dy;
    double t = length > 0.0 ? ((p.x - s.a.x) * dx + (p.y - s.a.y) * dy) / length : 0.0;
    t = std::clamp(t, 0.0, 1.0);
    const double x = s.a.x + t * dx - p.x, y = s.a.y + t * dy - p.y;
    return x * x + y * y;
}

bool cross_each_other(const Segment& s, const Segment& t) {
    return (turn(s.a, s.b, t.a) > 0.0) != (turn(s.a, s.b, t.b) > 0.0) &&
           (turn(t.a, t.b, s.a) > 0.0) != (turn(t.a, t.b, s.b) > 0.0);
}

bool interfere(const Segment& s, const Segment& t, double clear) {
    const double near = clear * clear;
    // Neighbours have a point in common; what is beyond it must not lie on the other one.
    const bool joined = s.to == t.from;
    const bool joined_back = t.to == s.from;
    const bool heads = s.from == t.from;
    const bool tails = s.to == t.to;
    if (joined || joined_back || heads || tails) {
        if (joined && joined_back) return false;
        const Point& s_far = joined || tails ? s.a : s.b;
        const Point& t_far = joined || heads ? t.b : t.a;
        return squared_distance(s_far, t) < near || squared_distance(t_far, s) < near;
    }
    return cross_each_other(s, t) || squared_distance(s.a, t) < near ||
           squared_distance(s.b, t) < near || squared_distance(t.a, s) < near ||
           squared_distance(t.b, s) < near;
}

double apart(const Segment& s, const Segment& t) {
    if (cross_each_other(s, t)) return 0.0;
    return std::sqrt(std::min({squared_distance(s.a, t), squared_distance(s.b, t),
                               squared_distance(t.a, s), squared_distance(t.b, s)}));
}

// Pieces of curves without a common end: chords that come near are halved until it is clear.
bool curves_interfere(const Map& map, Segment s, Segment t, double clear, int depth) {
    if (apart(s, t) >= s.off + t.off + clear) return false;
    if (depth == 0 || s.off + t.off <= 0.25 * clear) return apart(s, t) < clear;
    if (s.off < t.off) std::swap(s, t);
    const double middle = 0.5 * (s.begin + s.end);
    const Point p = map(s.track->at(middle));
    // Of both halves of what is nearly a circle, a quarter.
    const double off = s.is_straight ? 0.0 : 0.5 * std::sqrt(squared_distance(p, s));
    Segment first = s, second = s;
    first.b = second.a = p;
    first.end = second.begin = middle;
    first.off = second.off = off;
    return curves_interfere(map, first, t, clear, depth - 1) ||
           curves_interfere(map, second, t, clear, depth - 1);
}

bool have_common_end(const Segment& s, const Segment& t) {
    return s.to == t.from || t.to == s.from || s.from == t.from || s.to == t.to;
}

bool any_interfere(const Map& map, std::vector<Segment> segments, double clear) {
    // Of a piece of 4 degrees it is a hundredth; of what the map bends more.
    constexpr double kMostOff = 0.1;
    constexpr int kDepth = 40;
    for (Segment& s : segments) {
        const double x = s.b.x - s.a.x, y = s.b.y - s.a.y;
        if (!s.is_straight) s.off = kMostOff * std::sqrt(x * x + y * y);
    }
    std::sort(segments.begin(), segments.end(),
              [](const Segment& s, const Segment& t) { return s.low() < t.low(); });
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Segment& s = segments[i];
        for (std::size_t j = i + 1; j < segments.size(); ++j) {
            const Segment& t = segments[j];
            if (t.low() > s.high() + clear) break;
            if (t.right() < s.left() - clear || t.left() > s.right() + clear) continue;
            const bool both_straight = s.is_straight && t.is_straight;
            if (both_straight || have_common_end(s, t) ? interfere(s, t, clear)
                                                       : curves_interfere(map, s, t, clear, kDepth))
                return true;
        }
    }
    return false;
}

double twice_area(const std::vector<Segment>& loop) {
    double sum = 0.0;
    for (const Segment& s : loop)
        sum += (s.a.x - loop[0].a.x) * (s.b.y - loop[0].a.y) -
               (s.a.y - loop[0].a.y) * (s.b.x - loop[0].a.x);
    return sum;
}

}  // namespace

Measure measure(const Part& part, const Face& face, Vec3 apex) {
    if (const auto* f = std::get_if<Plane>(&face.surface.form))
        return measure_plane(part, face, *f, apex);
    if (const auto* f = std::get_if<Cylinder>(&face.surface.form)) {
        const Axes axes(f->origin, face.frame);
        return around(part, face, axes, BelowCylinder{f->radius, axes.turned(f->origin - apex)});
    }
    if (const auto* f = std::get_if<Cone>(&face.surface.form)) {
        const Axes axes(f->apex, face.frame);
        return around(part, face, axes, BelowCone{f->slope, axes.turned(f->apex - apex)});
    }
    if (const auto* f = std::get_if<Sphere>(&face.surface.form)) {
        const Axes axes(f->centre, face.frame);
        const double turns = turns_about(part, face, axes);
        const double pole = (turns < -0.5) != face.surface.is_hollow ? -1.0 : 1.0;
        return around(part, face, axes,
                      BelowSphere{f->radius, axes.turned(f->centre - apex), pole});
    }
    const auto& f = std::get<Torus>(face.surface.form);
    const Axes axes(f.centre, face.frame);
    return around(part, face, axes,
                  BelowTorus{f.major, f.minor, axes.turned(f.centre - apex),
                             cut_of(part, face, axes, f.major)});
}

double volume(const Part& part) {
    double sum = 0.0;
    const auto add = [&](const Shell& shell) {
        if (shell.empty()) return;
        const Loop& loop = part.faces[shell.front()].loops.front();
        const Vec3 apex = part.vertices[part.edges[loop.front().edge].from];
        for (const std::uint32_t f : shell)
            sum += measure(part, part.faces[f], apex).volume;
    };
    for (const Solid& solid : part.solids) {
        add(solid.outside);
        for (const Shell& shell : solid.voids)
            add(shell);
    }
    return sum;
}

std::vector<Fault> faults_of(const Part& part, std::uint32_t face_number, double tolerance_mm,
                             double& miss_mm, double clear_mm) {
    const Face& face = part.faces[face_number];
    std::vector<Fault> faults;
    const auto tell = [&](std::string what) { faults.push_back({face_number, std::move(what)}); };
    const Map map(part, face);
    std::vector<Segment> all;
    int outlines = 0;
    double miss = 0.0;
    std::uint64_t inside = std::uint64_t{1} << 32;  // names of points between vertices
    std::deque<Track> tracks;
    for (const Loop& loop : face.loops) {
        std::vector<Segment> segments;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const EdgeUse& use = loop[i];
            const Edge& edge = part.edges[use.edge];
            const std::uint32_t begin = use.is_forward ? edge.from : edge.to;
            const std::uint32_t end = use.is_forward ? edge.to : edge.from;
            const EdgeUse& next = loop[(i + 1) % loop.size()];
            const Edge& after = part.edges[next.edge];
            if (end != (next.is_forward ? after.from : after.to)) tell("a loop is open");
            const Track& track =
                tracks.emplace_back(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
            const bool is_straight = std::holds_alternative<Line>(edge.curve);
            const std::size_t steps = is_straight ? 4 : 4 * track.pieces();
            if (!(norm(track.at(1.0) - part.vertices[edge.to]) <= tolerance_mm) ||
                !(norm(track.at(0.0) - part.vertices[edge.from]) <= tolerance_mm))
                tell("a curve misses its end");
            Vec3 last = part.vertices[begin];
            std::uint64_t last_name = begin;
            double last_at = 0.0;
            for (std::size_t k = 0; k <= steps; ++k) {
                const double t = static_cast<double>(k) / static_cast<double>(steps);
                const double at = use.is_forward ? t : 1.0 - t;
                Vec3 p = track.at(at);
                if (k == steps) p = part.vertices[end];
                miss = std::max(miss, std::abs(distance(face.surface.form, p)));
                if (const auto* cone = std::get_if<Cone>(&face.surface.form);
                    cone && dot(p - cone->apex, cone->axis) < -tolerance_mm) {
                    tell("an edge is beyond the apex");
                }
                if (k > 0) {
                    const std::uint64_t name = k == steps ? end : ++inside;
                    segments.push_back({map(last), map(p), last_name, name, &track, last_at, at,
                                        is_straight && map.keeps_lines()});
                    last_name = name;
                }
                last = p;
                last_at = at;
            }
        }
        if (twice_area(segments) > 0.0) ++outlines;
        all.insert(all.end(), segments.begin(), segments.end());
    }
    miss_mm = std::max(miss_mm, miss);
    if (miss > tolerance_mm) tell("an edge is off the surface");
    if (std::holds_alternative<Plane>(face.surface.form) && outlines != 1)
        tell("it has not one outline");
    if (measure(part, face, face.frame.origin).area <= 0.0) tell("it has no area");
    if (any_interfere(map, std::move(all), clear_mm)) tell("its loops cross or touch");
    return faults;
}

std::vector<Fault> check(Part& part, double tolerance_mm) {
    std::vector<Fault> faults;
    std::vector<int> uses(part.edges.size(), 0), sum(part.edges.size(), 0);
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        for (const Loop& loop : part.faces[f].loops) {
            for (const EdgeUse& use : loop) {
                ++uses[use.edge];
                sum[use.edge] += use.is_forward ? 1 : -1;
            }
        }
        const auto more = faults_of(part, f, tolerance_mm, part.miss_mm);
        faults.insert(faults.end(), more.begin(), more.end());
    }
    for (std::size_t e = 0; e < uses.size(); ++e) {
        if (uses[e] != 0 && (uses[e] != 2 || sum[e] != 0)) faults.push_back({0, "it is open"});
    }
    return faults;
}

}  // namespace ncsim::brep
