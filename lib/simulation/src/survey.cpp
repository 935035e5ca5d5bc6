// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics of the motions, choice of tools and stock, and reasons why a program cannot be
// simulated.
#include "ncsim/simulation/survey.h"

#include "ncsim/cda/cell.h"
#include "ncsim/gcode/dialect.h"
#include "ncsim/gcode/executed_text.h"
#include "ncsim/setup/tool_clues.h"
#include "ncsim/toolpath/kinematics.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/toolpath/trace.h"

#include "motions.h"
#include "operation_course.h"
#include "place_kinematics.h"
#include "simulation_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace ncsim::simulation {

namespace {

using toolpath::ValueSource;

// mm. No machine is that large: then a unit or a number is wrong.
constexpr double kLargestStock = 1e5;

void add_diagnostic(Survey& survey, const gcode::MessageText& message, gcode::SourceSpan span,
                    std::initializer_list<std::string_view> arguments = {}) {
    survey.diagnostics.push_back(gcode::diagnostic_of(message, span, arguments));
}

// Statistics of the motions, collected in one pass.
class MotionSurvey {
public:
    /// Uses the specified machine, or the default machine if null.
    MotionSurvey(Survey& result, const toolpath::Kinematics* specified,
                 std::span<const toolpath::OperationName> names)
        : result_(result), specified_machine_(specified), course_(names) {}

    struct ToolTrack {
        gcode::SourceSpan first;
        gcode::SourceSpan first_cut;     // line 0 if the tool does not cut
        bool cuts_after_change = false;  // whether it cuts after a tool change
        Box cutting_tips;                // ends of feed moves, mm
        double highest_tip = -std::numeric_limits<double>::infinity();
        toolpath::HighestLevels levels;
        Vec3 farthest_tip;  // distance from the axes X, Y and Z
        Vec3 travelled;     // along X, Y and Z at feed, back and forth
        // The same tips without lead-ins that begin in the air, and without their lead-outs.
        Box inner_tips;
        std::vector<Vec3> air;  // ends of rapid moves down to such lead-ins
        setup::ToolClues clues;
    };

