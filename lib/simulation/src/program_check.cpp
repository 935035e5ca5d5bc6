// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prepares the set-up of a verification, runs the simulation with a verifier, and compares further
// readings.
#include "ncsim/simulation/program_check.h"

#include "ncsim/base/file_names.h"
#include "ncsim/setup/coordinate_systems.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/describe.h"
#include "ncsim/simulation/fixtures.h"
#include "ncsim/simulation/models.h"
#include "ncsim/simulation/page_data.h"
#include "ncsim/simulation/play_recorder.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/stock_history.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/verify/machining_time.h"
#include "ncsim/verify/verifier.h"

#include "alternatives.h"
#include "detached_pieces.h"
#include "deviation_mesh.h"
#include "machine_page_data.h"
#include "motions.h"
#include "place_kinematics.h"
#include "refine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

namespace ncsim::simulation {

namespace {

// Adds a shank up to the stick-out, as thick as the flutes. If neither stick-out nor length is
// specified, the shank is taller than any cut is deep.
void extend_shank(toolpath::Tool& tool, const toolpath::ToolSpec& spec) {
    constexpr double kTall = 1000.0;  // mm
    if (spec.shank_length || !spec.shaft.empty()) return;
    const toolpath::ProfilePoint top = tool.pieces.back().profile.back();
    const double height = spec.stick_out ? *spec.stick_out - top.height : kTall;
    if (top.radius <= 0.0 || height <= 0.0) return;
    toolpath::add_holder_segment(tool, 2 * top.radius, 2 * top.radius, height);
    tool.pieces.back().assumed = true;
}

// Part about the axis that does not cut, as a share of the diameter.
struct BlindCore {
    double share = 0.0;
    const char* why = "";
};

BlindCore blind_core(toolpath::ToolKind kind) {
    using enum toolpath::ToolKind;
    switch (kind) {
        case FaceMill: return {0.5, "a face mill does not cut in the inner half of its diameter"};
        case SlotMill: return {0.5, "a slot cutter does not cut in the inner half of its diameter"};
        case DovetailMill:
            return {0.5, "a dovetail cutter does not cut in the inner half of its diameter"};
        case Tap: return {0.6, "a tap needs a hole of the minor diameter"};
        case Reamer: return {0.8, "a reamer needs a hole a little smaller than itself"};
        case BoringBar: return {0.6, "a boring bar needs a hole"};
        default: return {};
    }
}

verify::ToolFacts facts_of(const UsedTool& used, const verify::ToolFacts* specified) {
    verify::ToolFacts facts;
    if (specified) facts = *specified;
    facts.tool = used.tool;
    facts.is_guess = used.is_guess;
    facts.holder_specified = toolpath::specifies_holder(used.spec);
    if (!used.length_specified) {
        facts.certain_flutes = toolpath::least_flute_length(used.tool);
    } else if (!facts.holder_specified) {
        extend_shank(facts.tool, used.spec);
    }
    if (used.specified_by == toolpath::ValueSource::Assumption) {
        facts.assumption = "not described; taken as " + used.text;
    } else {
        facts.assumption = used.assumed_values_text;
    }
    if (const BlindCore core = blind_core(used.tool.kind);
        !facts.blind_diameter && core.share > 0) {
        facts.blind_diameter = core.share * toolpath::cutting_diameter_of(used.tool);
        facts.blind_assumption = core.why;
    }
    facts.left_hand |= used.spec.left_hand;
    if (!facts.pitch) facts.pitch = used.spec.pitch;
    const bool has_flutes = used.length_specified && !used.is_guess;
    if (used.tool.kind == toolpath::ToolKind::Drill && has_flutes)
        facts.flute_length = toolpath::cutting_height_of(used.tool);
    // Small tips engrave; the flats of chamfer mills have no edges.
    constexpr double kEngraves = 0.5;  // mm
    if (used.tool.kind == toolpath::ToolKind::ChamferMill && !used.is_guess &&
        used.spec.tip_diameter.value_or(0.0) > kEngraves)
        facts.flat_tip = used.spec.tip_diameter;
    return facts;
}

std::set<std::string, std::less<>> accepted_reasons(const std::vector<std::string>& names) {
    std::set<std::string, std::less<>> accepted;
    for (const verify::ReasonInfo& reason : verify::reasons()) {
        const auto is_reason = [&](const std::string& name) {
            return name == "all" || verify::find_reason(name) == &reason;
        };
        if (std::ranges::any_of(names, is_reason)) accepted.emplace(reason.id);
    }
    return accepted;
}

verify::Setup setup_for(const Plan& plan, const Survey& survey,
                        const VerificationOptions& verification_options) {
    verify::Setup setup;
    setup.machine = verification_options.machine.machine;
    setup.machine.work_zero = work_zero(survey.interpretation.workpiece);
    for (std::size_t i = 0; i < 3; ++i) {
        setup.machine.rotary_zero[i] = survey.interpretation.workpiece.origin[gcode::kA + i];
        if (!plan.kinematics) continue;
        const auto specified = plan.kinematics->travels.find("ABC"[i]);
        if (specified != plan.kinematics->travels.end())
            setup.machine.rotary_travel[i] = {specified->second.min, specified->second.max};
    }
    setup.selection = verification_options.selection;
    setup.suppressions = verify::Suppressions(plan.job.program);
    setup.accuracy.tolerance_mm = plan.tool_tolerance;
    setup.path_tolerance_mm = plan.tolerance;
    if (survey.interpretation.blend_mm > plan.tolerance)
        setup.blend_mm = survey.interpretation.blend_mm;
    setup.pieces_counted = verification_options.detached_pieces;
    setup.air_cuts = verification_options.air_cuts;
    setup.design = verification_options.design != nullptr;
    setup.ledger = verification_options.ledger || verification_options.wants_page;
    setup.rapid = rapid_path(verification_options);
    setup.kinematics = plan.placed;
    setup.bodies = verification_options.bodies ? verification_options.bodies
                                               : bodies_of(verification_options.machine);
    const AxesInUse axes{survey.turns, survey.uvw, survey.uvw_of_tip};
    setup.tip_guess = kinematics_guess(plan, survey.interpretation.workpiece, axes,
                                       !survey.interpretation.requested_tip_positions);
    setup.axes_guess = kinematics_guess(plan, survey.interpretation.workpiece, axes, false);
    setup.setting_askew = survey.interpretation.setting_askew;
    setup.uses_length_offsets = survey.interpretation.uses_length_offsets;
    setup.inherited_modes = survey.interpretation.inherited_modes;
    setup.cutting_tools = survey.cutting_tools;
    setup.accepted = accepted_reasons(plan.job.options.accept);
    setup.required.insert(plan.job.options.require.begin(), plan.job.options.require.end());
    for (const auto& [number, used] : survey.tools) {
        const auto specified = verification_options.machine.tools.find(number);
        verify::ToolFacts facts = facts_of(
            used,
            specified == verification_options.machine.tools.end() ? nullptr : &specified->second);
        const toolpath::ToolEntry* entry = toolpath::find_tool(plan.job.tools, number);
        facts.gauge_length_specified = entry && entry->offset.z != 0.0;
        setup.tools.emplace(number, std::move(facts));
    }
    if (survey.stock) setup.stock = survey.stock->box;
    if (!survey.is_ready()) {
        setup.not_simulated = reason_not_simulated(survey);
    } else if (survey.stock->specified_by == toolpath::ValueSource::Assumption) {
        setup.stock_assumption = survey.stock->text;
    } else if (survey.stock->place_assumed) {
        setup.stock_assumption =
            "its place is not specified; a corner or the middle is at zero, as the cuts suggest";
    }
    if (survey.units_assumed) {
        setup.units_assumption = fmt::format(
            "{}, since neither G20 nor G21 stands before the first length",
            survey.interpretation.uses_inches ? "inches, the unit of its tools" : "millimetres");
    }
    const auto& zero = setup.machine.work_zero;
    const double home = setup.machine.home ? setup.machine.home->z : 0.0;
    setup.home_z = zero ? home - zero->z : verify::kHomeHeight + home;
    if (!zero) {
        setup.home_assumption = fmt::format(
            "machine zero {:g} mm above the program zero, not specified by a machine file",
            verify::kHomeHeight);
    }
    return setup;
}

// Tools and registers that are specified and that the program does not use, in words.
std::vector<std::string> unused_settings(const Plan& plan, const Survey& survey) {
    std::vector<std::string> unused;
    for (const toolpath::ToolSpec& spec : plan.job.options.tools) {
        if (!survey.tools.contains(spec.number) && !survey.tools.contains(0))
            unused.push_back(fmt::format("--tool T{}: the program does not move it", spec.number));
    }
    for (const int number : survey.interpretation.unread_registers)
        unused.push_back(fmt::format("--compensation D{}: no G41 and no G42 reads it", number));
    return unused;
}

// True if a selected check needs the part.
bool needs_simulation(const verify::Setup& setup) {
    return verify::needs_part(setup) || setup.ledger || setup.pieces_counted || setup.design ||
           setup.air_cuts;
}

std::string_view verdict_word(verify::Outcome outcome) {
    switch (outcome) {
        case verify::Outcome::Clean: return "clean";
        case verify::Outcome::Accepted: return "accepted";
        case verify::Outcome::NotProven: return "not-proven";
        case verify::Outcome::Failed: break;
    }
    return "failed";
}

/// Begins all messages of `verdict` with the label of its program, if the file has several.
void name_program(verify::Verdict& verdict, const std::string& label) {
    if (label.empty()) return;
    for (verify::Finding& f : verdict.findings)
        f.message = fmt::format("{}: {}", label, f.message);
    for (verify::Doubt& d : verdict.doubts)
        d.message = fmt::format("{}: {}", label, d.message);
}

// Sorts doubts in the order of reasons().
void sort_doubts(verify::Verdict& verdict) {
    std::ranges::stable_sort(verdict.doubts, {},
                             [](const verify::Doubt& d) { return verify::find_reason(d.reason); });
}

// Adds doubts for accepted errors of the program: a control that stops at a block, or reads it
// differently, does not execute the simulated motions.
void doubt_accepted_blocks(verify::Verdict& verdict,
                           const std::set<std::string, std::less<>>& accepted) {
    constexpr std::string_view kReason = "not-simulated";
    for (const verify::Finding& f : verdict.findings) {
        if (!f.accepted || f.category != verify::Category::Program ||
            f.severity != verify::Severity::Error)
            continue;
        verify::Doubt doubt;
        doubt.reason = kReason;
        doubt.message = "the effect of an accepted fault is unknown: " + f.message;
        doubt.place = f.place;
        doubt.count = f.count;
        doubt.accepted = accepted.contains(kReason);
        verdict.doubts.push_back(std::move(doubt));
    }
    sort_doubts(verdict);
}

// Returns the outcome with warnings as errors.
verify::Outcome stricter(verify::Outcome outcome, const verify::Verdict& verdict) {
    if (verdict.count(verify::Severity::Warning) > 0) return verify::Outcome::Failed;
    const bool is_accepted = std::ranges::any_of(verdict.findings, [](const verify::Finding& f) {
        return f.accepted && f.severity != verify::Severity::Note;
    });
    return outcome == verify::Outcome::Clean && is_accepted ? verify::Outcome::Accepted : outcome;
}

void conclude(const VerificationOptions& verification_options, Checked& checked) {
    verify::Outcome outcome = checked.verdict.outcome();
    if (verification_options.warnings_as_errors) outcome = stricter(outcome, checked.verdict);
    checked.word = verdict_word(outcome);
    checked.outcome = outcome;
}

}  // namespace

std::shared_ptr<const verify::MachineBodies> bodies_of(const setup::MachineFile& machine) {
    if (machine.bodies.empty() && machine.other_links.empty()) return nullptr;
    verify::LinkBodies specified;
    for (const auto* links : {&machine.bodies, &machine.other_links}) {
        for (const setup::MachineBody& link : *links)
            specified.links.push_back({link.link, link.mesh, link.moved_by, link.clearance_mm,
                                       link.deflection_mm, link.mesh_at, link.as_hull});
    }
    specified.fixtures = machine.machine.fixtures;
    specified.part_moved_by = machine.part_moved_by;
    specified.tool_moved_by = machine.tool_moved_by;
    specified.ignored = machine.ignored;
    specified.checked_neighbours = machine.checked_neighbours;
    return std::make_shared<const verify::MachineBodies>(std::move(specified));
}

void add_fixtures(VerificationOptions& verification_options, const setup::Job& job) {
    if (!add_fixtures(verification_options.machine, job)) return;
    verification_options.bodies = bodies_of(verification_options.machine);
}

toolpath::RapidPath rapid_path(const VerificationOptions& verification_options) {
    const verify::MachineDescription& machine = verification_options.machine.machine;
    toolpath::RapidPath path;
    path.dog_leg = verification_options.dog_leg;
    const bool all_specified =
        std::ranges::all_of(machine.rapid, [](const auto& rate) { return rate.has_value(); });
    for (std::size_t i = 0; i < 3 && all_specified; ++i)
        path.rates[i] = *machine.rapid[i];
    return path;
}

std::string reasons_of(const std::vector<std::string>& assumptions) {
    std::string reasons;
    std::set<std::string> known;
    for (const std::string& text : assumptions) {
        const std::string reason = text.substr(0, text.find(':'));
        if (known.insert(reason).second) reasons += (reasons.empty() ? "" : ", ") + reason;
    }
    return reasons;
}

namespace {

// Plan, survey and set-up of a verification.
struct PreparedCheck {
    Plan plan;
    Survey survey;
    verify::Setup setup;
    std::vector<std::string> not_used;  // specified values that are not used

