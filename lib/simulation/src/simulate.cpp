// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simulation: NC text → motions → poses → hulls → part. The data flow through all stages, and no
// stage keeps more than a motion.
#include "ncsim/simulation/simulate.h"

#include "ncsim/base/file_names.h"
#include "ncsim/cda/cell.h"
#include "ncsim/cda/shape.h"
#include "ncsim/simulation/models.h"
#include "ncsim/simulation/play_recorder.h"
#include "ncsim/simulation/stock_history.h"
#include "ncsim/toolpath/walk.h"

#include "join_moves.h"
#include "motions.h"
#include "operation_course.h"
#include "simulation_messages.h"
#include "until_line.h"
#include "upright_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::simulation {

namespace {

double current_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

// Returns the number of halvings: more blocks for longer programs. The number depends on the
// program alone, so runs with and without tiles have the same blocks.
int halvings_for(std::uint64_t moves) {
    constexpr int kLeast = 6;
    constexpr std::uint64_t kMovesOfABlock = 512;
    int halvings = kLeast;
    while (halvings < cda::kMostHalvings && (moves >> halvings) > kMovesOfABlock)
        ++halvings;
    return halvings;
}

// Checks the budget between the tasks of a model until the simulation ends. Later queries of the
// part are not limited.
class Interrupt {
public:
    explicit Interrupt(const Plan& plan) : budget_(plan.budget), program_(plan.job.program.name) {}
    ~Interrupt() { *is_armed_ = false; }
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::function<void()> function() const {
        return [is_armed = is_armed_, budget = budget_, program = program_] {
            if (*is_armed) budget.check(program);
        };
    }

private:
    setup::Budget budget_;
    std::string program_;
    std::shared_ptr<std::atomic<bool>> is_armed_ = std::make_shared<std::atomic<bool>>(true);
};

std::unique_ptr<cda::WorkpieceModel> prototype(const Plan& plan, std::uint64_t moves,
                                               const Interrupt& interrupt) {
    ModelParameters parameters;
    parameters.threads = plan.threads;
    if (plan.hull_times) parameters.clock = &current_seconds;
    parameters.resolution_mm = plan.resolution;
    parameters.only_along_z = plan.rays == RayDirections::AlongZ;
    parameters.halvings = halvings_for(moves);
    parameters.tile = plan.tile;
    parameters.interrupt = interrupt.function();
    if (plan.tiles) parameters.tiles = plan.tiles->tiles;
    return make_model(plan.model, parameters);
}

toolpath::WalkOptions walk_options(const Plan& plan, const Survey& survey,
                                   const Verification& verification, bool prefers_sweeps) {
    // Saved cells may be verified later, which needs a known side of the error.
    const auto side = !plan.keep_removed_cells ? verification.side : toolpath::Side::Circumscribed;
    return {.accuracy = {plan.tool_tolerance, side, survey.turns_tools()},
            .sampling = {.chord_tolerance_mm = plan.tolerance,
                         .rotation_miss_mm = plan.tolerance,
                         .rotation_gain_mm = 10 * plan.tolerance},
            .rapid = verification.rapid,
            .watch = verification.watch,
            .specified = plan.placed,
            .prefers_sweeps = prefers_sweeps,
            .merges_cells = !verification.own_lines};
}

[[noreturn]] void refuse_tiles() {
    throw std::runtime_error("the tiles do not agree on which motions met the stock");
}

// Share of a process in the cuts of a part; here, all cuts. Motions are counted from 1, in the
// order of execution.
class CutShare {
public:
    explicit CutShare(const Simulation& result) : result_(result) {}
    virtual ~CutShare() = default;
    // Limits the cells of a motion to the share. Returns the origin of the motion.
    virtual cda::Origin begin(std::uint64_t) {
        return cda::Origin{static_cast<std::uint32_t>(result_.provenance.entries.size())};
    }
    // Returns whether the result names the motion, because the motion met the stock. The process
    // cut `hulls` cells; `is_met`: the cells, or combined cells, are of this motion.
    virtual bool end(std::uint64_t, std::uint64_t /*hulls*/, bool is_met) { return is_met; }
    // Completes the result after the last motion. Throws: std::runtime_error if the tiles do not
    // agree on the motions that met the stock.
    virtual void finish() {}

private:
    const Simulation& result_;
};

// The cuts of one tile. A tile does not know which motions met the stock elsewhere, so the number
// of the motion is the origin; the order is the same. Tiles record these motions in turns, and name
// none.
class OneTile final : public CutShare {
public:
    OneTile(cda::TileNumber tile, toolpath::Walk& walk, Simulation& result)
        : CutShare(result),
          tile_(tile),
          walk_(walk),
          result_(result),
          place_(result.part->wanted()) {}