    void take(const gcode::Motion& motion) {
        note_operation(motion);
        const gcode::Position* from = start_of(motion);
        const gcode::Position* to = end_of(motion);
        if (!from || !to) {
            const auto* change = std::get_if<gcode::ToolChange>(&motion.action);
            const int tool = change ? change->tool : motion.tool;
            result_.calls_tools |= change != nullptr;
            if (change || std::holds_alternative<gcode::Dwell>(motion.action)) {
                verify::add_rest(result_.distances[tool], motion);
                verify::add_rest(result_.operations.back().distances, motion);
            }
            return;
        }
        if (result_.moves++ == 0) result_.first_move = motion.span;
        const bool feed = motion.kind == gcode::MoveKind::Feed;
        if (feed) ++result_.feed_moves;
        result_.uses_machine_coordinates |= motion.machine_coordinates;
        result_.turns[0] |= to->a.degrees() != 0.0;
        result_.turns[1] |= to->b.degrees() != 0.0;
        result_.turns[2] |= to->c.degrees() != 0.0;
        const bool is_turned = to->a.degrees() != 0.0 || to->b.degrees() != 0.0 ||
                               to->c.degrees() != 0.0 || from->a.degrees() != 0.0 ||
                               from->b.degrees() != 0.0 || from->c.degrees() != 0.0;
        const bool of_tip = motion.coordinates == gcode::Coordinates::Tip;
        result_.uses_tip_control |= of_tip;
        std::array<bool, 3>& uvw = of_tip ? result_.uvw_of_tip : result_.uvw;
        uvw[0] |= to->u.mm() != 0.0;
        uvw[1] |= to->v.mm() != 0.0;
        uvw[2] |= to->w.mm() != 0.0;
        result_.turns_under_axes |= is_turned && !of_tip;
        specified_[0] |= motion.known_end.x;
        specified_[1] |= motion.known_end.y;
        specified_[2] |= motion.known_end.z;
        if (!toolpath::has_known_start(motion)) {
            if (toolpath::has_known_end(motion)) track_of(motion);
            ++result_.moves_without_start;
            if (feed && !result_.has_cut_without_start) {
                result_.has_cut_without_start = true;
                first_cut_without_start_ = motion.span;
            }
            return;
        }
        note_slanting_rapid(motion, *from, *to, is_turned);
        ToolTrack& track = track_of(motion);
        if (feed) result_.cutting_tools.insert(motion.tool);
        if (feed && track.first_cut.line == 0) track.first_cut = motion.span;
        if (feed && result_.calls_tools && !track.cuts_after_change) {
            track.cuts_after_change = true;
            if (motion.tool == 0) track.first_cut = motion.span;
        }
        note_path(motion, *from, *to, is_turned, track);
        if (feed) track.clues.take(motion, toolpath::Poses(specified_machine_, motion));
        const toolpath::Samples samples = verify::coarse_samples(motion, specified_machine_);
        if (feed) count_pieces(motion, *from, *to, is_turned, samples.poses.size() - 1);
        for (std::size_t i = 0; i < samples.poses.size(); ++i) {
            const Vec3 p = samples.poses[i].translation;
            result_.tip_positions.add(p);
            if (!feed) continue;
            track.cutting_tips.add(p);
            if (i == 0 && !path_.begins_in_air) track.inner_tips.add(p);
            if (i == 0) continue;
            path_.last_move.add(p);
            for (int axis = 0; axis < 3; ++axis)
                track.travelled[axis] += std::abs((p - samples.poses[i - 1].translation)[axis]);
            track.highest_tip = std::max(track.highest_tip, p.z);
            const Vec3 before = samples.poses[i - 1].translation;
            if (p.z == before.z && p != before) track.levels.add(p.z);
            for (int axis = 0; axis < 3; ++axis) {
                Vec3 out = p;
                out[axis] = 0.0;
                track.farthest_tip[axis] = std::max(track.farthest_tip[axis], norm(out));
            }
        }
        verify::add_path(result_.distances[motion.tool], motion, samples);
        verify::add_path(result_.operations.back().distances, motion, samples);
    }

    // Call after the last motion.
    void finish() {
        if (path_.track) end_path(*path_.track);
    }

    const std::map<int, ToolTrack>& tracks() const { return tracks_; }
    // Returns which of X, Y, Z any move specifies.
    const std::array<bool, 3>& specified() const { return specified_; }
    gcode::SourceSpan first_cut_without_start() const { return first_cut_without_start_; }

private:
    // Feed moves from one rapid move to the next.
    struct FeedPath {
        ToolTrack* track = nullptr;
        std::optional<Vec3> plunge_end;  // at rapid, to here
        bool begins_in_air = false;      // the move at hand is the first one, level
        std::optional<Vec3> air_start;   // of the first move, if that was so
        int moves = 0;
        Box last_move;  // tips, without the first
    };

    void end_path(ToolTrack& track) {
        constexpr int kLeadsAndMore = 3;
        const bool has_leads = path_.air_start && path_.moves >= kLeadsAndMore;
        if (!has_leads) track.inner_tips.add(path_.last_move);
        if (!has_leads && path_.air_start) track.inner_tips.add(*path_.air_start);
        path_ = {};
    }

    void note_path(const gcode::Motion& motion, const gcode::Position& from,
                   const gcode::Position& to, bool is_turned, ToolTrack& track) {
        const Vec3 start{from.x.mm(), from.y.mm(), from.z.mm()};
        const Vec3 end{to.x.mm(), to.y.mm(), to.z.mm()};
        if (path_.track && (path_.track != &track || motion.kind != gcode::MoveKind::Feed))
            end_path(*path_.track);
        if (motion.kind != gcode::MoveKind::Feed) {
            path_.plunge_end.reset();
            if (motion.kind == gcode::MoveKind::Rapid && end.z < start.z && !is_turned)
                path_.plunge_end = end;
            return;
        }
        path_.track = &track;
        if (!path_.last_move.is_empty()) track.inner_tips.add(path_.last_move);
        path_.last_move = {};
        constexpr std::size_t kMost = 10'000;
        path_.begins_in_air = path_.moves == 0 && path_.plunge_end == start && start.z == end.z &&
                              track.air.size() < kMost;
        if (path_.begins_in_air) {
            path_.air_start = start;
            track.air.push_back(start);
        }
        ++path_.moves;
    }