    bool is_simulated() const { return survey.is_ready() && needs_simulation(setup); }
    Box stock() const { return survey.is_ready() ? survey.stock->box : Box{}; }
    cda::Lattice lattice() const {
        return survey.is_ready() ? toolpath::stock_lattice(*survey.stock) : cda::Lattice{};
    }
    Verification verification() const {
        Verification verification;
        verification.side = toolpath::Side::Circumscribed;
        verification.rapid = setup.rapid;
        verification.watch = verify::watched_parts(setup);
        verification.keep_cuts = verification.own_lines = setup.design;
        return verification;
    }
};

PreparedCheck prepared(Plan specified, const VerificationOptions& verification_options) {
    require_verifying(specified);
    PreparedCheck all{std::move(specified), {}, {}, {}};
    Plan& plan = all.plan;
    all.not_used = apply_machine(plan, verification_options.machine);
    all.survey = simulation::survey(plan);
    if (all.survey.only_rapid) set_empty_stock(all.survey);
    all.setup = setup_for(plan, all.survey, verification_options);
    for (std::string& lost : place_fixtures(all.setup.machine, plan, all.survey))
        all.not_used.push_back(std::move(lost));
    if (verification_options.tools_are_meant) {
        for (std::string& unused : unused_settings(plan, all.survey))
            all.not_used.push_back(std::move(unused));
    }
    return all;
}

}  // namespace

namespace {

std::string text_of(const gcode::OffsetConflict& conflict, bool is_written) {
    std::string text;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<double> value =
            is_written ? conflict.written[i] : std::optional(conflict.specified[i]);
        text += fmt::format("{}{}", text.empty() ? "" : " ", "XYZ"[i]);
        text += value ? fmt::format("{:.10g}", std::round(*value * 1e6) / 1e6) : "?";
    }
    return text;
}

// Adds a doubt for each coordinate system that [offsets] and the program place differently.
void add_doubts_of_offsets(const Survey& survey, verify::Verifier& verifier) {
    for (const gcode::OffsetConflict& conflict : survey.interpretation.offset_conflicts) {
        verifier.add_doubt(
            "contradiction",
            fmt::format("{} is at {} in the machine by [offsets] and at {} by the program",
                        setup::name_of_system(conflict.system), text_of(conflict, false),
                        text_of(conflict, true)),
            {conflict.place.file, conflict.place.span});
    }
}

// Adds doubts about files that were written by runs with assumptions, and about axes that the
// program never positions.
void add_doubts_of_inputs(const Plan& plan, const Survey& survey,
                          const VerificationOptions& verification_options,
                          verify::Verifier& verifier) {
    const auto add = [&verifier](const std::string& what) {
        verifier.add_doubt("file-origin", what);
    };
    for (const setup::JobDoubt& doubt : plan.job.doubts)
        verifier.add_doubt(doubt.reason, doubt.message, {0, doubt.span});
    add_doubts_of_offsets(survey, verifier);
    for (const std::string& what : fixtures_in_stock(survey, verification_options.machine.machine))
        verifier.add_doubt("contradiction", what);
    for (const verify::Fixture& fixture : verification_options.machine.machine.fixtures) {
        if (!fixture.assumed.empty())
            add(fmt::format("mesh of the fixture '{}': {}", fixture.name, fixture.assumed));
    }
    for (const setup::MachineBody& body : verification_options.machine.bodies) {
        if (!body.assumed.empty())
            add(fmt::format("mesh of the link '{}': {}", body.link, body.assumed));
    }
    if (verification_options.design && !verification_options.design->assumed.empty())
        add(fmt::format("design {}: {}", verification_options.design->path,
                        verification_options.design->assumed));
    if (const auto& place = survey.interpretation.distance_guess)
        verifier.add_doubt("distance-guess",
                           "neither G90 nor G91 stands before the first move; G90 was assumed",
                           {place->file, place->span});
    for (std::size_t axis = 0; axis < survey.unspecified.size(); ++axis) {
        if (survey.unspecified[axis])
            verifier.add_doubt("start-unknown",
                               fmt::format("the program never sets {}; taken as 0", "XYZ"[axis]));
    }
}

// True for doubts about the tools, the stock and the motions, not about the part.
bool is_assumption(const verify::Doubt& doubt) {
    constexpr std::string_view kOthers[] = {"setting-not-used", "required", "nothing-removed"};
    return std::ranges::find(kOthers, doubt.reason) == std::end(kOthers);
}

std::string with_line(std::string text, const verify::Place& place) {
    return place.span.line == 0 ? text : fmt::format("{} (line {})", text, place.span.line);
}

// Reports G64 P; the path is simulated as programmed.
void note_blend(const VerificationOptions& verification_options, const Survey& survey,
                const verify::Setup& setup, verify::Verifier& verifier) {
    if (setup.blend_mm <= 0.0) return;
    gcode::Diagnostic d;
    d.severity = gcode::Severity::Note;
    d.code = "path-blending";
    d.message =
        fmt::format("the control may miss corners of the path by {:g} mm (G64 P)", setup.blend_mm);
    d.span = survey.interpretation.blend.span;
    if (const std::uint32_t file = survey.interpretation.blend.file; file > 0)
        d.file = survey.interpretation.files.at(file);
    verifier.add({d});
    if (verification_options.design && setup.blend_mm > verification_options.design->tolerance_mm)
        verifier.add_doubt("path-blending", d.message + ", and the design allows less");
}

}  // namespace