    cda::Origin begin(std::uint64_t motion) override {
        walk_.restrict_motions(is_turn(motion) ? std::nullopt : place_);
        return cda::Origin{earlier_origins(result_.history.get()) +
                           static_cast<std::uint32_t>(motion)};
    }
    bool end(std::uint64_t motion, std::uint64_t hulls, bool is_met) override {
        if (is_met && is_turn(motion)) result_.stock_contacts.push_back({motion, hulls});
        return false;
    }

private:
    bool is_turn(std::uint64_t motion) const { return motion % tile_.of == tile_.tile; }

    cda::TileNumber tile_;
    toolpath::Walk& walk_;
    Simulation& result_;
    std::optional<Box> place_;
};

// No cuts, because processes with one tile each made all cuts.
class JoinedTiles final : public CutShare {
public:
    JoinedTiles(const std::vector<StockContact>& contacts, toolpath::Walk& walk, Simulation& result)
        : CutShare(result), contacts_(contacts), result_(result) {
        walk.restrict_cells(Box{});
    }

    bool end(std::uint64_t motion, std::uint64_t, bool) override {
        if (next_ == contacts_.size() || contacts_[next_].motion != motion) return false;
        result_.hulls += contacts_[next_++].hulls;
        result_.origins.emplace_back(motion, result_.provenance.entries.size());
        return true;
    }
    void finish() override {
        if (result_.boundary) name_motions(*result_.boundary, result_);
        if (next_ != contacts_.size()) refuse_tiles();
    }

private:
    const std::vector<StockContact>& contacts_;
    Simulation& result_;
    std::size_t next_ = 0;  // index into contacts_
};

std::unique_ptr<CutShare> cut_share(const Plan& plan, toolpath::Walk& walk, Simulation& result) {
    if (plan.tile) return std::make_unique<OneTile>(*plan.tile, walk, result);
    if (plan.tiles) return std::make_unique<JoinedTiles>(plan.tiles->stock_contacts, walk, result);
    return std::make_unique<CutShare>(result);
}

// Cuts the part, motion by motion.
class MaterialRemover {
public:
    MaterialRemover(const Plan& plan, const Survey& survey, const Verification& verification,
                    Simulation& result)
        : result_(result),
          sweeps_(dynamic_cast<cda::SweepModel*>(result.part.get())),
          verified_(dynamic_cast<const cda::VerifyingModel*>(result.part.get())),
          walk_(result.lattice, survey.stock->box,
                walk_options(plan, survey, verification, sweeps_ != nullptr)),
          share_(cut_share(plan, walk_, result)),
          verifier_(verification.verifier),
          decide_(verification.decide),
          most_cuts_(verification.most_cuts),
          only_motion_(verification.only_motion),
          nearest_to_(verification.nearest_to),
          last_removes_nothing_(verification.last_removes_nothing),
          most_steps_(verification.most_steps.value_or(std::numeric_limits<std::uint64_t>::max())),
          shows_path_(plan.keep_paths),
          measured_(verifier_ && verifier_->measures_all()),
          keep_cuts_(verification.keep_cuts),
          play_(verification.play),
          keeps_cells_(plan.keep_removed_cells),
          budget_(plan.budget),
          tolerance_mm_(plan.tolerance),
          machine_(plan.placed),
          // Volumes measured by tiles are in their files, in the order of the tool changes.
          tool_volumes_(plan.tool_volumes || plan.tile || plan.tiles),
          volume_(result.stock_volume),
          course_(plan.job.operations),
          runs_([&result](std::size_t cut, const gcode::Linear& line, double moved_mm) {
              set_path(result.cuts[cut], line).moved_mm = moved_mm;
          }) {
        for (const auto& [number, used] : survey.tools) {
            const toolpath::Cutter& cutter = walk_.add_tool(number, used.tool);
            result.cutters[number] = {cutter.sides(), cutter.error_mm()};
        }
        result.provenance.program = base_name(plan.job.program.name);
        begin_provenance(verification.history.get());
        if (play_) play_->begin(*result.part);
        if (plan.block_volumes) places_.emplace();
        if (places_ || (verifier_ && verifier_->needs_account())) accounts().track_removal();
    }