    void note_operation(const gcode::Motion& motion) {
        ++motions_;
        if (course_.take(motion)) result_.operations.emplace_back().first_motion = motions_;
        Survey::Operation& operation = result_.operations.back();
        operation.tool = course_.tool();
        if (const auto* name = course_.name()) {
            operation.name = name->name;
            operation.line = name->line;
        }
    }

    void note_slanting_rapid(const gcode::Motion& motion, const gcode::Position& from,
                             const gcode::Position& to, bool is_turned) {
        constexpr std::size_t kMost = 100'000;
        if (motion.kind != gcode::MoveKind::Rapid || is_turned) return;
        const int axes = int{from.x != to.x} + int{from.y != to.y} + int{from.z != to.z};
        if (axes < 2 || result_.slanting_rapids.size() == kMost) return;
        Box box;
        for (const gcode::Position* p : {&from, &to})
            box.add(Vec3{p->x.mm(), p->y.mm(), p->z.mm()});
        result_.slanting_rapids.push_back({box, motion.file, motion.span});
    }

    void count_pieces(const gcode::Motion& motion, const gcode::Position& from,
                      const gcode::Position& to, bool is_turned, std::size_t chords) {
        FeedPieces& pieces = result_.pieces[motion.tool];
        const bool turns = from.a != to.a || from.b != to.b || from.c != to.c;
        if (turns) {
            pieces.turning += chords;
        } else if (!std::holds_alternative<gcode::Linear>(motion.action)) {
            pieces.chords += chords;
        } else {
            ++(is_turned ? pieces.indexed : pieces.straight);
        }
    }

    ToolTrack& track_of(const gcode::Motion& motion) {
        const auto [track, is_new] = tracks_.try_emplace(motion.tool);
        if (is_new) track->second.first = motion.span;
        return track->second;
    }

