// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traversal of motions: steps of single motions, combined cells for whole turns and for straight
// runs.
#include "ncsim/toolpath/walk.h"

#include "ncsim/base/int128.h"
#include "ncsim/toolpath/kinematics.h"

#include "motion/axis_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ncsim::toolpath {

using gcode::Length;
using gcode::Linear;
using gcode::Position;

namespace {

constexpr std::array<Length Position::*, 3> kFirst{&Position::x, &Position::y, &Position::z};
constexpr std::array<Length Position::*, 3> kSecond{&Position::u, &Position::v, &Position::w};

// Returns the position of a linear axis after `time`, moving at `rate` until it arrives; then
// exactly `to`.
Length axis_at(Length from, Length to, double rate, double time) {
    const double distance = std::abs((to - from).mm());
    if (rate * time >= distance) return to;
    return from + (rate * time / distance) * (to - from);
}

Box grow_box(Box box, double by_mm) {
    box.min = box.min - Vec3{by_mm, by_mm, by_mm};
    box.max = box.max + Vec3{by_mm, by_mm, by_mm};
    return box;
}

// Returns the sweep of a cylinder whose lower end is a disc, a quarter circle or a cone; empty for
// other shapes.
std::optional<cda::RoundSweep> round_sweep_of(const ToolPiece& piece) {
    const std::vector<ProfilePoint>& p = piece.profile;
    if (p.size() < 2 || p.size() > 3) return std::nullopt;
    const ProfilePoint& low = p.front();
    const ProfilePoint& high = p.back();
    for (std::size_t i = 1; i < p.size(); ++i) {
        if (p[i].fillet != 0.0) return std::nullopt;
    }
    cda::RoundSweep sweep;
    sweep.radius = high.radius;
    sweep.height = high.height - low.height;
    sweep.from = sweep.to = {0, 0, low.height};
    if (p[1].radius != high.radius || low.radius > high.radius) return std::nullopt;
    if (low.radius == high.radius) {
        if (p.size() != 2 || low.fillet > low.radius) return std::nullopt;
        sweep.flat_radius = low.radius - low.fillet;
        sweep.tip_height = low.fillet;
    } else {
        if (low.fillet != 0.0) return std::nullopt;
        sweep.flat_radius = low.radius;
        sweep.tip_height = p[1].height - low.height;
        sweep.is_cone = true;
        if (sweep.tip_height <= 0.0) return std::nullopt;
    }
    if (sweep.radius <= 0.0 || sweep.height < sweep.tip_height) return std::nullopt;
    return sweep;
}

// Returns a sweep per cutting piece; empty if a cutting piece has an unsupported shape.
std::vector<cda::RoundSweep> round_sweep_of(const Tool& tool) {
    std::vector<cda::RoundSweep> all;
    for (const ToolPiece& piece : tool.pieces) {
        if (!piece.cutting) continue;
        const auto sweep = round_sweep_of(piece);
        if (!sweep) return {};
        all.push_back(*sweep);
    }
    return all;
}

// True if b is on the way from a to c, exactly.
bool is_between(const cda::LatticePoint& a, const cda::LatticePoint& b,
                const cda::LatticePoint& c) {
    const cda::LatticePoint u = b - a, v = c - b;
    const auto product = [](std::int64_t p, std::int64_t q) { return Int128{p} * q; };
    return product(u.x, v.y) == product(u.y, v.x) && product(u.y, v.z) == product(u.z, v.y) &&
           product(u.z, v.x) == product(u.x, v.z) &&
           product(u.x, v.x) + product(u.y, v.y) + product(u.z, v.z) > 0;
}

// True if the walls of `hull` are exactly parallel to `way`. Otherwise their normals were rounded,
// and the hulls of the steps differ from `hull` by the rounding.
bool is_parallel_to(const cda::Cell& hull, const cda::LatticePoint& way) {
    const auto first = hull.planes.begin() + static_cast<std::ptrdiff_t>(hull.normals->size());
    return std::all_of(first, hull.planes.end(), [&](const cda::Plane& wall) {
        return wall.nx * way.x + wall.ny * way.y + wall.nz * way.z == 0;
    });
}

}  // namespace