    /// Ignores all motions after the first `count`.
    void stop_after(std::uint64_t count) { most_motions_ = count; }

    /// Cuts the next `count` motions of the program, which were joined to `motion`.
    void take(const gcode::Motion& motion, std::size_t count) {
        const std::size_t cuts_before = result_.cuts.size();
        remove(motion, count);
        numbered_ += count;
        // On specified machines, any move may rotate the tool.
        if (!keep_cuts_ || machine_) return;
        const bool has_cut = result_.cuts.size() > cuts_before;
        runs_.take(motion, has_cut ? std::optional(cuts_before) : std::nullopt);
    }

    /// Updates surface and volume of the result.
    void pause(bool needs_surface) {
        if (needs_surface) result_.boundary = result_.part->boundary();
        result_.part_volume = result_.part->volume();
    }

    /// Completes the result. Requires: the last motion was added.
    void finish(bool needs_surface) {
        // Computes the surface first, because this also computes the volume.
        if (needs_surface) result_.boundary = result_.part->boundary();
        share_->finish();
        runs_.flush();
        const auto tool_position = result_.tool_position;
        change_tool(0);
        if (tool_volumes_ && !verifier_) result_.removed_by_operation.resize(operation_ + 1);
        result_.tool_position = tool_position;
        result_.part_volume = verifier_ || !tool_volumes_ ? result_.part->volume() : volume_;
        result_.part_volume_error = result_.part->volume_error();
        if (const auto aliasing = result_.part->aliasing()) {
            const auto line_of = [&](cda::Origin origin) {
                return result_.provenance.entries[static_cast<std::size_t>(origin)].nc_line;
            };
            result_.aliasing.emplace(AliasingFacts{*aliasing, line_of(aliasing->material.origin),
                                                   line_of(aliasing->gaps.origin)});
        }
        if (!places_) return;
        for (const auto& [origin, taken] : accounts().account()) {
            const auto place = places_->find(origin);
            if (place != places_->end() && taken.volume > 0.0)
                result_.removed_by_block[place->second] += taken.volume;
        }
    }

private:
    cda::AccountingModel& accounts() { return dynamic_cast<cda::AccountingModel&>(*result_.part); }

    static CutPath& set_path(CutRecord& cut, const gcode::Linear& line) {
        const auto place = [](const gcode::Position& p) {
            return Vec3{p.x.mm(), p.y.mm(), p.z.mm()};
        };
        if (!cut.path) cut.path = std::make_unique<CutPath>();
        cut.path->from = place(line.from);
        cut.path->to = place(line.to);
        return *cut.path;
    }

    void record_cut(const gcode::Motion& motion, std::size_t count) {
        CutRecord& cut = result_.cuts.emplace_back();
        cut.place = result_.last_cut;
        cut.motion = numbered_ + 1;
        cut.tool = motion.tool;
        const std::optional<Vec3> line_start = walk_.line_start();
        if (count == 1 && !line_start) return;
        set_path(cut, std::get<gcode::Linear>(motion.action)).line_start = line_start;
    }

