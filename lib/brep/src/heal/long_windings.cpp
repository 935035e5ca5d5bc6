// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/brep/long_windings.h"

#include "ncsim/base/angles.h"
#include "ncsim/brep/frames.h"

#include "geometry/tolerances.h"
#include "query/part_check.h"
#include "topology/edge_splitter.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace ncsim::brep {

namespace {

// Angle of points about the axis of a cylinder or coil, continuous beyond a whole turn.
class Winding {
public:
    explicit Winding(const Form& form)
        : cylinder_(std::get_if<Cylinder>(&form)), coil_(std::get_if<Coil>(&form)) {
        if (cylinder_) x_ = any_perpendicular(cylinder_->axis);
    }
    bool is_known() const { return cylinder_ || coil_; }

    // Returns the angle of a point, degrees. On cylinders, whole turns are added until the angle is
    // as near to `nearby` as possible.
    double angle(Vec3 p, double nearby) const {
        if (coil_) return project_onto(*coil_, p).turn / kRadiansPerDegree;
        const Vec3 v = p - cylinder_->origin;
        const double at = angle_of(dot(v, x_), dot(v, cross(cylinder_->axis, x_)));
        return at + kTurnDegrees * std::round((nearby - at) / kTurnDegrees);
    }

    // Returns the arc of a coil's circle at the angle `degrees`, from `a` to `b`.
    Curve across(double degrees, Vec3 a, Vec3 b) const {
        const auto t = sin_cos(degrees);
        const Vec3 side = cross(coil_->axis, coil_->ahead);
        const Vec3 centre = coil_->centre + coil_->reach * (t.cos * coil_->ahead + t.sin * side) +
                            (coil_->lead * degrees * kRadiansPerDegree) * coil_->axis;
        const bool is_left = dot(cross(a - centre, b - centre), coil_->axis) > 0.0;
        return Circle{centre, is_left ? coil_->axis : -coil_->axis, coil_->radius};
    }

private:
    const Cylinder* cylinder_;
    const Coil* coil_;
    Vec3 x_;
};

// Angles along a loop, at even steps of each edge in the direction of use.
struct Course {
    struct Step {
        std::size_t use = 0;
        double from = 0.0, to = 0.0;    // shares of the edge's track
        double begin = 0.0, end = 0.0;  // degrees
    };
    std::vector<Step> steps;
    double low = 0.0, high = 0.0;
};

Course course_of(const Part& part, const Loop& loop, const Winding& winding) {
    Course course;
    std::optional<double> last;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Edge& edge = part.edges[loop[i].edge];
        const Track track = track_of(part, edge);
        const std::size_t count = 4 * track.pieces();
        const auto share = [&](std::size_t k) {
            const double s = static_cast<double>(k) / static_cast<double>(count);
            return loop[i].is_forward ? s : 1.0 - s;
        };
        for (std::size_t k = 0; k < count; ++k) {
            const double begin = last ? *last : winding.angle(track.at(share(0)), 0.0);
            if (!last) course.low = course.high = begin;
            const double end = winding.angle(track.at(share(k + 1)), begin);
            course.steps.push_back({i, share(k), share(k + 1), begin, end});
            course.low = std::min(course.low, end);
            course.high = std::max(course.high, end);
            last = end;
        }
    }
    return course;
}

// Returns the share of the track at which a step reaches `degrees`.
double share_at(const Part& part, const Edge& edge, const Course::Step& step,
                const Winding& winding, double degrees) {
    const Track track = track_of(part, edge);
    double from = step.from, to = step.to;
    for (int i = 0; i < kMostSteps; ++i) {
        const double middle = 0.5 * (from + to);
        const bool is_before =
            (winding.angle(track.at(middle), degrees) < degrees) == (step.begin < degrees);
        (is_before ? from : to) = middle;
    }
    return 0.5 * (from + to);
}

// Divides the face of a coil at `degrees`; the new face is the last of the part. False unless the
// loop passes this angle in exactly two places, on edges that can be divided.
bool divide(Part& part, std::uint32_t f, const Winding& winding, const Course& course,
            double degrees) {
    EdgeSplitter splitter(part);
    const std::uint32_t first_new = static_cast<std::uint32_t>(part.vertices.size());
    int crossings = 0;
    for (const Course::Step& step : course.steps) {
        if ((step.begin < degrees) == (step.end < degrees)) continue;
        const std::uint32_t e = part.faces[f].loops.front()[step.use].edge;
        const Edge edge = part.edges[e];
        if (++crossings > 2 || !splitter.divide(e, share_at(part, edge, step, winding, degrees)))
            return false;
    }
    if (crossings != 2) return false;
    splitter.finish();
    Loop loop = part.faces[f].loops.front();
    const auto starts_new = [&](const EdgeUse& use) { return begin_of(part, use) >= first_new; };
    const auto first = std::ranges::find_if(loop, starts_new);
    std::rotate(loop.begin(), first, loop.end());
    const auto second = std::find_if(loop.begin() + 1, loop.end(), starts_new);
    if (second == loop.end()) return false;
    const std::uint32_t a = begin_of(part, loop.front()), b = begin_of(part, *second);
    const auto bridge = static_cast<std::uint32_t>(part.edges.size());
    part.edges.push_back({a, b, winding.across(degrees, part.vertices[a], part.vertices[b])});
    Face other = part.faces[f];
    Loop front(loop.begin(), second), back(second, loop.end());
    front.push_back({bridge, false});
    back.push_back({bridge, true});
    part.faces[f].loops = {std::move(front)};
    other.loops = {std::move(back)};
    part.faces[f].frame = frame_for(part, part.faces[f]);
    other.frame = frame_for(part, other);
    append_face(part, f, std::move(other));
    return true;
}