const Linear* straight_upright(const gcode::Motion& motion) {
    const auto* linear = std::get_if<Linear>(&motion.action);
    if (!linear || motion.coordinates == gcode::Coordinates::Tip) return nullptr;
    for (const auto axis : {&Position::a, &Position::b, &Position::c}) {
        if ((linear->from.*axis).degrees() != 0.0 || (linear->to.*axis).degrees() != 0.0)
            return nullptr;
    }
    return linear;
}

std::vector<Linear> legs_of(const Linear& rapid, const RapidPath& path) {
    if (!path.dog_leg) return {rapid};
    // Times at which the axes arrive.
    std::vector<double> times;
    for (std::size_t i = 0; i < 3; ++i) {
        for (const auto axis : {kFirst[i], kSecond[i]}) {
            const double distance = std::abs((rapid.to.*axis - rapid.from.*axis).mm());
            if (distance > 0.0) times.push_back(distance / path.rates[i]);
        }
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.size() < 2) return {rapid};
    std::vector<Linear> legs;
    Position at = rapid.from;
    for (const double time : times) {
        Position next = rapid.to;
        if (time != times.back()) {
            for (std::size_t i = 0; i < 3; ++i) {
                for (const auto axis : {kFirst[i], kSecond[i]}) {
                    next.*axis = axis_at(rapid.from.*axis, rapid.to.*axis, path.rates[i], time);
                }
            }
            const double t = time / times.back();
            for (const auto axis : {&Position::a, &Position::b, &Position::c}) {
                next.*axis = gcode::Angle::from_degrees(
                    (rapid.from.*axis).degrees() +
                    t * ((rapid.to.*axis).degrees() - (rapid.from.*axis).degrees()));
            }
        }
        legs.push_back({at, next});
        at = next;
    }
    return legs;
}

Walk::Walk(const cda::Lattice& lattice, const Box& stock, WalkOptions options)
    : lattice_(lattice), stock_(stock), options_(std::move(options)), place_(stock) {
    // Facets may be left out for the part of the allowed gain that steps do not use. Because the
    // number of steps is an integer, more than the least share remains, as a rule.
    constexpr double kLeast = 0.02, kMost = 0.3;
    gain_mm_ = options_.sampling.rotation_gain_mm;
    slack_mm_ = kMost * gain_mm_;
    options_.sampling.rotation_gain_mm -= kLeast * gain_mm_;
    place_.add(options_.watch.place);
}

const Cutter& Walk::add_tool(int number, const Tool& tool) {
    const auto found = tools_.find(number);
    if (found != tools_.end()) return found->second.cutter;
    // Tools of the same shape share a polytope, which takes milliseconds to find.
    const auto same = std::ranges::find_if(
        tools_, [&](const auto& known) { return known.second.pieces == tool.pieces; });
    Cutter cutter =
        same != tools_.end() ? same->second.cutter : Cutter(tool, lattice_, options_.accuracy);
    ToolExtent followed = cutter.extent();
    for (const ToolPiece& piece : tool.pieces) {
        if (!piece.cutting && options_.watch.shanks) followed.pieces.push_back(extent_of(piece));
    }
    return tools_
        .try_emplace(number, ToolData{std::move(cutter), std::move(followed), tool.pieces,
                                      round_sweep_of(tool)})
        .first->second.cutter;
}

const Cutter* Walk::cutter(int number) const {
    const auto found = tools_.find(number);
    return found == tools_.end() ? nullptr : &found->second.cutter;
}

// Returns cutter.bounds() of two poses of the same orientation, with the reach computed once per
// orientation.
Box Walk::ToolData::bounds(const Pose& X_WA, const Pose& X_WB) {
    if (rows != X_WA.rows) {
        rows = X_WA.rows;
        reach = cutter.reach(X_WA);
    }
    return cutter.bounds(X_WA, X_WB, reach);
}

