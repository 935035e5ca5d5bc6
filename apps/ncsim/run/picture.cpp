// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws the part, with the machine, paths and tools.
#include "run/picture.h"

#include "ncsim/cda/cell_model.h"
#include "ncsim/export/camera.h"
#include "ncsim/export/contact_sheet.h"
#include "ncsim/export/marks.h"
#include "ncsim/export/render.h"
#include "ncsim/machine/relative.h"
#include "ncsim/simulation/fixtures.h"
#include "ncsim/simulation/models.h"
#include "ncsim/toolpath/joint_path.h"

#include "run/caption.h"
#include "run/finding_colours.h"
#include "run/legend.h"
#include "run/machine_picture.h"
#include "run/sheet_layout.h"
#include "run/tool_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <span>
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
Box machine_box(const Outcome& outcome) {
    Box box;
    for (const setup::MachineBody& body : outcome.machine->bodies) {
        for (const Vec3& p : body.mesh.vertices)
            box.add(p);
    }
    return box;
}

bool is_machine_fixed(const Outcome& outcome) {
    return outcome.options.shows_machine && outcome.options.fixed_body == FixedBody::Machine;
}

// Colours a body that meets another body at the finding of the picture.
void mark_if_met(const Outcome& outcome, const std::string& name, exporter::Body& body) {
    if (!outcome.finding) return;
    const std::vector<std::string>& met = outcome.finding->bodies;
    const auto found = std::ranges::find(met, name);
    if (found != met.end())
        body.colour = found == met.begin() ? kFirstMarkedBody : kSecondMarkedBody;
}

// Returns the positions of the joints after the last move, or at the finding of the picture;
// machine coordinates.
machine::Values joints_of(const Outcome& outcome) {
    if (outcome.finding && outcome.finding->joints) return *outcome.finding->joints;
    const auto& last = outcome.simulation->last_move;
    if (!last) return {};
    return toolpath::JointPath(*outcome.plan.placed, *last).at(1.0).value_or(machine::Values{});
}