// Vertex of a face at which a loop passes a meridian.
struct Passage {
    std::uint32_t vertex = 0;
    double height = 0.0;
    std::size_t loop = 0, use = 0;  // the use that begins in the vertex
    bool is_forward = false;        // towards greater angles
};

// Divides the edges of a cylinder's face at all turns of `degrees`. False if an edge cannot be
// divided.
bool divide_edges(Part& part, std::uint32_t f, const Winding& winding, double degrees) {
    for (int round = 0; round < 40; ++round) {
        EdgeSplitter splitter(part);
        bool any = false;
        const std::vector<Loop> loops = part.faces[f].loops;
        for (const Loop& loop : loops) {
            std::optional<std::size_t> last;
            for (const Course::Step& step : course_of(part, loop, winding).steps) {
                const double first = std::floor((step.begin - degrees) / kTurnDegrees);
                const double second = std::floor((step.end - degrees) / kTurnDegrees);
                if (first == second || last == step.use) continue;
                const std::uint32_t e = loop[step.use].edge;
                const Edge edge = part.edges[e];
                const double at = share_at(part, edge, step, winding,
                                           degrees + kTurnDegrees * std::max(first, second));
                if (at < kRounding || at > 1.0 - kRounding) continue;
                if (!splitter.divide(e, at)) return false;
                last = step.use;
                any = true;
            }
        }
        if (!any) return true;
        splitter.finish();
    }
    return false;
}

// Returns the passages of all loops of a face through the meridian, ascending along the axis.
std::vector<Passage> passages_of(const Part& part, std::uint32_t f, const Winding& winding,
                                 double degrees) {
    std::vector<Passage> passages;
    const auto& cylinder = std::get<Cylinder>(part.faces[f].surface.form);
    const auto& loops = part.faces[f].loops;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const auto steps = course_of(part, loops[l], winding).steps;
        for (std::size_t k = 0; k < steps.size(); ++k) {
            const Course::Step &step = steps[k], &before = steps[k == 0 ? steps.size() - 1 : k - 1];
            if (step.use == before.use && loops[l].size() > 1) continue;
            const double turns = (step.begin - degrees) / kTurnDegrees;
            if (std::abs(turns - std::round(turns)) > kPointError / kTurnDegrees) continue;
            const EdgeUse& use = loops[l][step.use];
            const Edge& edge = part.edges[use.edge];
            const std::uint32_t v = use.is_forward ? edge.from : edge.to;
            passages.push_back({v, dot(part.vertices[v] - cylinder.origin, cylinder.axis), l,
                                step.use, step.end > step.begin});
        }
    }
    std::ranges::sort(passages, {}, &Passage::height);
    return passages;
}

// Divides the face of a cylinder along a meridian. New faces are the last faces of the part. False
// if an edge cannot be divided, the passages form no pairs, or a loop does not pass the meridian.
bool cut_at_meridian(Part& part, std::uint32_t f, const Winding& winding, double degrees) {
    if (!divide_edges(part, f, winding, degrees)) return false;
    const auto passages = passages_of(part, f, winding, degrees);
    if (passages.size() % 2 != 0) return false;
    // Links the loops anew: a loop that arrives at a passage continues along the bridge to the
    // second passage of the pair, and from there with the edge that leaves this passage.
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> leaving;  // use -> passage
    for (std::size_t i = 0; i < passages.size(); ++i)
        leaving[{passages[i].loop, passages[i].use}] = i;
    if (leaving.size() != passages.size()) return false;
    std::vector<std::uint32_t> bridges;
    for (std::size_t i = 0; i < passages.size(); i += 2) {
        if (passages[i].is_forward == passages[i + 1].is_forward) return false;
        bridges.push_back(static_cast<std::uint32_t>(part.edges.size()));
        part.edges.push_back({passages[i].vertex, passages[i + 1].vertex, Line{}});
    }
    const std::vector<Loop> loops = part.faces[f].loops;
    std::set<std::pair<std::size_t, std::size_t>> done;
    std::vector<Loop> made;
    for (const Passage& start : passages) {
        std::pair at{start.loop, start.use};
        if (done.contains(at)) continue;
        Loop& loop = made.emplace_back();
        while (done.insert(at).second) {
            loop.push_back(loops[at.first][at.second]);
            at.second = (at.second + 1) % loops[at.first].size();
            const auto found = leaving.find(at);
            if (found == leaving.end()) continue;
            const std::size_t other = found->second ^ 1;
            loop.push_back({bridges[found->second / 2], found->second % 2 == 0});
            at = {passages[other].loop, passages[other].use};
        }
    }
    std::size_t uses = 0;
    for (const Loop& loop : loops)
        uses += loop.size();
    if (done.size() != uses) return false;  // A loop does not pass the meridian.
    const Face face = part.faces[f];
    for (std::size_t i = 0; i < made.size(); ++i) {
        Face piece = face;
        piece.loops = {std::move(made[i])};
        piece.frame = frame_for(part, piece);
        if (i == 0) {
            part.faces[f] = std::move(piece);
        } else {
            append_face(part, f, std::move(piece));
        }
    }
    return true;
}