std::vector<std::string> assumptions_of(const Plan& plan, const Survey& survey,
                                        const setup::MachineFile& machine) {
    VerificationOptions verification_options;
    verification_options.machine = machine;
    PreparedCheck all{plan, survey, setup_for(plan, survey, verification_options), {}};
    // Without cutting, the polytopes of the tools may be coarse; fine polytopes take milliseconds
    // per tool.
    constexpr double kCoarse = 1.0;  // mm
    all.setup.accuracy.tolerance_mm = kCoarse;
    verify::Verifier verifier(all.setup, all.stock(), all.lattice(), {});
    verifier.add(survey.diagnostics);
    add_doubts_of_inputs(plan, survey, verification_options, verifier);
    for_each_motion(plan, [&](const gcode::Motion& motion) {
        verifier.begin(motion);
        verifier.end();
    });
    const verify::Verdict verdict = verifier.finish(survey.interpretation, nullptr, 0.0);
    std::vector<std::string> assumed;
    for (const verify::Doubt& doubt : verdict.doubts) {
        if (is_assumption(doubt))
            assumed.push_back(with_line(doubt.reason + ": " + doubt.message, doubt.place));
    }
    // Without cutting, the height of the cuts on the flutes is unknown; the depth of the program is
    // a bound.
    const double deep = all.stock().max.z - survey.tip_positions.min.z;
    for (const auto& [number, facts] : all.setup.tools) {
        if (facts.certain_flutes && deep > *facts.certain_flutes)
            assumed.push_back(fmt::format("flutes-guess: T{}: {}", number, facts.assumption));
    }
    for (const verify::Finding& f : verdict.findings) {
        if (f.category == verify::Category::Program && f.severity == verify::Severity::Error)
            assumed.push_back(with_line(f.rule + ": " + f.message, f.place));
    }
    return assumed;
}