// Adds the links around the part, which stays in place.
void add_machine(const Outcome& outcome, exporter::Overlay& overlay) {
    const setup::MachineFile& machine = *outcome.machine;
    const machine::Values values = joints_of(outcome);
    for (const setup::MachineBody& link : machine.bodies) {
        std::vector<Vec3> corners = corners_at(link, values);
        for (Vec3& p : corners)
            p = setup::on_part(machine.part_moved_by, values, p) - outcome.plan.placed->zero;
        overlay.bodies.push_back(machine_body(link, std::move(corners)));
        mark_if_met(outcome, fmt::format("the link '{}'", link.link), overlay.bodies.back());
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
    for (Vec3* direction : {&camera.right, &camera.up, &camera.back})
        *direction = R_WM * *direction;
    return camera;
}

// Returns the box to be shown: in machine coordinates if the machine is fixed, otherwise in W.
Box visible_box(const Outcome& outcome) {
    const Options& o = outcome.options;
    if (is_machine_fixed(outcome)) return machine_box(outcome);
    Box seen = outcome.survey.stock->box;
    if (o.shows_machine) {
        const Box machine = machine_box(outcome);
        seen.add(machine.min - outcome.plan.placed->zero);
        seen.add(machine.max - outcome.plan.placed->zero);
    }
    if (!outcome.fixtures.empty()) seen = simulation::box_with_fixtures(seen, outcome.fixtures);
    if (!o.shows_path && !o.shows_tool) return seen;
    const double reach = kBlockMargin * norm(seen.size());
    const Vec3 margin{reach, reach, reach};
    const Box around{seen.min - margin, seen.max + margin};
    const auto show = [&](Vec3 p) {
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = std::clamp(p[axis], around.min[axis], around.max[axis]);
        seen.add(p);
    };
    const Box& tips = outcome.survey.tip_positions;
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
mesh::CutPlane cut_plane(const brep::SectionPlane& plane, const exporter::Camera& camera) {
    constexpr double kAlong = 1e-9;
    constexpr Vec3 kIsoSide{1, -1, 1};
    double side = camera.back[plane.axis];
    if (std::abs(side) < kAlong) side = kIsoSide[plane.axis];
    mesh::CutPlane cut;
    cut.normal[plane.axis] = side > 0.0 ? 1.0 : -1.0;
    cut.offset = cut.normal[plane.axis] * plane.at;
    return cut;
}

// Size of a view on a sheet. All views of a sheet have one scale.
struct ViewSize {
    double mm_per_pixel = 0.0;  // 0: the view fits the picture
    std::uint32_t rows = 0;     // without the strip for marks
};

// Returns the height of the strip for marks in pixels.
std::uint32_t strip_rows(const Options& o) {
    if (!has_marks(o)) return 0;
    return static_cast<std::uint32_t>(
        std::lround(exporter::mark_strip(o.width, o.height) * o.height));
}

// Returns the sizes of the views. Rows of views on a drawing are only as high as their views need.
std::vector<ViewSize> view_sizes(const Outcome& outcome,
                                 std::span<const exporter::SheetCell> cells) {
    const Options& o = outcome.options;
    const Box box = visible_box(outcome);
    const std::uint32_t most = o.height - strip_rows(o);
    double mm_per_pixel = 0.0;
    for (const exporter::View view : o.views) {
        const double aspect = static_cast<double>(o.width) / most;
        mm_per_pixel =
            std::max(mm_per_pixel, exporter::fit_camera(box, view, aspect).height / most);
    }
    std::vector<ViewSize> sizes(o.views.size(), {mm_per_pixel, most});
    if (cells.empty()) return sizes;
    constexpr double kLeast = 0.3, kAnyWidth = 1e9;
    std::map<std::uint32_t, std::uint32_t> rows;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double needed =
            exporter::fit_camera(box, o.views[i], kAnyWidth).height / mm_per_pixel;
        std::uint32_t& row = rows[cells[i].row];
        row = std::max(row, static_cast<std::uint32_t>(
                                std::clamp(std::ceil(needed), kLeast * most, 1.0 * most)));
    }
    for (std::size_t i = 0; i < cells.size(); ++i)
        sizes[i].rows = rows[cells[i].row];
    return sizes;
}

exporter::RenderOptions render_options(const Outcome& outcome, exporter::View view,
                                       const ViewSize& size) {
    const Options& o = outcome.options;
    const Box& stock = outcome.survey.stock->box;
    const Box& tips = outcome.survey.tip_positions;
    exporter::RenderOptions options;
    options.width = o.width;
    options.height = o.height;
    options.background = o.background;
    options.renderer = o.renderer;
    options.colouring = o.colouring;
    options.shades_recesses = o.shades_recesses;
    options.see_through = o.see_through;
    options.ghost_stock = outcome.survey.stock->specified_by == toolpath::ValueSource::Assumption;
    options.depth_top = stock.max.z;
    options.depth_bottom = std::max(stock.min.z, tips.min.z);
    double strip = has_marks(o) ? exporter::mark_strip(o.width, o.height) : 0.0;
    options.camera =
        exporter::fit_camera(visible_box(outcome), view, o.width / ((1.0 - strip) * o.height));
    if (size.mm_per_pixel > 0.0) {
        options.usual_height = o.height;
        options.height = size.rows + strip_rows(o);
        options.camera.height = size.rows * size.mm_per_pixel;
        strip = static_cast<double>(strip_rows(o)) / options.height;
    }
    options.camera = exporter::with_mark_strip(options.camera, strip);
    options.camera.depth += simulation::reach_of(outcome.fixtures);
    if (o.shows_machine) options.camera.depth += norm(machine_box(outcome).size());
    // Paths and tools beyond the picture may also be far in front of it.
    if (o.shows_path || o.shows_tool) {
        Box all = stock;
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
    if (outcome.design) options.distances = &outcome.design->distances;
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
        mark_if_met(outcome, verify::name_of(fixture), result.bodies.back());
    }
    if (!outcome.options.shows_tool || !s.tool_position) return result;
    const auto used = outcome.survey.tools.find(s.tool_position->tool);
    if (used != outcome.survey.tools.end())
        std::ranges::move(tool_bodies(used->second.tool, s.tool_position->X_WT,
                                      outcome.finding != nullptr &&
                                          outcome.finding->category == verify::Category::Collision),
                          std::back_inserter(result.bodies));
    return result;
}

// Removes the marks that are equal in all views of a sheet: the first view has them.
void remove_common(exporter::Marks& marks) {
    marks.legend.clear();
    marks.scale_begin.clear();
    marks.scale_end.clear();
    marks.has_size = false;
}

exporter::Image view_of(const Outcome& outcome, exporter::View view, const ViewSize& size = {},
                        bool is_first = true) {
    const simulation::Simulation& s = *outcome.simulation;
    const exporter::RenderOptions options = render_options(outcome, view, size);
    // The thesis' method: rendering with masks.
    exporter::Image image =
        draws_cells(outcome.options)
            ? exporter::render_model(dynamic_cast<const cda::CellModel&>(*s.part), s.provenance,
                                     options, overlay(outcome))
            : exporter::render_boundary(*outcome.boundary, s.provenance, options, overlay(outcome),
                                        outcome.shading ? *outcome.shading : brep::Shading());
    if (has_marks(outcome.options)) {
        exporter::Marks marks = marks_of(outcome, options);
        if (size.mm_per_pixel > 0.0) marks.strip_rows = strip_rows(outcome.options);
        if (!is_first) remove_common(marks);
        exporter::draw_marks(image, options.camera, options.background, marks);
    }
    return image;
}

}  // namespace

void require_cut_view(const Options& options, const Box& body, std::string_view name) {
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
    const std::vector<std::string> lines = caption_of(outcome);
    if (views.size() == 1 && lines.empty()) return view_of(outcome, views.front());
    std::vector<exporter::LabelledImage> pictures;
    if (views.size() == 1) {
        pictures.push_back({"", view_of(outcome, views.front())});
        return exporter::contact_sheet(pictures, lines, outcome.options.background);
    }
    const std::vector<exporter::SheetCell> cells = third_angle(views);
    const std::vector<ViewSize> sizes = view_sizes(outcome, cells);
    for (std::size_t i = 0; i < views.size(); ++i) {
        pictures.push_back(
            {std::string(exporter::name(views[i])), view_of(outcome, views[i], sizes[i], i == 0)});
    }
    return cells.empty()
               ? exporter::contact_sheet(pictures, lines, outcome.options.background)
               : exporter::contact_sheet(pictures, cells, lines, outcome.options.background);
}

}  // namespace ncsim::app