    void remove(const gcode::Motion& motion, std::size_t count) {
        line_ = motion.span.line;
        if (motions_ == most_motions_) return;
        ++motions_;
        result_.line = line_;
        verify::add(result_.distances, motion, machine_.get());
        if (machine_ && start_of(motion)) result_.last_move = motion;
        if (most_cuts_ && result_.provenance.entries.size() > *most_cuts_) return;
        if (course_.take(motion)) begin_operation();
        if (motion.tool != tool_) change_tool(motion.tool);
        const std::uint64_t hulls_before = result_.hulls;
        const cda::Origin origin = share_->begin(motions_);
        has_covered_ = false;
        if (play_) play_->begin_move(motion);
        verify::Verifier* const verifier =
            !only_motion_ || *only_motion_ == motions_ ? verifier_ : nullptr;
        if (verifier) verifier->begin(motion, verified_);
        const toolpath::SampleBounds bounds =
            walk_.take(motion, origin, [&](const toolpath::Step& step) {
                if (++result_.steps > most_steps_) throw StepLimit{};
                follow(motion, step);
                is_near_stock_ |= step.is_near;
                if (verifier) verifier->before_cut(step);
                if (last_removes_nothing_ && motions_ == most_motions_) return;
                const double removed = cut(step, origin);
                if (play_) play_->add_step(step);
                if (verifier) verifier->after_cut(step, removed);
                budget_.check(result_.provenance.program, line_);
            });
        if (verifier) {
            walk_.at_end_position(motion, origin, [&](const toolpath::Step& step) {
                verifier->at_end_position(step);
            });
            end_motion(*verifier);
        } else if (!verifier_ && bounds.missed_mm > 1.001 * tolerance_mm_) {
            add_missed(motion, bounds.missed_mm);
        }
        const std::uint64_t hulls = result_.hulls - hulls_before;
        const bool has_met = share_->end(motions_, hulls, hulls > 0 || has_covered_);
        if (play_) play_->end_move(has_met, *result_.part);
        if (!has_met) return;
        result_.last_cut = {motion.file, motion.span};
        result_.last_motion = motions_;
        result_.provenance.entries.push_back(
            {motion.span.line, static_cast<std::uint32_t>(std::max(0, motion.tool))});
        if (keep_cuts_) record_cut(motion, count);
        if (places_) (*places_)[origin] = {motion.file, motion.span.line};
        result_.bounds.missed_mm = std::max(result_.bounds.missed_mm, bounds.missed_mm);
        result_.bounds.gained_mm = std::max(result_.bounds.gained_mm, bounds.gained_mm);
    }

    // Adds the stock and the motions of earlier runs.
    void begin_provenance(const StockHistory* history) {
        mesh::Provenance& provenance = result_.provenance;
        provenance.entries.push_back({});
        if (history) {
            provenance.entries = history->entries;
            provenance.earlier_programs = history->programs;
        }
        if (keep_cuts_) result_.cuts.resize(provenance.entries.size());
    }

    void end_motion(verify::Verifier& verifier) {
        const auto contacts = verifier.end_steps();
        std::vector<verify::ContactDecision> decisions;
        if (!contacts.empty() && decide_)
            std::ranges::transform(contacts, std::back_inserter(decisions), decide_);
        verifier.judge(decisions);
    }

    // Sets the position of the tool to the pose of the step that is nearest to the point.
    void approach(const gcode::Motion& motion, const toolpath::Step& step) {
        if (approached_ != motions_) nearest_mm_ = std::numeric_limits<double>::infinity();
        approached_ = motions_;
        constexpr int kPoses = 32;
        for (int i = 0; i <= kPoses; ++i) {
            const double t = static_cast<double>(i) / kPoses;
            toolpath::Pose pose = t < 0.5 ? step.X_WA : step.X_WB;
            pose.translation = (1.0 - t) * step.X_WA.translation + t * step.X_WB.translation;
            const double distance = norm(pose.translation - *nearest_to_);
            if (distance >= nearest_mm_) continue;
            nearest_mm_ = distance;
            result_.tool_position = {motion.tool, pose};
        }
    }

    void follow(const gcode::Motion& motion, const toolpath::Step& step) {
        if (nearest_to_) {
            approach(motion, step);
        } else {
            result_.tool_position = {motion.tool, step.X_WB};
        }
        if (!shows_path_) return;
        const bool is_rapid = motion.kind == gcode::MoveKind::Rapid;
        auto& paths = result_.paths;
        if (paths.empty() || paths.back().is_rapid != is_rapid ||
            paths.back().points.back() != step.X_WA.translation) {
            paths.push_back({{step.X_WA.translation}, is_rapid});
        }
        paths.back().points.push_back(step.X_WB.translation);
    }