namespace {

// Returns the readings to compare the verdict with.
std::vector<Alternative> check_one_reading(Plan specified_plan,
                                           const VerificationOptions& verification_options,
                                           Checked& checked) {
    checked.path = specified_plan.job.program.name;
    PreparedCheck all = prepared(std::move(specified_plan), verification_options);
    Plan& plan = all.plan;
    const Survey& survey = all.survey;
    const verify::Setup& specified = all.setup;
    checked.moves = survey.moves;
    for (const Survey::Operation& o : survey.operations)
        checked.operations.push_back({o.name, o.line, o.tool, o.first_motion});
    checked.simulated = all.is_simulated();
    if (specified.not_simulated) checked.not_simulated = *specified.not_simulated;
    if (survey.is_ready()) {
        checked.stock_box = survey.stock->box;
        checked.stock =
            describe(*survey.stock) + (specified.stock_assumption.empty() ? "" : ", assumed");
    }
    verify::Share share;
    if (verification_options.tiles) {
        if (checked.simulated != (verification_options.tiles->cut != nullptr))
            throw std::runtime_error("the tiles do not agree on whether there is a part");
        plan.tiles = verification_options.tiles->cut;
        share.evidence = verification_options.tiles->evidence;
    }
    verify::Setup setup = specified;
    setup.decides_contacts = true;
    verify::Verifier verifier(std::move(setup), all.stock(), all.lattice(), std::move(share));
    verifier.add(survey.diagnostics);
    if (!verification_options.machine.bodies.empty() && !specified.machine.work_zero) {
        verifier.add_doubt(
            "setting-not-used",
            "meshes of links: the position of the work zero (G54) in the machine is not specified");
    }
    add_doubts_of_inputs(plan, survey, verification_options, verifier);
    for (std::string& what : all.not_used)
        verifier.add_doubt("setting-not-used", std::move(what));
    note_blend(verification_options, survey, specified, verifier);
    if (checked.simulated) {
        Verification verification = all.verification();
        verification.verifier = &verifier;
        Refiner refiner(plan, survey, specified);
        verification.decide = [&refiner](const verify::OpenContact& contact) {
            return refiner.decide(contact);
        };
        verification.keep_cuts |= verification_options.wants_page;
        std::optional<PlayRecorder> play;
        if (verification_options.wants_page) {
            verification.play = &play.emplace(plan, survey, 0);
            verification.history = read_stock_history(*survey.stock);
        }
        const Simulation simulation = simulate(plan, survey, verification, {});
        if (verification_options.detached_pieces) {
            for (verify::Finding& f : detached_pieces(plan, survey, verification, simulation))
                verifier.add(std::move(f));
        }
        const bool compared = verification_options.selection.includes("gouge") ||
                              verification_options.selection.includes("excess");
        if (verification_options.design && compared) {
            for (verify::Finding& f :
                 compare_with(*verification_options.design, simulation, checked.design.emplace()))
                verifier.add(std::move(f));
        }
        checked.verdict =
            verifier.finish(survey.interpretation, simulation.part.get(), simulation.stock_volume);
        if (verification_options.wants_page) {
            checked.page_data = page_data(plan, survey, simulation, simulation.part->boundary(),
                                          all.setup.machine.fixtures, true);
            if (play) checked.page_data->play = finish_play(*play, simulation);
            if (checked.design && !checked.page_data->mesh.triangles.empty()) {
                checked.page_data->deviation =
                    deviation_mesh(checked.page_data->mesh, *verification_options.design);
            }
            checked.page_data->machine = machine_page_data(
                plan, survey, verification_options.machine, checked.verdict.findings);
        }
    } else {
        // The program is known not to end, so the rules need not examine each iteration of its
        // loop.
        if (survey.never_ends) plan.job.interpreter.limits.repeated_blocks /= 4;
        for_each_motion(plan, [&](const gcode::Motion& motion) {
            verifier.begin(motion);
            verifier.end();
        });
        checked.verdict = verifier.finish(survey.interpretation, nullptr, 0.0);
    }
    checked.time = verify::time_line(checked.verdict.ledger);
    checked.seconds = verify::seconds_of(checked.verdict.ledger);
    if (checked.time.empty() && survey.moves > 0) {
        const verify::Distances distances = verify::total(survey.distances);
        checked.time = verify::time_line(distances);
        checked.seconds = verify::time_of(distances).total();
    }
    if (verification_options.wants_page) {
        if (!checked.page_data) checked.page_data.emplace();
        checked.page_data->source = plan.job.program.text;
        checked.page_data->title = base_name(plan.job.program.name);
    }
    checked.program = plan.job.label;
    name_program(checked.verdict, checked.program);
    for (const verify::Finding& f : checked.verdict.findings) {
        std::string line;
        if (f.place.file == 0 && f.place.span.line > 0) {
            line = gcode::line_text(plan.job.program, f.place.span.line);
        }
        checked.lines.push_back(std::move(line));
    }
    if (verification_options.baseline) {
        verification_options.baseline->accept(checked, verification_options.selection);
        doubt_accepted_blocks(checked.verdict, specified.accepted);
    }
    conclude(verification_options, checked);
    return alternatives_of(plan, survey, verification_options);
}

// Verifies a second reading, without pictures and ledger.
Checked check_alternative(const Plan& plan, const VerificationOptions& verification_options,
                          const Alternative& alternative) {
    Plan other = plan;
    VerificationOptions asked = verification_options;
    asked.wants_page = asked.ledger = false;
    asked.tiles = nullptr;
    alternative.apply(other, asked);
    Checked found;
    check_one_reading(std::move(other), asked, found);
    return found;
}

}  // namespace