// Fills cells_ or sweeps_ with the parts of the step that may meet the stock.
void Walk::trace(ToolData& tool, const Pose& X_WA, const Pose& X_WB, cda::Origin origin,
                 const SweepSimplification& liberties) {
    Cutter& cutter = tool.cutter;
    cells_.clear();
    sweeps_.clear();
    const Box bounds =
        X_WA.rows == X_WB.rows ? tool.bounds(X_WA, X_WB) : cutter.bounds(X_WA, X_WB, liberties);
    is_near_ = stock_.overlaps(bounds);
    if (!is_near_ || (region_ && !region_->overlaps(bounds))) return;
    const Vec3 up{0, 0, 1};
    if (options_.prefers_sweeps && !tool.round.empty() && axis_of(X_WA) == up &&
        axis_of(X_WB) == up) {
        for (cda::RoundSweep sweep : tool.round) {
            sweep.origin = origin;
            for (const auto& [end, pose] : {std::pair{&sweep.from, &X_WA}, {&sweep.to, &X_WB}}) {
                *end = pose->translation + *end;
                const double r = sweep.radius;
                sweep.bounds.add(*end - Vec3{r, r, 0});
                sweep.bounds.add(*end + Vec3{r, r, sweep.height});
            }
            if (stock_.overlaps(sweep.bounds)) sweeps_.push_back(sweep);
        }
        return;
    }
    cutter.trace(X_WA, X_WB, origin, cells_, liberties);
    std::erase_if(cells_, [&](const cda::Cell& c) { return !stock_.overlaps(c.bounds); });
}

void Walk::at_end_position(const gcode::Motion& motion, cda::Origin origin,
                           const std::function<void(const Step&)>& step) {
    const auto found = tools_.find(motion.tool);
    const gcode::Position* end = end_of(motion);
    if (found == tools_.end() || !end || has_known_start(motion) || !has_known_end(motion)) return;
    const Pose X_WT = Poses(options_.specified.get(), motion).at(*end);
    trace(found->second, X_WT, X_WT, origin, {});
    step({X_WT, X_WT, cells_, {}, {}, sweeps_, is_near_, {}, {}});
}

// True if the whole tool stays away from the wanted place during the motion.
bool Walk::stays_outside_region(const ToolData& tool, const gcode::Motion& motion,
                                const Poses& poses, const Pose& X_WA, const Pose& X_WB) const {
    double reach = 0.0;
    for (const PieceExtent& piece : tool.followed.pieces) {
        const double high = std::max(std::abs(piece.low_mm), std::abs(piece.high_mm));
        reach = std::max(reach, std::sqrt(high * high + piece.radius_mm * piece.radius_mm));
    }
    const auto strays = max_deviation_mm(motion, poses, reach);
    return strays && !region_->overlaps(grow_box(tool.cutter.bounds(X_WA, X_WB), *strays));
}

// Continues the run if a straight move continues the preceding move's line on the lattice, within
// the tool's diameter; the place of the cuts cannot be determined more exactly. Otherwise ends the
// run, and preceding_cells_ gets the cells of the run as a whole.
void Walk::extend_line_run(ToolData& tool, const gcode::Motion& motion, const Pose& X_WA,
                           const Pose& X_WB, cda::Origin origin) {
    if (!options_.merges_cells || options_.prefers_sweeps || motion.kind != gcode::MoveKind::Feed)
        return end_line_run();
    const cda::LatticePoint from = lattice_.round(X_WA.translation);
    const cda::LatticePoint to = lattice_.round(X_WB.translation);
    const double way = norm(lattice_.to_mm(to - line_run_.start));
    const bool goes_on = !line_run_.ends.empty() && line_run_.tool == &tool &&
                         line_run_.ends.back() == from && way <= 2 * tool.cutter.radius_mm() &&
                         is_between(line_run_.start, from, to);
    if (!goes_on) {
        end_line_run();
        line_run_ = {from, X_WA.translation, {}, {}, &tool, cda::kStockOrigin};
    }
    line_run_.ends.push_back(to);
    line_run_.steps.push_back({origin, 1.0, cells_.empty() ? Box{} : cells_[0].bounds});
    // A move that did not meet the stock has no origin, whether the stock is wanted there or not.
    if (is_near_ && tool.cutter.meets(stock_, X_WA, X_WB)) line_run_.origin = origin;
}