    // Removes the cells of the step. Returns the removed volume, mm³, if it is measured.
    double cut(const toolpath::Step& step, cda::Origin origin) {
        double removed = 0.0;
        if (verifier_ && !step.preceding_cells.empty())
            result_.part->subtract_step({}, {}, step.preceding_cells);
        for (const cda::RoundSweep& sweep : step.sweeps) {
            ++result_.hulls;
            sweeps_->subtract_sweep(sweep);
        }
        for (const cda::Cell& cell : step.cells) {
            ++result_.hulls;
            if (keeps_cells_) result_.carved.push_back(cell);
            if (measured_) {
                removed += result_.part->subtract(cell);
            } else if (verifier_) {
                result_.part->subtract_unmeasured(cell);
            }
        }
        // The combined cells may include the current motion.
        has_covered_ |= std::ranges::any_of(
            step.merged_cells, [&](const cda::Cell& cell) { return cell.origin == origin; });
        if (verifier_) {
            if (!step.merged_cells.empty()) result_.part->subtract_step({}, step.merged_cells);
            return removed;
        }
        // Only steps near the stock are counted, by tiles as well; so cells of a step that is not
        // near are kept for the next near step.
        if (!step.is_near || !combined_cells_.empty())
            combined_cells_.insert(combined_cells_.end(), step.preceding_cells.begin(),
                                   step.preceding_cells.end());
        if (step.is_near) {
            result_.part->subtract_step(step.cells, step.merged_cells,
                                        combined_cells_.empty()
                                            ? step.preceding_cells
                                            : std::span<const cda::Cell>(combined_cells_));
            combined_cells_.clear();
        } else {
            combined_cells_.insert(combined_cells_.end(), step.merged_cells.begin(),
                                   step.merged_cells.end());
        }
        return removed;
    }

    // Accounts the volume that was removed since the last call to the tool and the operation.
    void account_removal() {
        if (is_near_stock_ && tool_volumes_ && !verifier_) {
            const double volume = result_.part->volume();
            result_.removed_by_tool[tool_] += volume_ - volume;
            result_.removed_by_operation.resize(operation_ + 1);
            result_.removed_by_operation[operation_] += volume_ - volume;
            volume_ = volume;
        }
        is_near_stock_ = false;
    }

    void begin_operation() {
        account_removal();
        operation_ = course_.number();
    }

    void change_tool(int next) {
        account_removal();
        tool_ = next;
        result_.tool_position.reset();
    }

    void add_missed(const gcode::Motion& motion, double missed_mm) {
        if (!result_.diagnostics.empty()) {
            ++result_.diagnostics.front().count;
            return;
        }
        result_.diagnostics.push_back(gcode::diagnostic_of(
            Message::PathAccuracy, motion.span,
            {fmt::format("{:.3g}", missed_mm), fmt::format("{:g}", tolerance_mm_)}));
    }

    Simulation& result_;
    cda::SweepModel* sweeps_;              // null: the part is cut by cells alone
    const cda::VerifyingModel* verified_;  // null: the part is not verified
    toolpath::Walk walk_;
    std::unique_ptr<CutShare> share_;
    verify::Verifier* verifier_;
    std::function<verify::ContactDecision(const verify::OpenContact&)> decide_;
    std::optional<std::uint32_t> most_cuts_;
    std::optional<std::uint64_t> only_motion_;
    std::optional<Vec3> nearest_to_;
    bool last_removes_nothing_;
    std::uint64_t approached_ = 0;  // motion to which nearest_mm_ belongs
    double nearest_mm_ = 0.0;
    std::uint64_t most_steps_;
    std::uint64_t motions_ = 0;
    std::uint64_t most_motions_ = std::numeric_limits<std::uint64_t>::max();
    bool shows_path_;
    bool measured_;  // cell by cell
    // By origin, if volumes of blocks are requested.
    std::optional<std::map<cda::Origin, BlockPlace>> places_;
    bool keep_cuts_;
    PlayRecorder* play_;
    bool keeps_cells_;
    setup::Budget budget_;
    double tolerance_mm_;
    std::shared_ptr<const toolpath::Kinematics> machine_;
    std::uint32_t line_ = 0;  // line of the current motion
    int tool_ = 0;
    bool tool_volumes_;
    double volume_;               // at the last tool change
    bool is_near_stock_ = false;  // whether the tool was near the stock since its change
    OperationCourse course_;
    UprightRuns runs_;            // of recorded cuts
    std::uint64_t numbered_ = 0;  // motions of the program so far, without joining
    std::size_t operation_ = 0;
    bool has_covered_ = false;               // whether combined cells belong to the current motion
    std::vector<cda::Cell> combined_cells_;  // combined cells of steps that are not near
};

}  // namespace