void check(Plan plan, const VerificationOptions& verification_options, Checked& checked) {
    const Plan same = plan;
    const std::vector<Alternative> alternatives =
        check_one_reading(std::move(plan), verification_options, checked);
    // A failed reading decides the verdict.
    if (alternatives.empty() || checked.outcome == verify::Outcome::Failed) return;
    const auto accepted = accepted_reasons(same.job.options.accept);
    checked.word = Checked().word;  // until all readings are known
    for (const Alternative& alternative : alternatives) {
        const Checked other = check_alternative(same, verification_options, alternative);
        std::optional<verify::Doubt> doubt = doubt_from(checked, other, alternative);
        if (!doubt) continue;
        doubt->accepted = accepted.contains(doubt->reason);
        checked.verdict.doubts.push_back(std::move(*doubt));
    }
    sort_doubts(checked.verdict);
    conclude(verification_options, checked);
}

TileResult check_tile(Plan specified_plan, const VerificationOptions& verification_options) {
    PreparedCheck all = prepared(std::move(specified_plan), verification_options);
    TileResult seen;
    if (!all.is_simulated()) return seen;
    verify::Verifier verifier(all.setup, all.stock(), all.lattice(), {all.plan.tile, nullptr});
    Verification verification = all.verification();
    verification.verifier = &verifier;
    const Simulation simulation = simulate(all.plan, all.survey, verification, {});
    // A run without tiles computes the volume here, too.
    (void)simulation.part->volume();
    seen.stock_contacts = simulation.stock_contacts;
    seen.evidence = verifier.take_evidence();
    seen.tile = tile_data(*simulation.part);
    return seen;
}

Checked check(Plan plan, const VerificationOptions& verification_options) {
    Checked checked;
    check(std::move(plan), verification_options, checked);
    return checked;
}

}  // namespace ncsim::simulation