bool is_sound(const Part& part, std::uint32_t face) {
    double miss = 0.0;
    return faults_of(part, face, kTangencyGapMm, miss).empty();
}

// True if a face has a single loop, which covers at most half a turn.
bool is_half(const Part& part, std::uint32_t f, const Winding& winding) {
    const auto& loops = part.faces[f].loops;
    if (loops.size() != 1) return false;
    const Course course = course_of(part, loops.front(), winding);
    return course.high - course.low <= kHalfTurnDegrees + kPointError;
}

// Cuts the face of a cylinder along the meridians at `aside` and `aside` + 180 degrees. False if a
// cut fails or a piece has faults.
bool split_wall(Part& part, std::uint32_t face, const Winding& winding, double aside) {
    std::vector<std::uint32_t> pieces{face};
    for (const double degrees : {aside, aside + kHalfTurnDegrees}) {
        for (const std::uint32_t f : std::vector(pieces)) {
            const auto first = static_cast<std::uint32_t>(part.faces.size());
            if (is_half(part, f, winding)) continue;
            if (!cut_at_meridian(part, f, winding, degrees)) return false;
            for (auto made = first; made < part.faces.size(); ++made)
                pieces.push_back(made);
        }
    }
    return std::ranges::all_of(pieces, [&](std::uint32_t f) { return is_sound(part, f); });
}

// Divides the face of a coil until each piece covers at most half a turn. Cuts are `aside` degrees
// from the middle of a piece. False if a piece cannot be divided or has faults.
bool split_strip(Part& part, std::uint32_t face, const Winding& winding, double aside) {
    if (part.faces[face].loops.size() != 1) return false;
    std::vector<std::uint32_t> open{face};
    while (!open.empty()) {
        const std::uint32_t f = open.back();
        open.pop_back();
        const Course course = course_of(part, part.faces[f].loops.front(), winding);
        if (course.high - course.low <= kHalfTurnDegrees) {
            if (!is_sound(part, f)) return false;
            continue;
        }
        const double middle = 0.5 * (course.low + course.high) + aside;
        const auto other = static_cast<std::uint32_t>(part.faces.size());
        if (!divide(part, f, winding, course, middle)) return false;
        open.push_back(f);
        open.push_back(other);
    }
    return true;
}

// True if a loop of the face covers more than 361 degrees, which is possible only with a spline
// edge.
bool is_long(const Part& part, const Face& face) {
    const Winding winding(face.surface.form);
    if (!winding.is_known() || face.is_facet) return false;
    return std::ranges::any_of(face.loops, [&](const Loop& loop) {
        const bool has_spline = std::ranges::any_of(loop, [&](const EdgeUse& use) {
            return std::holds_alternative<Spline>(part.edges[use.edge].curve);
        });
        if (!has_spline) return false;
        const Course course = course_of(part, loop, winding);
        return course.high - course.low > kTurnDegrees + 1.0;
    });
}

}  // namespace

bool has_long_windings(const Part& part) {
    return std::ranges::any_of(part.faces, [&](const Face& face) { return is_long(part, face); });
}

void split_long_windings(Part& part) {
    const std::size_t count = part.faces.size();
    for (std::uint32_t f = 0; f < count; ++f) {
        if (!is_long(part, part.faces[f])) continue;
        const Form form = part.faces[f].surface.form;
        const Winding winding(form);
        const Part whole = part;
        const auto split = std::holds_alternative<Cylinder>(form) ? split_wall : split_strip;
        // Programs have corners at whole quarters of a turn, so cuts avoid these angles, and knots
        // of splines. If no angle gives sound faces, the face stays whole.
        for (const double aside : {1.234, 7.654, 23.456}) {
            if (split(part, f, winding, aside)) break;
            part = whole;
        }
    }
}

}  // namespace ncsim::brep