    Survey& result_;
    const toolpath::Kinematics* specified_machine_;
    OperationCourse course_;
    std::uint64_t motions_ = 0;
    std::map<int, ToolTrack> tracks_;
    std::array<bool, 3> specified_{};
    gcode::SourceSpan first_cut_without_start_;
    FeedPath path_;
};

double lowest_tip(const MotionSurvey& motions) {
    double z = std::numeric_limits<double>::infinity();
    for (const auto& [number, track] : motions.tracks()) {
        if (!track.cutting_tips.is_empty()) z = std::min(z, track.cutting_tips.min.z);
    }
    return z;
}

// Returns a cutting length greater than the depth of any cut: no material may remain above a tool
// only because the tool's length is unspecified. Whole centimetres, for readability.
double assumed_length(const Survey& survey, const MotionSurvey& motions,
                      const std::optional<toolpath::StockEntry>& stock) {
    double depth = 0.0;
    const double low = lowest_tip(motions);
    const double top = stock ? stock->box.max.z : std::max(0.0, low);
    if (low < top) depth = top - low;
    if (stock && stock->place_assumed) depth = std::max(depth, stock->box.size().z);
    if (survey.turns_tools() && stock) depth = norm(stock->box.size());
    return 10.0 * std::ceil((std::clamp(depth, 20.0, kLargestStock) + 10.0) / 10.0);
}

// Returns the description for a tool number; null if there is none.
const toolpath::ToolEntry* entry_for(const Plan& plan, int number, bool is_only_tool,
                                     bool calls_tools) {
    if (const auto* entry = toolpath::find_tool(plan.job.tools, number)) return entry;
    // A program without tool calls uses the only described tool.
    if (number == 0 && is_only_tool && !calls_tools && plan.job.tools.size() == 1)
        return &plan.job.tools.front();
    return nullptr;
}

// True for a path at Z0, which cuts nothing with any tool.
bool touches_only(const Plan& plan, const Survey& result) {
    return result.is_flat() && (!plan.job.stock || plan.job.stock->box.max.z <= 0.0);
}

void choose_tools(const Plan& plan, const MotionSurvey& motions, Survey& result) {
    const double length = assumed_length(result, motions, plan.job.stock);
    for (const auto& [number, track] : motions.tracks()) {
        UsedTool used;
        used.first = track.first;
        toolpath::ToolSpec spec;
        if (const auto* entry =
                entry_for(plan, number, motions.tracks().size() == 1, result.calls_tools)) {
            spec = entry->spec;
            used.specified_by = entry->specified_by;
            used.span = entry->span;
            used.text = entry->text;
            used.file = entry->file;
        } else if (plan.job.options.assumed_tool) {
            spec = *plan.job.options.assumed_tool;
            used.specified_by = ValueSource::Assumption;
            used.text = spec.description;
        } else if (track.cutting_tips.is_empty() && !(result.only_rapid && plan.draft)) {
            continue;  // only positioned; its shape does not matter for a picture
        } else if (const std::string guess = track.clues.guess(result.interpretation.uses_inches);
                   plan.draft || touches_only(plan, result)) {
            std::string message;
            spec = toolpath::parse_tool_option("T1=" + guess, message).value();
            spec.description = guess;
            used.specified_by = ValueSource::Assumption;
            used.text = guess + (result.only_rapid ? ", as good as any: it cuts nothing"
                                                   : ", a guess from its moves");
        } else {
            const std::string name = std::to_string(number);
            if (number == 0 && result.calls_tools && track.cuts_after_change) {
                add_diagnostic(result, Message::SpindleEmpty, track.first_cut, {});
            } else if (number == 0) {
                add_diagnostic(result, Message::NoToolCalled, track.first, {guess});
            } else {
                add_diagnostic(result, Message::ToolUnknown,
                               track.first_cut.line > 0 ? track.first_cut : track.first,
                               {name, name, guess, name, guess});
            }
            result.ready = false;
            result.unknown_tools.emplace(number, track.first);
            continue;
        }
        spec.number = number;
        used.is_guess =
            used.specified_by == ValueSource::Assumption || toolpath::guesses_shape(spec);
        const toolpath::ToolSpec specified = toolpath::specified_part(spec);
        used.length_specified = specified.length || !specified.pieces.empty();
        used.spec = toolpath::filled(spec, length);
        if (used.specified_by == ValueSource::Assumption) used.spec.assumed = {"shape"};
        used.assumed_values_text = toolpath::assumed_values_text(spec, length);
        used.tool = toolpath::make_tool(spec, length);
        for (const std::string& what : toolpath::unsupported_values(spec)) {
            add_diagnostic(result, Message::ToolContradicts, track.first,
                           {std::to_string(number), what, toolpath::describe(used.tool)});
        }
        result.tools.emplace(number, std::move(used));
    }
}

toolpath::DerivedStock derive_stock(const Survey& survey, const Box& swept,
                                    const MotionSurvey::ToolTrack& all) {
    const auto& turns = survey.turns;
    if (survey.is_flat()) return toolpath::derive_sheet(all.cutting_tips);
    // A table that rotates about Z keeps the upper side of the part above.
    if (!turns[0] && !turns[1]) return toolpath::derive_stock(swept, all.highest_tip, all.levels);
    if (turns[0] && turns[1]) return toolpath::derive_block(all.cutting_tips);
    if (turns[2]) return toolpath::derive_block(all.cutting_tips);
    const int axis = turns[0] ? 0 : 1;
    return toolpath::derive_bar(swept, axis, all.farthest_tip[axis]);
}

// Shortens the box of a face mill. Face mills enter from outside the block and leave it completely:
// along the path, the box is a diameter longer than the block at both ends.
void leave_out_runs(Box& covered, int along, double diameter) {
    if (covered.size()[along] <= 3 * diameter) return;
    covered.min[along] += diameter;
    covered.max[along] -= diameter;
}

// Disc of radius `r` about `p` without stock, because a tool goes down there at rapid.
struct AirDisc {
    Vec3 p;
    double r = 0.0;
};

// Moves the sides of `box` inwards to the nearest side of each disc, unless this cuts off more than
// `r` of the milled tips `milled`. Returns true if a side moved.
bool leave_out_air(Box& box, const std::vector<AirDisc>& discs, const Box& milled) {
    bool has_moved = false;
    for (const AirDisc& disc : discs) {
        if (disc.p.z >= box.max.z) continue;
        int axis_of_least = -1;
        bool is_low = false;
        double least = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 2; ++axis) {
            const double low = disc.p[axis] + disc.r, high = disc.p[axis] - disc.r;
            if (low <= box.min[axis] || high >= box.max[axis]) {
                axis_of_least = -1;
                break;  // outside of the block
            }
            // Share of the block that is cut off.
            const double size = box.max[axis] - box.min[axis];
            const double from_low = (low - box.min[axis]) / size;
            const double from_high = (box.max[axis] - high) / size;
            if (low <= milled.min[axis] + disc.r && from_low < least) {
                least = from_low;
                axis_of_least = axis;
                is_low = true;
            }
            if (high >= milled.max[axis] - disc.r && from_high < least) {
                least = from_high;
                axis_of_least = axis;
                is_low = false;
            }
        }
        if (axis_of_least < 0) continue;
        (is_low ? box.min : box.max)[axis_of_least] =
            disc.p[axis_of_least] + (is_low ? disc.r : -disc.r);
        has_moved = true;
    }
    return has_moved;
}

