// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws the part, with the machine, paths and tools.
#include "run/picture.h"

#include "ncsim/export/camera.h"
#include "ncsim/export/contact_sheet.h"
#include "ncsim/export/marks.h"
#include "ncsim/export/render.h"
#include "ncsim/machine/relative.h"
#include "ncsim/report/describe.h"
#include "ncsim/report/file_names.h"
#include "ncsim/report/machining_time.h"
#include "ncsim/simulation/fixtures.h"
#include "ncsim/simulation/models.h"
#include "ncsim/toolpath/joint_path.h"
#include "ncsim/toolpath/tool_spec.h"

#include "run/machine_picture.h"
#include "run/tool_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::app {

namespace {

// Margin around the block in which paths and tools are shown, in diagonals of the block. A larger
// margin would make the part small.
constexpr double kBlockMargin = 0.3;

// Returns the box of the links with all joints at 0, so successive pictures have the same camera;
// machine coordinates.
cda::Box machine_box(const Outcome& outcome) {
    cda::Box box;
    for (const setup::MachineBody& body : outcome.machine->bodies) {
        for (const cda::Vec3& p : body.mesh.vertices)
            box.add(p);
    }
    return box;
}

bool is_machine_fixed(const Outcome& outcome) {
    return outcome.options.shows_machine && outcome.options.fixed_body == FixedBody::Machine;
}

// Returns the positions of the joints after the last move, machine coordinates.
machine::Values joints_of(const Outcome& outcome) {
    const auto& last = outcome.simulation->last_move;
    if (!last) return {};
    return toolpath::JointPath(*outcome.plan.placed, *last).at(1.0).value_or(machine::Values{});
}

// Adds the links around the part, which stays in place.
void add_machine(const Outcome& outcome, exporter::Overlay& overlay) {
    const setup::MachineFile& machine = *outcome.machine;
    const machine::Values values = joints_of(outcome);
    for (const setup::MachineBody& link : machine.bodies) {
        std::vector<cda::Vec3> corners = corners_at(link, values);
        for (cda::Vec3& p : corners)
            p = setup::on_part(machine.part_moved_by, values, p) - outcome.plan.placed->zero;
        overlay.bodies.push_back(machine_body(link, std::move(corners)));
    }
}

// Returns the pose of the part in the machine.
machine::Pose pose_of_part(const Outcome& outcome) {
    machine::Pose X_MW = machine::pose_of(outcome.machine->part_moved_by, joints_of(outcome));
    X_MW.translation = X_MW * outcome.plan.placed->zero;
    return X_MW;
}

// Transforms a camera of the machine into the frame of the part.
exporter::Camera seen_from_part(exporter::Camera camera, const machine::Pose& X_MW) {
    const machine::Pose X_WM = machine::inverse(X_MW);
    const machine::Pose R_WM{X_WM.rows, {}};
    camera.target = X_WM * camera.target;
    for (cda::Vec3* direction : {&camera.right, &camera.up, &camera.back})
        *direction = R_WM * *direction;
    return camera;
}

// Returns the box to be shown: in machine coordinates if the machine is fixed, otherwise in W.
cda::Box visible_box(const Outcome& outcome) {
    const Options& o = outcome.options;
    if (is_machine_fixed(outcome)) return machine_box(outcome);
    cda::Box seen = outcome.survey.stock->box;
    if (o.shows_machine) {
        const cda::Box machine = machine_box(outcome);
        seen.add(machine.min - outcome.plan.placed->zero);
        seen.add(machine.max - outcome.plan.placed->zero);
    }
    if (!outcome.fixtures.empty()) seen = simulation::box_with_fixtures(seen, outcome.fixtures);
    if (!o.shows_path && !o.shows_tool) return seen;
    const double reach = kBlockMargin * norm(seen.size());
    const cda::Vec3 margin{reach, reach, reach};
    const cda::Box around{seen.min - margin, seen.max + margin};
    const auto show = [&](cda::Vec3 p) {
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = std::clamp(p[axis], around.min[axis], around.max[axis]);
        seen.add(p);
    };
    const cda::Box& tips = outcome.survey.tip_positions;
    if (!tips.is_empty()) {
        show(tips.min);
        show(tips.max);
    }
    if (o.shows_tool) show({seen.centre().x, seen.centre().y, around.max.z});
    return seen;
}

// True if marks are requested and the picture has enough pixels for marks.
bool has_marks(const Options& o) {
    return o.marks.any() && std::min(o.width, o.height) >= exporter::kLeastMarkedSide;
}

// Returns the plane that removes the half towards the eye; for a plane along the line of sight, the
// half that an isometric view removes.
exporter::CutPlane cut_plane(const brep::SectionPlane& plane, const exporter::Camera& camera) {
    constexpr double kAlong = 1e-9;
    constexpr cda::Vec3 kIsoSide{1, -1, 1};
    double side = camera.back[plane.axis];
    if (std::abs(side) < kAlong) side = kIsoSide[plane.axis];
    exporter::CutPlane cut;
    cut.normal[plane.axis] = side > 0.0 ? 1.0 : -1.0;
    cut.offset = cut.normal[plane.axis] * plane.at;
    return cut;
}

exporter::RenderOptions render_options(const Outcome& outcome, exporter::View view) {
    const Options& o = outcome.options;
    const cda::Box& stock = outcome.survey.stock->box;
    const cda::Box& tips = outcome.survey.tip_positions;
    exporter::RenderOptions options;
    options.width = o.width;
    options.height = o.height;
    options.background = o.background;
    options.renderer = o.renderer;
    options.colouring = o.colouring;
    options.ghost_stock = outcome.survey.stock->specified_by == toolpath::ValueSource::Assumption;
    options.depth_top = stock.max.z;
    options.depth_bottom = std::max(stock.min.z, tips.min.z);
    const double strip = has_marks(o) ? exporter::mark_strip(o.width, o.height) : 0.0;
    options.camera =
        exporter::fit_camera(visible_box(outcome), view, o.width / ((1.0 - strip) * o.height));
    options.camera = exporter::with_mark_strip(options.camera, strip);
    options.camera.depth += simulation::reach_of(outcome.fixtures);
    if (o.shows_machine) options.camera.depth += norm(machine_box(outcome).size());
    // Paths and tools beyond the picture may also be far in front of it.
    if (o.shows_path || o.shows_tool) {
        cda::Box all = stock;
        if (!tips.is_empty()) {
            all.add(tips.min);
            all.add(tips.max);
        }
        options.camera.depth += norm(all.size());
        for (const auto& [number, used] : outcome.survey.tools)
            options.camera.depth += toolpath::height_of(used.tool);
    }
    if (is_machine_fixed(outcome))
        options.camera = seen_from_part(options.camera, pose_of_part(outcome));
    if (o.cut_view) options.cut = cut_plane(*o.cut_view, options.camera);
    return options;
}

exporter::Overlay overlay(const Outcome& outcome) {
    const simulation::Simulation& s = *outcome.simulation;
    exporter::Overlay result{s.paths, {}};
    const toolpath::StockEntry& stock = *outcome.survey.stock;
    if (stock.specified_by == toolpath::ValueSource::Assumption && !stock.shape && !stock.is_round)
        result.ghosts.push_back({stock.box});
    if (outcome.options.shows_machine) add_machine(outcome, result);
    for (const verify::Fixture& fixture : outcome.fixtures) {
        result.bodies.push_back(simulation::body_of(fixture));
        result.bodies.back().is_cut = true;
    }
    if (!outcome.options.shows_tool || !s.tool_position) return result;
    const auto used = outcome.survey.tools.find(s.tool_position->tool);
    if (used != outcome.survey.tools.end())
        std::ranges::move(tool_bodies(used->second.tool, s.tool_position->X_WT),
                          std::back_inserter(result.bodies));
    return result;
}

std::string depth_text(double z_mm, report::LengthUnit unit) {
    return "Z " + report::in_unit(fmt::format("{:.4g} mm", z_mm), unit);
}

std::string line_text(const exporter::Provenance& provenance,
                      const exporter::Provenance::Entry& entry) {
    if (entry.earlier_program == 0) return fmt::format("line {}", entry.nc_line);
    return fmt::format("{}:{}", provenance.earlier_programs[entry.earlier_program - 1],
                       entry.earlier_line);
}

// Returns the number of a tool, with its description if the program or the job has one. Tools of
// earlier set-ups are in the job.
std::string tool_text(const Outcome& outcome, std::uint32_t number) {
    const auto described = [&](const toolpath::Tool& tool) {
        return fmt::format(
            "T{} {}", number,
            report::tool_in_unit(toolpath::describe(tool), outcome.options.report_unit));
    };
    const auto used = outcome.survey.tools.find(static_cast<int>(number));
    if (used != outcome.survey.tools.end()) return described(used->second.tool);
    const auto& tools = outcome.plan.job.tools;
    const auto entry = std::ranges::find_if(tools, [&](const toolpath::ToolEntry& e) {
        return e.spec.number == static_cast<int>(number) && toolpath::is_complete(e.spec) &&
               (e.spec.length || !e.spec.pieces.empty());
    });
    if (entry == tools.end()) return fmt::format("T{}", number);
    return described(toolpath::make_tool(entry->spec, 0.0));
}

// Returns the meaning of the colours: the tools that cut, or the ends of the scale.
void add_legend(const Outcome& outcome, const exporter::RenderOptions& options,
                exporter::Marks& marks) {
    const exporter::Provenance& provenance = outcome.simulation->provenance;
    switch (options.colouring) {
        case exporter::Colouring::Tool:
            for (const auto& [number, colour] : exporter::tool_colours(provenance))
                marks.legend.emplace_back(colour, tool_text(outcome, number));
            break;
        case exporter::Colouring::Line:
            if (provenance.entries.size() < 2) break;
            marks.scale_begin = line_text(provenance, provenance.entries[1]);
            marks.scale_end = line_text(provenance, provenance.entries.back());
            break;
        case exporter::Colouring::Depth:
            marks.scale_begin = depth_text(options.depth_top, outcome.options.report_unit);
            marks.scale_end = depth_text(options.depth_bottom, outcome.options.report_unit);
            break;
        case exporter::Colouring::Design: break;
    }
}

exporter::Marks marks_of(const Outcome& outcome, const exporter::RenderOptions& options) {
    const MarkOptions& shown = outcome.options.marks;
    exporter::Marks marks;
    marks.axes = shown.axes;
    marks.zero = shown.zero;
    marks.scale = shown.scale;
    const report::LengthUnit unit = outcome.options.report_unit;
    const cda::Vec3 size = outcome.survey.stock->box.size();
    marks.size = report::in_unit(1.0, unit) * size;
    marks.mm_per_unit = 1.0 / report::in_unit(1.0, unit);
    marks.unit = report::name_of(unit);
    if (shown.legend) add_legend(outcome, options, marks);
    return marks;
}

exporter::Image view_of(const Outcome& outcome, exporter::View view) {
    const simulation::Simulation& s = *outcome.simulation;
    const exporter::RenderOptions options = render_options(outcome, view);
    // The thesis' method: rendering with masks.
    exporter::Image image =
        draws_cells(outcome.options)
            ? exporter::render_model(*s.part, s.provenance, options, overlay(outcome))
            : exporter::render_boundary(*outcome.boundary, s.provenance, options, overlay(outcome),
                                        outcome.shading ? *outcome.shading : brep::Shading());
    if (has_marks(outcome.options)) {
        exporter::draw_marks(image, options.camera, options.background, marks_of(outcome, options));
    }
    return image;
}

// Returns the text of the line; empty if the program has several files.
std::string line_at(const Outcome& outcome) {
    if (outcome.survey.interpretation.files.size() > 1) return {};
    return std::string(gcode::line_text(outcome.plan.job.program, outcome.simulation->line));
}

std::vector<std::string> caption(const Outcome& outcome) {
    const simulation::Simulation& s = *outcome.simulation;
    const cda::Vec3 size = outcome.survey.stock->box.size();
    const double removed = s.stock_volume - s.part_volume;
    const verify::Distances& path = s.distances;
    const auto shown = [&](const std::string& text) {
        return report::in_unit(text, outcome.options.report_unit);
    };
    std::string travelled = shown(fmt::format("{:.1f} mm at feed", path.feed_mm));
    if (const auto total = report::time_of(path).total())
        travelled = report::time_text(*total) + ", " + travelled;
    std::vector<std::string> lines{
        report::base_name(outcome.plan.job.program.name) + ": " +
            shown(fmt::format("{:.6g} x {:.6g} x {:.6g} mm", size.x, size.y, size.z)),
        s.stock_volume > 0.0
            ? fmt::format("{} of {} removed ({:.1f} %)", shown(report::volume_text(removed)),
                          shown(report::volume_text(s.stock_volume)),
                          100.0 * removed / s.stock_volume)
            : std::string("nothing is cut"),
        travelled + shown(fmt::format(", {:.1f} mm rapid", path.rapid_mm))};
    const Options& o = outcome.options;
    if (o.cut_view) lines.push_back("cut at " + brep::name_of(*o.cut_view) + " mm");
    if (o.at_line || !o.gif.empty() || !o.frames.empty()) {
        lines.push_back(s.line == 0 ? std::string("before the first move")
                                    : fmt::format("after line {}: {}", s.line, line_at(outcome)));
    }
    return lines;
}

// Adds the assumptions of a preview.
void add_guesses(const Outcome& outcome, std::vector<std::string>& lines) {
    const simulation::Survey& survey = outcome.survey;
    for (const auto& [number, used] : survey.tools) {
        if (used.specified_by == toolpath::ValueSource::Assumption && !survey.only_rapid)
            lines.push_back(fmt::format(
                "guessed: T{} {}", number,
                report::tool_in_unit(describe(used.tool), outcome.options.report_unit)));
    }
    if (survey.stock->specified_by == toolpath::ValueSource::Assumption && !survey.only_rapid)
        lines.push_back("guessed: stock " + report::in_unit(report::describe(*survey.stock),
                                                            outcome.options.report_unit));
    if (survey.units_assumed) {
        lines.emplace_back(survey.interpretation.uses_inches ? "guessed: inches"
                                                             : "guessed: millimetres");
    }
    for (std::size_t axis = 0; axis < survey.unspecified.size(); ++axis) {
        if (survey.unspecified[axis]) lines.push_back(fmt::format("guessed: {} 0", "XYZ"[axis]));
    }
}

}  // namespace

