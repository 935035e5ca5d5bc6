// SPDX-License-Identifier: GPL-3.0-or-later
//
// 1. Find where edges pass through the plane, lifted slightly so that faces in the plane are below.
// 2. On each face, connect each crossing where an edge descends with the next crossing where an
// edge rises; a face without crossings may have a closed curve. 3. Join the pieces: each crossing
// is the start of a piece and the end of a piece.
#include "ncsim/brep/section.h"

#include "ncsim/base/angles.h"
#include "ncsim/base/number_text.h"

#include "geometry/cut_walk.h"
#include "geometry/no_index.h"
#include "geometry/plane_cut.h"
#include "geometry/tolerances.h"
#include "topology/crossings.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ncsim::brep {

namespace {

// --- The drawing --------------------------------------------------------------------------

struct Sheet {
    Vec3 u, v, normal;
    Vec2 operator()(Vec3 p) const { return {dot(u, p), dot(v, p)}; }
};

Sheet sheet_of(int axis) {
    if (axis == 0) return {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    if (axis == 1) return {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

// Returns the angle passed from `from` to `to`, degrees in (0, 360].
double turn_of(double from, double to, bool is_ccw) {
    double turn = is_ccw ? to - from : from - to;
    while (turn <= kUnitRounding)
        turn += 360.0;
    return turn;
}

struct Extent {
    double area = 0.0, length = 0.0;
};

// Computes the signed area between the origin and the piece, and the length of the piece.
struct ExtentOf {
    const SectionPiece* piece;

    Extent operator()(const FlatLine&) const {
        const Vec2 d = piece->to - piece->from;
        return {0.5 * cross(piece->from, piece->to), norm(d)};
    }
    Extent operator()(const FlatArc& c) const {
        const auto angle = [&](Vec2 p) {
            const Vec2 d = p - c.centre;
            return angle_of(d.x, d.y);
        };
        const double turn =
            turn_of(angle(piece->from), angle(piece->to), c.is_ccw) * kRadiansPerDegree;
        const double sector = 0.5 * c.radius * c.radius * turn;
        return {0.5 * cross(c.centre, piece->to - piece->from) + (c.is_ccw ? sector : -sector),
                c.radius * turn};
    }
    Extent operator()(const FlatEllipse& e) const {
        const double major = norm(e.major);
        const Vec2 x{e.major.x / major, e.major.y / major};
        const auto angle = [&](Vec2 p) {
            const Vec2 d = p - e.centre;
            return angle_of((d.x * x.x + d.y * x.y) / major, cross(x, d) / e.minor_radius);
        };
        const double start = angle(piece->from);
        const double turn = turn_of(start, angle(piece->to), e.is_ccw);
        const double sector = 0.5 * major * e.minor_radius * turn * kRadiansPerDegree;
        // No closed formula gives the length of a part of an ellipse.
        double length = 0.0;
        for (int i = 0; i < 2 * kSamples; ++i) {
            const double middle = (e.is_ccw ? turn : -turn) * (i + 0.5) / (2 * kSamples);
            const auto t = sin_cos(start + middle);
            const double du = major * t.sin, dv = e.minor_radius * t.cos;
            length += std::sqrt(du * du + dv * dv) * turn * kRadiansPerDegree / (2 * kSamples);
        }
        return {0.5 * cross(e.centre, piece->to - piece->from) + (e.is_ccw ? sector : -sector),
                length};
    }
    Extent operator()(const FlatChords& c) const {
        Extent sum;
        Vec2 last = piece->from;
        const auto go = [&](Vec2 p) {
            sum.area += 0.5 * cross(last, p);
            sum.length += norm(p - last);
            last = p;
        };
        for (const Vec2& p : c.between)
            go(p);
        go(piece->to);
        return sum;
    }
};

Extent extent_of(const SectionPiece& piece) {
    return std::visit(ExtentOf{&piece}, piece.curve);
}

// --- Pieces -------------------------------------------------------------------------------

// Start or end of the cut of a face.
struct Event {
    Vec3 at, above;
    std::uint32_t crossing = kNone;  // Number among all crossings.
    bool starts = false;
};

// Piece between two events: the angle passed in degrees, 0 for lines, and whether places grow.
struct Trace {
    const Event* begin;
    const Event* end;
    bool grows;
    double turn;
    bool is_whole() const { return begin->crossing == kNone; }
};

struct Made {
    SectionPiece piece;
    std::uint32_t begin = kNone, end = kNone;  // Crossings; kNone for closed curves.
    double per_mm = 0.0;
};

class Slicer {
public:
    Slicer(const Part& part, const SectionPlane& plane)
        : part_(part),
          sheet_(sheet_of(plane.axis)),
          plane_{sheet_.normal, sheet_.normal[plane.axis] * plane.at},
          lifted_{plane_.normal, plane_.offset + kPointError},
          is_above_(part.vertices.size()),
          crossings_(part.edges.size()),
          first_(part.edges.size(), 0) {
        section_.plane = plane;
    }

    std::optional<Section> operator()() {
        for (std::size_t v = 0; v < is_above_.size(); ++v)
            is_above_[v] = plane_.height(part_.vertices[v]) > kPointError;
        for (std::size_t e = 0; e < part_.edges.size(); ++e) {
            crossings_[e] = crossings_of(part_, part_.edges[e], plane_, kPointError);
            first_[e] = crossings_in_all_;
            crossings_in_all_ += static_cast<std::uint32_t>(crossings_[e].size());
        }
        for (const Solid& solid : part_.solids) {
            bool is_cut = true;
            for_shells(solid, [&](const Shell& shell) {
                is_cut = is_cut &&
                         std::ranges::all_of(shell, [&](auto f) { return cut(part_.faces[f]); });
            });
            if (!is_cut) return std::nullopt;
        }
        if (!join()) return std::nullopt;
        return std::move(section_);
    }

private:
    std::vector<Event> events_of(const Face& face, bool& is_below, bool& is_above) const {
        std::vector<Event> events;
        for (const EdgeUse& use : uses_of(face)) {
            const auto& crossings = crossings_[use.edge];
            (is_above_[part_.edges[use.edge].from] ? is_above : is_below) = true;
            for (std::size_t i = 0; i < crossings.size(); ++i) {
                // The face is on the left of the edges, so the cut begins where an edge descends.
                events.push_back({crossings[i].at, crossings[i].above,
                                  first_[use.edge] + static_cast<std::uint32_t>(i),
                                  crossings[i].goes_up != use.is_forward});
            }
        }
        return events;
    }

    // Returns the direction of the cut that has the material on the left.
    Vec3 ahead(const Face& face, Vec3 p) const {
        return cross(sheet_.normal, outward(face.surface, p));
    }

    bool cut(const Face& face) {
        bool is_below = false, is_above = false;
        std::vector<Event> events = events_of(face, is_below, is_above);
        const Form& form = face.surface.form;
        if (events.empty()) {
            if (std::holds_alternative<Plane>(form)) return true;
            const bool is_ruled =
                std::holds_alternative<Cylinder>(form) || std::holds_alternative<Extrusion>(form);
            if (is_ruled && (!is_below || !is_above)) return true;
        }
        if (const auto* envelope = std::get_if<Envelope>(&form))
            return cut_step_by_step(face, *envelope, events);
        const PlaneCut cut(form, lifted_);
        if (!cut.is_known() || is_spindle_cut_upright(form))
            return events.empty() && !may_be_cut(form);
        if (cut.branches() == 0) return events.empty();
        const PlaneCut exact(form, plane_);
        std::vector<std::vector<Event>> of(cut.branches());
        for (const Event& event : events)
            of[cut.branch_of(event.above)].push_back(event);
        for (std::size_t branch = 0; branch < of.size(); ++branch) {
            if (!of[branch].empty()) {
                if (!pair(face, cut, exact, branch, of[branch])) return false;
            } else if (cut.is_closed() && !round(face, cut, exact, branch)) {
                return false;
            }
        }
        return true;
    }

    // True if the pieces of the cut that are away from the axis cannot be identified.
    bool is_spindle_cut_upright(const Form& form) const {
        const auto* torus = std::get_if<Torus>(&form);
        return torus && is_spindle(*torus) && norm(cross(torus->axis, plane_.normal)) > kRounding;
    }

    // True if the plane may cut a form whose cut is unknown: a torus, a dome, a coil or a spiral.
    bool may_be_cut(const Form& form) const {
        if (const auto* f = std::get_if<Torus>(&form))
            return std::abs(plane_.height(f->centre)) < f->major + f->minor;
        if (const auto* f = std::get_if<Dome>(&form))
            return std::abs(plane_.height(f->centre)) < f->reach + f->radius;
        return std::holds_alternative<Coil>(form) || std::holds_alternative<Spiral>(form);
    }

    // Walks from each crossing where the cut enters the face to a crossing where the cut leaves. A
    // face without crossings may still pass through the plane between its edges.
    bool cut_step_by_step(const Face& face, const Envelope& envelope,
                          const std::vector<Event>& events) {
        if (events.empty()) return !may_be_deeper(face, envelope);
        std::vector<const Event*> ends;
        std::vector<Vec3> end_points;
        for (const Event& event : events) {
            if (event.starts) continue;
            ends.push_back(&event);
            end_points.push_back(event.above);
        }
        for (const Event& begin : events) {
            if (!begin.starts) continue;
            const auto walk =
                walk_along_cut(face.surface, lifted_, begin.above, end_points, kChordsMm);
            if (!walk) return false;
            const Event& end = *ends[walk->end];
            Made made{{}, begin.crossing, end.crossing};
            FlatChords chords;
            for (const Vec3& p : walk->between)
                chords.between.push_back(sheet_(p));
            made.piece = {sheet_(begin.at), sheet_(end.at), std::move(chords), face.origin,
                          face.is_facet};
            keep(face, made);
        }
        return true;
    }

    bool may_be_deeper(const Face& face, const Envelope& envelope) const {
        const Sweep& sweep = *envelope.sweep;
        double begin = 1e9, end = -1e9, first = 1e9, last = -1e9;
        for (const EdgeUse& use : uses_of(face)) {
            const Vec3 p = part_.vertices[part_.edges[use.edge].from];
            const ClosestPoint place = project_onto(envelope, p);
            const double across = place_across(sweep, place.tool, place.foot);
            begin = std::min(begin, place.t);
            end = std::max(end, place.t);
            first = std::min(first, across);
            last = std::max(last, across);
        }
        bool is_below = false, is_above = false;
        for (int i = 0; i <= kSamples; ++i) {
            const ToolFrame tool = sweep.at(begin + (end - begin) * i / kSamples);
            for (int k = 0; k <= kSamples; ++k) {
                const double across = first + (last - first) * k / kSamples;
                const double height = lifted_.height(point_across(sweep, tool, across));
                (height > 0.0 ? is_above : is_below) = true;
            }
        }
        return is_below && is_above;
    }

    bool pair(const Face& face, const PlaneCut& cut, const PlaneCut& exact, std::size_t branch,
              std::vector<Event>& events) {
        const Vec3 start = events.front().above;
        const double sign = cut.grows(start, ahead(face, start)) ? 1.0 : -1.0;
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < events.size(); ++i)
            order.emplace_back(sign * cut.place_of(events[i].above), i);
        std::sort(order.begin(), order.end());
        // On a line, the first event is a start; on closed curves, any event may be first.
        std::size_t first = 0;
        if (!events[order[0].second].starts) first = 1;
        if (order.size() % 2 != 0 || (first != 0 && cut.is_straight())) return false;
        for (std::size_t i = 0; i < order.size(); i += 2) {
            const Event& begin = events[order[(first + i) % order.size()].second];
            const Event& end = events[order[(first + i + 1) % order.size()].second];
            if (!begin.starts || end.starts) return false;
            double turn = 0.0;
            if (!cut.is_straight()) {
                turn = order[(first + i + 1) % order.size()].first -
                       order[(first + i) % order.size()].first;
                if (turn < 0.0) turn += 360.0;
            }
            if (!add(face, exact, branch, {&begin, &end, sign > 0.0, turn})) return false;
        }
        return true;
    }

    // Adds a closed curve without crossings if the curve lies in the face.
    bool round(const Face& face, const PlaneCut& cut, const PlaneCut& exact, std::size_t branch) {
        const auto is_there = has(face, cut, branch);
        if (!is_there) return false;
        if (!*is_there || exact.branches() != cut.branches()) return true;
        const Vec3 p = exact.at(branch, 0.0);
        const bool grows = cut.grows(cut.at(branch, 0.0), ahead(face, cut.at(branch, 0.0)));
        const Event there{p, p, kNone, false};
        return add(face, exact, branch, {&there, &there, grows, 360.0});
    }

    // True if the branch, which no edge crosses, lies in the face, tested along a second cut across
    // the branch.
    std::optional<bool> has(const Face& face, const PlaneCut& cut, std::size_t branch) const {
        if (face.loops.empty()) return true;
        // A face with the tip as a corner does not go round.
        const auto* torus = std::get_if<Torus>(&face.surface.form);
        if (torus && is_spindle(*torus) && face.loops.size() == 1) return false;
        for (int i = 0; i < kSamples / 2; ++i) {
            const Vec3 q = cut.at(branch, 360.0 * (i + 0.371) / (0.5 * kSamples));
            const auto normal = second_normal(face.surface.form, q, i);
            if (!normal) continue;
            const CutPlane second{*normal, dot(*normal, q)};
            const PlaneCut other(face.surface.form, second);
            if (!other.is_known() || other.branches() == 0) continue;
            const Vec3 d = cross(second.normal, outward(face.surface, q));
            const Along along(other, q);
            const double sign = along.grows(q, d) ? 1.0 : -1.0;
            // The nearest crossing ahead decides.
            double nearest = 0.0;
            std::optional<bool> inside;
            bool any = false;
            for (const EdgeUse& use : uses_of(face)) {
                for (const Crossing& c : crossings_of(part_, part_.edges[use.edge], second, 0.0)) {
                    if (!along.has(c.at)) continue;
                    any = true;
                    double ahead = sign * (along.place_of(c.at) - along.place_of(q));
                    if (other.is_closed() && ahead < 0.0) ahead += 360.0;
                    if (ahead < 0.0 || (inside && ahead >= nearest)) continue;
                    nearest = ahead;
                    inside = c.goes_up == use.is_forward;
                }
            }
            if (inside) return *inside;
            if (any || !other.is_closed()) return false;
        }
        // No second cut decides.
        return false;
    }

    // Branch of a cut that contains a given point; for a cone cut in its apex, a ruling.
    class Along {
    public:
        Along(const PlaneCut& cut, Vec3 q) : cut_(cut), q_(q), branch_(cut.branch_of(q)) {}
        bool has(Vec3 p) const {
            const auto apex = cut_.apex();
            if (!apex) return cut_.branch_of(p) == branch_;
            // Edges of facets are off the ruling; the second ruling in the plane is much farther
            // away.
            return norm(cross(p - *apex, q_ - *apex)) <=
                   20.0 * kLeastSine * norm(p - *apex) * norm(q_ - *apex);
        }
        double place_of(Vec3 p) const {
            const auto apex = cut_.apex();
            return apex ? norm(p - *apex) : cut_.place_of(p);
        }
        bool grows(Vec3 p, Vec3 d) const {
            const auto apex = cut_.apex();
            return apex ? dot(p - *apex, d) > 0.0 : cut_.grows(p, d);
        }

    private:
        const PlaneCut& cut_;
        Vec3 q_;
        std::size_t branch_;
    };

    // Returns the normal of a plane through `q` that cuts the surface in a line or a circle.
    std::optional<Vec3> second_normal(const Form& form, Vec3 q, int turn) const {
        const auto along_axis = [&](Vec3 origin, Vec3 axis) -> std::optional<Vec3> {
            const Vec3 n = cross(axis, q - origin);
            if (norm(n) < kPointError) return std::nullopt;
            return normalized(n);
        };
        if (const auto* f = std::get_if<Cylinder>(&form)) return along_axis(f->origin, f->axis);
        if (const auto* f = std::get_if<Cone>(&form)) return along_axis(f->apex, f->axis);
        if (const auto* f = std::get_if<Torus>(&form)) return along_axis(f->centre, f->axis);
        if (const auto* f = std::get_if<Extrusion>(&form)) return along_axis(f->centre, f->along);
        const auto* f = std::get_if<Sphere>(&form);
        if (!f) return std::nullopt;
        const Vec3 out = normalized(q - f->centre);
        const Vec3 x = any_perpendicular(out);
        const auto angle = sin_cos(180.0 * (turn + 0.129) / (0.5 * kSamples));
        return normalized(angle.cos * x + angle.sin * cross(out, x));
    }

    bool add(const Face& face, const PlaneCut& exact, std::size_t branch, const Trace& trace) {
        Made made;
        made.begin = trace.begin->crossing;
        made.end = trace.end->crossing;
        made.piece.origin = face.origin;
        made.piece.is_facet = face.is_facet;
        made.piece.from = sheet_(trace.begin->at);
        made.piece.to = sheet_(trace.end->at);
        const bool is_short = norm(trace.begin->at - trace.end->at) <= kPointError;
        if (const auto apex = exact.apex()) {
            const Vec3 in = trace.begin->at - *apex, out = trace.end->at - *apex;
            const double far = std::min(norm(in), norm(out));
            // The cut descends on a ruling and rises on another.
            if (far > kPointError && norm(cross(in, out)) > kPointError * far) {
                Made down = made;
                down.end = made.begin = crossings_in_all_++;
                down.piece.to = made.piece.from = sheet_(*apex);
                keep(face, down);
            }
        } else if (trace.is_whole() && exact.branches() <= branch) {
            return true;  // the plane touches the face
        } else if (!exact.is_straight() &&
                   !(is_short && (trace.turn < 180.0 || exact.branches() <= branch))) {
            if (exact.branches() <= branch) return false;
            if (!curve(made.piece, exact, branch, trace)) return false;
        }
        keep(face, made);
        return true;
    }

    bool curve(SectionPiece& piece, const PlaneCut& exact, std::size_t branch,
               const Trace& trace) const {
        const double from = exact.place_of(trace.begin->at);
        double turn = 360.0;
        if (!trace.is_whole()) turn = turn_of(from, exact.place_of(trace.end->at), trace.grows);
        // The ends have passed each other, so the piece does not exist.
        if (std::abs(turn - trace.turn) > 180.0) return false;
        if (const auto b = exact.exact(branch)) {
            const double x = norm(b->x), y = norm(b->y);
            const bool is_ccw = (dot(cross(b->x, b->y), sheet_.normal) > 0.0) == trace.grows;
            if (std::abs(x - y) <= kRounding * x) {
                piece.curve = FlatArc{sheet_(b->centre), x, is_ccw};
            } else {
                const bool wide = x > y;
                piece.curve = FlatEllipse{sheet_(b->centre), sheet_(wide ? b->x : b->y) - Vec2{},
                                          wide ? y : x, is_ccw};
            }
            return true;
        }
        FlatChords chords;
        const double sign = trace.grows ? 1.0 : -1.0;
        for (int i = 0; i < kSamples / 4; ++i) {
            const double a = turn * i / (0.25 * kSamples), b = turn * (i + 1) / (0.25 * kSamples);
            if (i > 0) chords.between.push_back(sheet_(exact.at(branch, from + sign * a)));
            refine(chords, exact, branch, from, sign, a, b, 0);
        }
        piece.curve = std::move(chords);
        return true;
    }

    void refine(FlatChords& chords, const PlaneCut& exact, std::size_t branch, double from,
                double sign, double a, double b, int depth) const {
        const auto at = [&](double t) { return sheet_(exact.at(branch, from + sign * t)); };
        const double middle = 0.5 * (a + b);
        const Vec2 p = at(a), q = at(b), m = at(middle);
        const Vec2 chord = q - p;
        const double length = norm(chord);
        const double deviation =
            length > 0.0 ? std::abs(cross(chord, m - p)) / length : norm(m - p);
        // The curve may bulge more between a and b than in the middle. 12 halvings reach 1 µm on
        // any curve of a part.
        if (deviation <= 0.5 * kChordsMm || depth == 12) return;
        refine(chords, exact, branch, from, sign, a, middle, depth + 1);
        chords.between.push_back(m);
        refine(chords, exact, branch, from, sign, middle, b, depth + 1);
    }

    void keep(const Face& face, Made& made) {
        const Extent extent = extent_of(made.piece);
        section_.length_mm += extent.length;
        // Sine of the angle between surface and plane: if the surface is off by d, the cut is off
        // by d / sine.
        const auto sine = [&](Vec2 p) {
            Vec3 at = p.x * sheet_.u + p.y * sheet_.v + plane_.offset * plane_.normal;
            return std::max(20.0 * kLeastSine, norm(ahead(face, at)));
        };
        made.per_mm = extent.length / std::min(sine(made.piece.from), sine(made.piece.to));
        section_.area_per_mm += made.per_mm;
        made_.push_back(std::move(made));
    }

    bool join() {
        std::vector<std::uint32_t> starting(crossings_in_all_, kNone);
        for (std::uint32_t i = 0; i < made_.size(); ++i) {
            if (made_[i].begin == kNone) continue;
            std::uint32_t& at = starting[made_[i].begin];
            if (at != kNone) return false;
            at = i;
        }
        std::vector<bool> is_used(made_.size(), false);
        for (std::uint32_t i = 0; i < made_.size(); ++i) {
            if (is_used[i]) continue;
            Outline outline;
            for (std::uint32_t at = i; !is_used[at];) {
                is_used[at] = true;
                outline.push_back(std::move(made_[at].piece));
                if (made_[at].end == kNone) break;
                at = starting[made_[at].end];
                if (at == kNone) return false;
                if (is_used[at] && at != i) return false;
            }
            finish(std::move(outline));
        }
        return true;
    }

    void finish(Outline outline) {
        if (outline.size() > 1) {
            Outline longer;
            for (SectionPiece& piece : outline) {
                if (extent_of(piece).length > kPointError) longer.push_back(std::move(piece));
            }
            for (std::size_t i = 0; i < longer.size(); ++i)
                longer[i].to = longer[(i + 1) % longer.size()].from;
            outline = std::move(longer);
        }
        flatten(outline);
        merge(outline);
        double area = 0.0, length = 0.0;
        for (const SectionPiece& piece : outline) {
            const Extent extent = extent_of(piece);
            area += extent.area;
            length += extent.length;
        }
        // An outline without area is dropped.
        if (std::abs(area) <= kPointError * length) return;
        section_.area_mm2 += area;
        section_.outlines.push_back(std::move(outline));
    }

    // Removes lines that go back on themselves, where the plane touches a face.
    static void flatten(Outline& outline) {
        for (std::size_t i = 0; outline.size() > 1 && i < outline.size();) {
            SectionPiece& a = outline[i];
            const std::size_t next = (i + 1) % outline.size();
            const SectionPiece& b = outline[next];
            if (!goes_back(a, b)) {
                ++i;
                continue;
            }
            a.to = b.to;
            const bool is_gone = norm(a.to - a.from) <= kPointError;
            if (is_gone) outline[(i + outline.size() - 1) % outline.size()].to = a.to;
            // The later piece is erased first.
            const std::size_t later = std::max(i, next), sooner = std::min(i, next);
            if (later == next || is_gone) outline.erase(outline.begin() + std::ptrdiff_t(later));
            if (sooner == next || is_gone) outline.erase(outline.begin() + std::ptrdiff_t(sooner));
            i = 0;
        }
    }

    static bool goes_back(const SectionPiece& a, const SectionPiece& b) {
        if (!std::holds_alternative<FlatLine>(a.curve) ||
            !std::holds_alternative<FlatLine>(b.curve))
            return false;
        const Vec2 d = a.to - a.from, e = b.to - b.from;
        return std::abs(cross(d, e)) <= kPointError * std::max(norm(d), norm(e)) &&
               d.x * e.x + d.y * e.y < 0.0;
    }

    // Joins adjacent pieces of the same line or circle with the same origin.
    static void merge(Outline& outline) {
        Outline merged;
        for (SectionPiece& piece : outline) {
            if (!merged.empty() && goes_on(merged.back(), piece)) {
                merged.back().to = piece.to;
            } else {
                merged.push_back(std::move(piece));
            }
        }
        if (merged.size() > 2 && goes_on(merged.back(), merged.front())) {
            merged.front().from = merged.back().from;
            merged.pop_back();
        }
        outline = std::move(merged);
    }

    static bool goes_on(const SectionPiece& a, const SectionPiece& b) {
        if (a.origin != b.origin || a.is_facet != b.is_facet) return false;
        if (std::holds_alternative<FlatLine>(a.curve) &&
            std::holds_alternative<FlatLine>(b.curve)) {
            const Vec2 d = a.to - a.from, e = b.to - b.from;
            return std::abs(cross(d, e)) <= kReaderMm * std::max(norm(d), norm(e)) &&
                   d.x * e.x + d.y * e.y > 0.0;
        }
        const auto* c = std::get_if<FlatArc>(&a.curve);
        const auto* d = std::get_if<FlatArc>(&b.curve);
        return c && d && std::abs(c->radius - d->radius) <= kReaderMm &&
               norm(c->centre - d->centre) <= kReaderMm && c->is_ccw == d->is_ccw;
    }

    const Part& part_;
    Sheet sheet_;
    CutPlane plane_, lifted_;
    std::vector<bool> is_above_;
    std::vector<std::vector<Crossing>> crossings_;  // By edge.
    std::vector<std::uint32_t> first_;              // Number of each edge's first crossing.
    std::uint32_t crossings_in_all_ = 0;            // Including apexes, where pieces meet.
    std::vector<Made> made_;
    Section section_;
};

}  // namespace

std::optional<SectionPlane> parse_section_plane(std::string_view text) {
    if (text.size() < 3 || text[1] != '=') return std::nullopt;
    const std::size_t axis = std::string_view("xyz").find(static_cast<char>(text[0] | 0x20));
    if (axis == std::string_view::npos) return std::nullopt;
    text.remove_prefix(2);
    const auto at = number_in<double>(text);
    if (!at || !(std::abs(*at) < 1e6)) return std::nullopt;  // No program reaches this.
    return SectionPlane{static_cast<int>(axis), *at};
}

std::string name_of(const SectionPlane& plane) {
    return std::string(1, "xyz"[plane.axis]) + '=' + shortest(plane.at + 0.0);
}

std::optional<Section> section_of(const Part& part, const SectionPlane& plane) {
    return Slicer(part, plane)();
}

}  // namespace ncsim::brep