// Returns the length that the intervals from `a` to `b` and from `min` to `max` share.
double common(double a, double b, double min, double max) {
    return std::min(b, max) - std::max(a, min);
}

// Places a block of known size: a corner or the centre is at zero, whichever includes most of the
// cuts. The top is at zero, unless all cuts are above zero.
void place_at_zero(Box& box, const Box& tips) {
    if (tips.is_empty()) return;
    const Vec3 size = box.size();
    for (int axis = 0; axis < 2; ++axis) {
        double best = -std::numeric_limits<double>::infinity();
        double at = box.min[axis];
        for (const double min : {0.0, -size[axis] / 2, -size[axis]}) {
            const double in = common(tips.min[axis], tips.max[axis], min, min + size[axis]);
            if (in > best) best = in, at = min;
        }
        box.min[axis] = at;
    }
    const bool on_bed = tips.min.z >= 0.0 && tips.max.z > 0.0;
    box.min.z = on_bed ? 0.0 : -size.z;
    box.max = box.min + size;
}

void choose_stock(const Plan& plan, const MotionSurvey& motions, Survey& result) {
    result.stock = plan.job.stock;
    if (result.stock) {
        Box tips;
        for (const auto& [number, track] : motions.tracks()) {
            if (!track.cutting_tips.is_empty()) tips.add(track.cutting_tips);
        }
        if (result.stock->place_assumed) place_at_zero(result.stock->box, tips);
        return;
    }
    Box swept, inner, milled;
    std::vector<AirDisc> discs;
    MotionSurvey::ToolTrack all;
    for (const auto& entry : motions.tracks()) {
        const MotionSurvey::ToolTrack& track = entry.second;
        const auto used = result.tools.find(entry.first);
        if (used == result.tools.end() || track.cutting_tips.is_empty()) continue;
        const double r = toolpath::cutting_diameter_of(used->second.tool) / 2;
        const double height = toolpath::cutting_height_of(used->second.tool);
        const auto covered_by = [&](Box covered) {
            for (int axis = 0; axis < 2; ++axis) {
                covered.min[axis] -= r;
                covered.max[axis] += r;
            }
            covered.max.z += height;
            if (used->second.tool.kind == toolpath::ToolKind::FaceMill)
                leave_out_runs(covered, track.travelled.x < track.travelled.y ? 1 : 0, 2 * r);
            return covered;
        };
        swept.add(covered_by(track.cutting_tips));
        if (!track.inner_tips.is_empty()) {
            inner.add(covered_by(track.inner_tips));
            milled.add(track.inner_tips);
        }
        for (const Vec3& p : track.air)
            discs.push_back({p, r});
        all.cutting_tips.add(track.cutting_tips);
        all.highest_tip = std::max(all.highest_tip, track.highest_tip);
        all.levels.add(track.levels);
        for (int axis = 0; axis < 3; ++axis)
            all.farthest_tip[axis] = std::max(all.farthest_tip[axis], track.farthest_tip[axis]);
    }
    toolpath::DerivedStock derived = derive_stock(result, swept, all);
    if (derived.stock.box.is_empty()) return;
    if (!discs.empty() && !inner.is_empty() && !result.turns_tools() && !result.is_flat()) {
        inner.min.z = swept.min.z;
        inner.max.z = swept.max.z;
        toolpath::DerivedStock smaller = derive_stock(result, inner, all);
        Box& box = smaller.stock.box;
        const bool has_moved = leave_out_air(box, discs, milled);
        const Vec3 size = box.size(), old = derived.stock.box.size();
        constexpr double kLeast = 0.5;  // of the larger block; less would be no lead-in
        const bool is_likely = size.x >= kLeast * old.x && size.y >= kLeast * old.y;
        const bool differs = has_moved || !(box == derived.stock.box);
        if (is_likely && differs) {
            smaller.rule +=
                "; without lead-ins that begin outside of it, where tools go down at rapid";
            derived = std::move(smaller);
        }
    }
    result.stock = toolpath::StockEntry{derived.stock, ValueSource::Assumption, {}, derived.rule};
}