void Walk::end_line_run() {
    LineRun run = std::exchange(line_run_, {});
    if (run.ends.size() < 2 || run.origin == cda::kStockOrigin) return;
    const cda::LatticePoint way = run.ends.back() - run.start;
    const Pose X_WA{upright_, lattice_.to_mm(run.start)};
    const Pose X_WB{upright_, lattice_.to_mm(run.ends.back())};
    const Box bounds = run.tool->bounds(X_WA, X_WB);
    if (!stock_.overlaps(bounds) || (region_ && !region_->overlaps(bounds))) return;
    run.tool->cutter.trace(X_WA, X_WB, run.origin, preceding_cells_);
    for (cda::Cell& cell : preceding_cells_) {
        const std::int64_t rank = std::int64_t{cell.rank} - std::ssize(run.ends);
        cell.rank =
            static_cast<std::int32_t>(std::max<std::int64_t>(rank, cda::Cell::kFirstRank + 1));
    }
    std::erase_if(preceding_cells_, [&](const cda::Cell& c) {
        return !stock_.overlaps(c.bounds) || !is_parallel_to(c, way);
    });
    // With several pieces, the place does not determine which move removed the material first.
    if (preceding_cells_.size() != 1 || run.tool->cutter.pieces() != 1) return;
    const auto length = [&](const cda::LatticePoint& end) {
        return norm(lattice_.to_mm(end - run.start));
    };
    for (std::size_t i = 0; i + 1 < run.ends.size(); ++i)
        run.steps[i].end = length(run.ends[i]) / length(run.ends.back());
    preceding_cells_[0].steps =
        std::make_shared<const cda::StraightSteps>(cda::StraightSteps{way, std::move(run.steps)});
}

std::optional<Vec3> Walk::line_start() const {
    return line_run_.ends.size() > 1 ? std::optional(line_run_.start_mm) : std::nullopt;
}

// True if the motion is an arc about a centre that may stay within the tool throughout. Continues
// the preceding arc if both have the same centre.
bool Walk::extend_arc_run(const Cutter& cutter, const gcode::Motion& motion) {
    // Centres that are programmed separately differ in their last digits.
    constexpr double kSame = 0.01;
    const auto* arc = std::get_if<gcode::Arc>(&motion.action);
    const bool is_level = arc && arc->plane == gcode::Plane::XY && !arc->tilted;
    const PolarArc p = is_level ? polar(*arc) : PolarArc{};
    if (!options_.merges_cells || !is_level || options_.prefers_sweeps ||
        p.start_radius >= cutter.radius_mm()) {
        arc_run_.way.clear();
        return false;
    }
    const bool goes_on = arc_run_.tool == motion.tool && std::abs(p.sweep_degrees) < 359.0 &&
                         std::abs(p.centre_1 - arc_run_.centre_1) < kSame &&
                         std::abs(p.centre_2 - arc_run_.centre_2) < kSame;
    if (!goes_on) arc_run_ = {{}, {}, p.centre_1, p.centre_2, motion.tool};
    return true;
}

// Adds a step of an arc. If the step ends a whole turn, merged_cells_ gets the volume that the turn
// certainly removed.
void Walk::close_arc_run(Cutter& cutter, const Pose& X_WA, const Pose& X_WB, cda::Origin origin) {
    constexpr std::size_t kMost = 1000;  // steps of a turn
    const cda::LatticePoint from = lattice_.round(X_WA.translation);
    const cda::LatticePoint to = lattice_.round(X_WB.translation);
    std::vector<cda::LatticePoint>& way = arc_run_.way;
    if (way.empty() || way.back() != from || way.size() > kMost || X_WA.rows != X_WB.rows ||
        X_WA.rows != arc_run_.rows) {
        way = {from};
        arc_run_.rows = X_WA.rows;
    }
    way.push_back(to);
    if (X_WA.rows != X_WB.rows || to.x != way[0].x || to.y != way[0].y) return;
    cutter.cover(way, X_WB, origin, merged_cells_);
    way = {to};
    // Cells outside the wanted place are kept: the existence of a cell can decide about a step that
    // is not near.
    std::erase_if(merged_cells_, [&](const cda::Cell& c) { return !stock_.overlaps(c.bounds); });
}