std::uint32_t earlier_origins(const StockHistory* history) {
    return history ? static_cast<std::uint32_t>(history->entries.size() - 1) : 0;
}

void name_motions(cda::Boundary& boundary, const Simulation& simulation) {
    const auto& origins = simulation.origins;
    const cda::Origin last_earlier{earlier_origins(simulation.history.get())};
    for (cda::BoundaryFace& face : boundary.faces) {
        if (face.origin <= last_earlier) continue;
        const auto motion =
            static_cast<std::uint64_t>(face.origin) - static_cast<std::uint64_t>(last_earlier);
        const auto found =
            std::ranges::lower_bound(origins, motion, {}, [](const auto& o) { return o.first; });
        if (found == origins.end() || found->first != motion) refuse_tiles();
        face.origin = cda::Origin{static_cast<std::uint32_t>(found->second)};
    }
}

cda::Boundary surface_of(const Simulation& simulation) {
    cda::Boundary boundary = simulation.part->boundary();
    if (!simulation.origins.empty()) name_motions(boundary, simulation);
    return boundary;
}

cda::Boundary surface_of_program(const Simulation& simulation) {
    cda::Boundary boundary = surface_of(simulation);
    const cda::Origin last_earlier{earlier_origins(simulation.history.get())};
    for (cda::BoundaryFace& face : boundary.faces) {
        if (face.origin <= last_earlier) face.origin = cda::kStockOrigin;
    }
    return boundary;
}

Simulation simulate(const Plan& plan, const Survey& survey, const Verification& verification,
                    const ProgressSink& progress, const CutObserver& observer) {
    if (verification.verifier) require_verifying(plan);
    Simulation result;
    cda::Shape stock = toolpath::stock_shape(*survey.stock, plan.tool_tolerance);
    result.history = verification.history;
    if (!result.history) {
        for (cda::Cell& cell : stock.carved)
            cell.origin = cda::kStockOrigin;
    }
    result.lattice = stock.lattice;
    const Interrupt interrupt(plan);
    result.part = cda::create(*prototype(plan, survey.moves, interrupt), stock);
    result.stock_volume = result.part->volume();
    if (verification.start) result.part = verification.start->clone();

    MaterialRemover mill(plan, survey, verification, result);
    const std::uint64_t most = plan.at_line ? motions_until(plan, *plan.at_line)
                                            : std::numeric_limits<std::uint64_t>::max();
    mill.stop_after(verification.only_motion.value_or(most));
    std::uint64_t motions = 0;
    std::uint64_t moves = 0;
    MoveJoiner joiner(
        verification.verifier ? 0.0 : plan.join_tolerance,
        [&](const gcode::Motion& motion, std::size_t count) { mill.take(motion, count); },
        plan.job.operations);
    for_each_motion(plan, [&](const gcode::Motion& motion) {
        joiner.take(motion);
        ++motions;
        if (!start_of(motion)) return;
        ++moves;
        if (progress) progress(moves);
        if (observer.every == 0 || moves % observer.every != 0 || motions > most) return;
        mill.pause(plan.keep_boundary);
        observer.observe(result);
    });
    joiner.flush();
    if (joiner.has_joined()) {
        result.bounds.missed_mm += plan.join_tolerance;
        result.bounds.gained_mm += plan.join_tolerance;
    }
    mill.finish(plan.keep_boundary);
    return result;
}

Simulation simulate(Plan plan) {
    const Survey seen = survey(plan);
    if (!seen.is_ready()) throw std::runtime_error(reason_not_simulated(seen));
    return simulate(plan, seen, {}, {});
}

}  // namespace ncsim::simulation