// Returns a block around all positions of the tip; the margin gives points and lines a volume.
Box box_around_tips(const Box& tips) {
    const Vec3 around{1, 1, 1};  // mm
    Box box = tips;
    if (box.is_empty()) box.add(Vec3{0, 0, 0});
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = std::clamp(box.min[axis], -kLargestStock, kLargestStock);
        box.max[axis] = std::clamp(box.max[axis], -kLargestStock, kLargestStock);
    }
    return {box.min - around, box.max + around};
}

// Sets an empty stock; `box` is the visible block.
void set_no_stock(Survey& result, const Box& box) {
    toolpath::Stock nothing{box};
    const cda::Lattice lattice = cda::Lattice::for_stock(box);
    const cda::Cell all = cda::box_cell(lattice.round(box.min), lattice.round(box.max), lattice);
    nothing.shape = std::make_shared<const cda::Shape>(cda::Shape{lattice, all, {all}});
    result.stock = toolpath::StockEntry{
        nothing, ValueSource::Assumption, {}, "nothing, since the program cuts nothing"};
}

bool hits_step_limit(const gcode::Diagnostics& diagnostics) {
    return std::ranges::any_of(diagnostics,
                               [](const gcode::Diagnostic& d) { return d.code == "step-limit"; });
}

}  // namespace

namespace {

void report_unspecified(Survey& result) {
    std::string names;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (result.unspecified[axis])
            names.append(names.empty() ? "" : ", ").append(1, "XYZ"[axis]);
    }
    if (names.empty()) return;
    const bool is_path = result.is_flat() && result.ready;
    add_diagnostic(result, is_path ? Message::AxisUnspecifiedOfPath : Message::AxisUnspecified,
                   result.first_move, {names});
}

struct BlockEstimate {
    Survey survey;
    std::array<bool, 3> specified;  // X, Y, Z, specified by a move or by the start
    std::shared_ptr<const std::vector<gcode::Motion>> motions;
};

// Returns how A, B and C rotate the tool, with the assumptions.
std::string rotation_of(const Plan& plan, const Survey& survey) {
    if (!plan.kinematics)
        return "assumed: A, B, C turn the tool about X, Y, Z through the program zero";
    std::string text = "as the machine file specifies";
    if (survey.uses_tip_control) text += ", X Y Z are the tip's under tip control";
    const bool by_tips = !survey.turns_under_axes && !survey.interpretation.requested_tip_positions;
    const std::string guess =
        kinematics_guess(plan, survey.interpretation.workpiece,
                         {survey.turns, survey.uvw, survey.uvw_of_tip}, by_tips);
    return guess.empty() ? text : text + "; assumed: " + guess;
}