void require_cut_view(const Options& options, const cda::Box& body, std::string_view name) {
    if (!options.cut_view) return;
    const auto& [axis, at] = *options.cut_view;
    if (at > body.min[axis] && at < body.max[axis]) return;
    throw std::runtime_error(fmt::format(
        "--cut-view {}: the plane does not cut the {}, {}", brep::name_of({axis, at}), name,
        body.is_empty()
            ? "of which nothing is left"
            : fmt::format("{} {:.6g} to {:.6g} mm", "XYZ"[axis], body.min[axis], body.max[axis])));
}

exporter::Image picture(const Outcome& outcome) {
    const std::vector<exporter::View>& views = outcome.options.views;
    const Options& o = outcome.options;
    std::vector<std::string> lines;
    if (views.size() > 1 || o.has_caption) lines = caption(outcome);
    if (o.draft) add_guesses(outcome, lines);
    if (views.size() == 1 && lines.empty()) return view_of(outcome, views.front());
    std::vector<exporter::LabelledImage> pictures;
    for (const exporter::View view : views) {
        const std::string label(views.size() == 1 ? "" : exporter::name(view));
        pictures.push_back({label, view_of(outcome, view)});
    }
    return exporter::contact_sheet(pictures, lines, o.background);
}

}  // namespace ncsim::app