SampleBounds Walk::take(const gcode::Motion& motion, cda::Origin origin,
                        const std::function<void(const Step&)>& step) {
    const auto found = tools_.find(motion.tool);
    if (found == tools_.end() || !has_known_start(motion)) return {};
    ToolData& tool = found->second;
    merged_cells_.clear();
    preceding_cells_.clear();
    if (const Linear* linear =
            options_.specified || options_.rapid.dog_leg ? nullptr : straight_upright(motion)) {
        const Pose X_WA{upright_, linear_axes(linear->from)};
        const Pose X_WB{upright_, linear_axes(linear->to)};
        if (X_WA == X_WB) return {};
        arc_run_.way.clear();
        trace(tool, X_WA, X_WB, origin, {});
        extend_line_run(tool, motion, X_WA, X_WB, origin);
        RotationBounds turning;
        turning.moved_mm = norm(X_WB.translation - X_WA.translation);
        step({X_WA, X_WB, cells_, merged_cells_, preceding_cells_, sweeps_, is_near_, {}, turning});
        return {};
    }
    const bool has_legs = options_.rapid.dog_leg && motion.kind == gcode::MoveKind::Rapid;
    Cutter& cutter = tool.cutter;
    end_line_run();
    const bool goes_round = extend_arc_run(cutter, motion);
    if (skips_motions_ && !has_legs && !goes_round && start_of(motion)) {
        const Poses poses(options_.specified.get(), motion);
        const Pose X_WA = poses.at(*start_of(motion)), X_WB = poses.at(*end_of(motion));
        if (stays_outside_region(tool, motion, poses, X_WA, X_WB)) {
            step({X_WA, X_WB, {}, merged_cells_, preceding_cells_, {}, false, {}, {}});
            return {};
        }
    }
    const ToolExtent& followed = tool.followed;
    // The bounds hold for round tools. The hulls of the polytopes deviate from the round tools by
    // this margin.
    const Box place =
        grow_box(place_, std::max(options_.accuracy.tolerance_mm, cutter.error_mm()) + slack_mm_);

    SampleBounds worst;
    const auto walk = [&](const gcode::Motion& part) {
        Samples samples =
            sample(part, followed, options_.sampling, place, options_.specified.get());
        SweepSimplification liberties = simplification_of(samples.turning);
        // A rapid move is followed without slack, so it does not meet material where a cut has
        // been.
        if (samples.turning.turn_rad > 0.0 && part.kind != gcode::MoveKind::Rapid) {
            liberties.slack_mm = std::clamp(gain_mm_ - samples.bounds.gained_mm, 0.0, slack_mm_);
            samples.bounds.gained_mm += liberties.slack_mm;
        }
        worst.missed_mm = std::max(worst.missed_mm, samples.bounds.missed_mm);
        worst.gained_mm = std::max(worst.gained_mm, samples.bounds.gained_mm);
        for (std::size_t i = 1; i < samples.poses.size(); ++i) {
            const Pose& X_WA = samples.poses[i - 1];
            const Pose& X_WB = samples.poses[i];
            // A tool at rest removes no more than the preceding step removed.
            if (X_WA == X_WB) continue;
            trace(tool, X_WA, X_WB, origin, liberties);
            if (goes_round) close_arc_run(cutter, X_WA, X_WB, origin);
            step({X_WA, X_WB, cells_, merged_cells_, preceding_cells_, sweeps_, is_near_,
                  samples.bounds, samples.turning});
            merged_cells_.clear();
            preceding_cells_.clear();
        }
    };

    const auto* linear = std::get_if<Linear>(&motion.action);
    const bool of_tip = motion.coordinates == gcode::Coordinates::Tip;
    if (!linear || motion.kind != gcode::MoveKind::Rapid || !options_.rapid.dog_leg || of_tip) {
        walk(motion);
        return worst;
    }
    for (const Linear& leg : legs_of(*linear, options_.rapid)) {
        gcode::Motion part = motion;
        part.action = leg;
        walk(part);
    }
    return worst;
}

}  // namespace ncsim::toolpath