BlockEstimate estimate_block(const Plan& plan, const std::array<bool, 3>& unspecified) {
    BlockEstimate look;
    Survey& result = look.survey;
    result.unspecified = unspecified;
    MotionSurvey motions(result, plan.placed.get(), plan.job.operations);
    MotionRecorder recorder;
    result.interpretation =
        gcode::interpret(plan.job.program, plan.job.interpreter, [&](const gcode::Motion& m) {
            motions.take(m);
            recorder.take(m);
        });
    look.motions = std::move(recorder).result();
    motions.finish();
    look.specified = motions.specified();
    result.units_assumed = !result.interpretation.units_stated && plan.job.units_assumed;
    result.rotation = rotation_of(plan, result);
    result.diagnostics = result.interpretation.diagnostics;
    result.diagnostics.insert(result.diagnostics.end(), plan.job.diagnostics.begin(),
                              plan.job.diagnostics.end());

    if (result.interpretation.refused) return look;  // and the interpreter reported why
    // A program that does not end needs no second run to know this.
    result.never_ends = hits_step_limit(result.diagnostics);
    if (result.never_ends) return look;
    result.ready = true;
    if (result.moves == 0 || (result.feed_moves == 0 && !plan.job.stock)) {
        result.only_rapid = result.moves > 0;
        const bool drawn = result.only_rapid && plan.draft;
        add_diagnostic(result,
                       result.moves == 0 ? Message::NoMove
                       : drawn           ? Message::OnlyRapidMovesDrawn
                                         : Message::OnlyRapidMoves,
                       result.first_move);
        if (result.only_rapid) choose_tools(plan, motions, result);
        if (drawn) set_no_stock(result, box_around_tips(result.tip_positions));
        result.ready = drawn;
        return look;
    }
    if (result.has_cut_without_start) {
        add_diagnostic(result, Message::StartUnknown, motions.first_cut_without_start());
    }
    choose_tools(plan, motions, result);
    if (!result.ready) return look;
    choose_stock(plan, motions, result);
    if (!result.stock) {
        add_diagnostic(result, Message::CutsFromNowhere, result.first_move);
        result.ready = false;
        return look;
    }
    const Box& box = result.stock->box;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::max(std::abs(box.min[axis]), std::abs(box.max[axis])) > kLargestStock) {
            add_diagnostic(
                result, Message::StockSize, result.stock->span,
                {fmt::format("{:.6g}", box.min[axis]), fmt::format("{:.6g}", box.max[axis])});
            result.ready = false;
            break;
        }
    }
    return look;
}

}  // namespace

Survey survey(Plan& plan) {
    plan.motions = nullptr;
    auto& of_file = plan.job.interpreter.of_file;
    if (!of_file) {
        const gcode::ExecutedText executed(plan.job.program, plan.job.interpreter);
        of_file =
            std::make_shared<const gcode::DialectFindings>(gcode::detect_dialect(executed.file()));
    }
    place_kinematics(plan);
    BlockEstimate look = estimate_block(plan, {});
    const Survey& first = look.survey;
    const bool drawn = first.feed_moves > 0 || (first.only_rapid && plan.draft);
    if (!first.interpretation.refused && drawn) {
        std::array<bool, 3> unspecified{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            unspecified[axis] = !look.specified[axis];
            if (unspecified[axis]) plan.job.interpreter.start[axis] = gcode::Length();
        }
        if (unspecified != std::array<bool, 3>{}) look = estimate_block(plan, unspecified);
        report_unspecified(look.survey);
    }
    // The rules look at fewer iterations of a program that does not end.
    if (!look.survey.never_ends) plan.motions = std::move(look.motions);
    return std::move(look.survey);
}

std::string reason_not_simulated(const Survey& survey) {
    for (const gcode::Diagnostic& d : survey.diagnostics) {
        if (d.severity == gcode::Severity::Error) return d.message;
    }
    return "there is nothing to simulate";
}

void set_empty_stock(Survey& survey) {
    const auto is_it = [](const gcode::Diagnostic& d) { return d.code == "no-motion"; };
    std::erase_if(survey.diagnostics, is_it);
    Box box;
    box.add(Vec3{0, 0, 0}), box.add(Vec3{1, 1, 1});
    set_no_stock(survey, box);
    survey.ready = true;
}

}  // namespace ncsim::simulation
