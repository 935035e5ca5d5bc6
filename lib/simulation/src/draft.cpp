// SPDX-License-Identifier: GPL-3.0-or-later
//
// Choice of model, directions of rays, resolution and tolerances of drafts.
#include "ncsim/simulation/draft.h"

#include "ncsim/dexel/dexel.h"
#include "ncsim/simulation/models.h"
#include "ncsim/toolpath/tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ncsim::simulation {

namespace {

// True if the radius of the cutting part never decreases upwards.
bool is_open_above(const toolpath::Tool& tool) {
    double widest = 0.0;
    for (const toolpath::ToolPiece& piece : tool.pieces) {
        if (!piece.cutting) continue;
        for (const toolpath::ProfilePoint& p : piece.profile) {
            if (p.radius < widest) return false;
            widest = p.radius;
        }
    }
    return true;
}

// True if the lower end is a ball, a point, or fully rounded.
bool has_no_flat(const toolpath::Tool& tool) {
    if (tool.kind == toolpath::ToolKind::Drill) return false;
    for (const toolpath::ToolPiece& piece : tool.pieces) {
        if (!piece.cutting || piece.profile.empty()) continue;
        return piece.profile.front().radius <= piece.profile.front().fillet;
    }
    return false;
}

// True if each cutting piece is a cylinder: its hulls have a plane for each side, and two ends.
bool is_plain_flat(const toolpath::Tool& tool) {
    return std::ranges::all_of(tool.pieces, [](const toolpath::ToolPiece& piece) {
        if (!piece.cutting || piece.profile.empty()) return true;
        return std::ranges::all_of(piece.profile, [&](const toolpath::ProfilePoint& p) {
            return p.radius == piece.profile.front().radius && p.fillet == 0.0;
        });
    });
}

}  // namespace

void choose_model(Plan& plan, const Survey& survey) {
    if (!plan.draft || plan.is_model_specified || survey.moves < kLongProgram) return;
    const auto has_resolution = [](const ModelInfo& model) { return model.has_resolution; };
    const bool needs_exact = plan.keep_removed_cells || plan.block_volumes || plan.needs_exact;
    if (needs_exact || plan.tile || plan.tiles) return;
    plan.model = std::ranges::find_if(models(), has_resolution)->name;
    plan.is_model_chosen = true;
}

void choose_rays(Plan& plan, const Survey& survey) {
    const ModelInfo* model = find_model(plan.model);
    if (!model || !model->has_resolution || !survey.is_ready()) return;
    const auto tools_are = [&](bool (*suitable)(const toolpath::Tool&)) {
        return std::ranges::all_of(survey.tools,
                                   [&](const auto& known) { return suitable(known.second.tool); });
    };
    const bool is_possible = !survey.turns_tools() && tools_are(is_open_above);
    if (plan.rays == RayDirections::AlongZ && !is_possible) {
        throw std::runtime_error(
            "--rays z: a tool turns or is wider below than above, and leaves what rays along Z "
            "alone do not show");
    }
    if (plan.rays != RayDirections::Chosen) return;
    plan.rays =
        is_possible && tools_are(has_no_flat) ? RayDirections::AlongZ : RayDirections::AlongAll;
}

void choose_resolution(Plan& plan, const Survey& survey) {
    const ModelInfo* model = find_model(plan.model);
    if (!model || !model->has_resolution || !survey.is_ready()) return;
    const Vec3 size = survey.stock->box.size();
    const double finest = dexel::finest_resolution(size);
    if (plan.resolution > 0.0 && plan.resolution < finest) {
        throw std::runtime_error(fmt::format(
            "a resolution of {:g} mm is too fine for this stock: {:.2g} mm is the finest",
            plan.resolution, finest));
    }
    if (plan.resolution == 0.0)
        plan.resolution = dexel::default_resolution(std::max({size.x, size.y, size.z}));
}

double exact_work(const Plan& plan, const Survey& survey) {
    // Number of chords at the plan's tolerance for each chord of the coarse tolerance.
    constexpr double kToleranceOfChords = 0.01;  // mm
    const double finer = std::sqrt(kToleranceOfChords / plan.tolerance);
    constexpr double kWorkOfIndexed = 2.0, kWorkOfTurning = 100.0, kWorkOfRound = 3.0;
    double work = 0.0;
    for (const auto& [number, pieces] : survey.pieces) {
        const auto used = survey.tools.find(number);
        const bool is_round = used == survey.tools.end() || !is_plain_flat(used->second.tool);
        const double of_tool = static_cast<double>(pieces.straight) +
                               finer * static_cast<double>(pieces.chords) +
                               kWorkOfIndexed * static_cast<double>(pieces.indexed) +
                               kWorkOfTurning * static_cast<double>(pieces.turning);
        work += (is_round ? kWorkOfRound : 1.0) * of_tool;
    }
    return work;
}

void coarsen(Plan& plan, const Survey& survey, bool tolerance_specified,
             bool tool_tolerance_specified) {
    if (!plan.draft || !survey.is_ready()) return;
    const ModelInfo* model = find_model(plan.model);
    plan.is_draft_exact = !tolerance_specified && !tool_tolerance_specified && model &&
                          !model->has_resolution && exact_work(plan, survey) <= kQuickWork;
    if (plan.is_draft_exact) return;
    constexpr double kCoarser = 4.0;  // relative to the default, at least
    constexpr double kOfBlock = 1.0 / 1200.0;
    constexpr double kToolOfBlock = 1.0 / 300.0;
    constexpr double kOfTool = 1.0 / 15.0;  // share of a diameter
    constexpr double kMost = 1.0;           // mm
    const double size = norm(survey.stock->box.size());
    double thinnest = std::numeric_limits<double>::infinity();
    for (const auto& [number, used] : survey.tools)
        thinnest = std::min(thinnest, toolpath::cutting_diameter_of(used.tool));
    const auto hundredths = [](double mm) { return std::floor(100.0 * mm) / 100.0; };
    if (!tolerance_specified) {
        const double most = std::min(kOfBlock * size, kMost);
        plan.tolerance = std::max(kCoarser * plan.tolerance, hundredths(most));
    }
    if (!tool_tolerance_specified) {
        const double most = std::min({kToolOfBlock * size, kOfTool * thinnest, kMost});
        plan.tool_tolerance = std::max(kCoarser * plan.tool_tolerance, hundredths(most));
    }
    if (!plan.at_line) plan.join_tolerance = plan.tolerance;
}

}  // namespace ncsim::simulation
