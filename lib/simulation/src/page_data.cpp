// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the data of a page from a simulation.
#include "ncsim/simulation/page_data.h"

#include "ncsim/brep/surface_forms.h"
#include "ncsim/cda/mesh.h"
#include "ncsim/export/camera.h"
#include "ncsim/export/png.h"
#include "ncsim/export/render.h"
#include "ncsim/report/file_names.h"
#include "ncsim/simulation/fixtures.h"
#include "ncsim/simulation/shading.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::simulation {

namespace {

report::FaceForm form_of(const brep::Surface& surface) {
    report::FaceForm form;
    form.name = "swept surface";
    if (surface.form.index() < brep::kForms.size()) form.name = brep::kForms[surface.form.index()];
    form.is_hollow = surface.is_hollow;
    if (const auto* plane = std::get_if<brep::Plane>(&surface.form)) {
        form.origin = plane->origin;
        form.axis = plane->normal;
    } else if (const auto* cylinder = std::get_if<brep::Cylinder>(&surface.form)) {
        form.origin = cylinder->origin;
        form.axis = cylinder->axis;
        form.dimensions = {2 * cylinder->radius};
    } else if (const auto* cone = std::get_if<brep::Cone>(&surface.form)) {
        form.origin = cone->apex;
        form.axis = cone->axis;
        form.dimensions = {2 * std::atan(cone->slope) * 180 / std::numbers::pi};
    } else if (const auto* sphere = std::get_if<brep::Sphere>(&surface.form)) {
        form.origin = sphere->centre;
        form.dimensions = {2 * sphere->radius};
    } else if (const auto* torus = std::get_if<brep::Torus>(&surface.form)) {
        form.origin = torus->centre;
        form.axis = torus->axis;
        form.dimensions = {2 * torus->major, 2 * torus->minor};
    }
    return form;
}

void add_pictures(const Survey& survey, const Simulation& simulation, const cda::Boundary& boundary,
                  std::span<const verify::Fixture> fixtures, const brep::Shading& shading,
                  report::PageData& data) {
    exporter::RenderOptions render;
    render.width = 800;
    render.height = 600;
    render.colouring = exporter::Colouring::Tool;
    exporter::Overlay overlay;
    for (const verify::Fixture& fixture : fixtures)
        overlay.bodies.push_back(body_of(fixture));
    const cda::Box box = box_with_fixtures(survey.stock->box, fixtures);
    using exporter::View;
    for (const auto& [name, view] :
         {std::pair{"from above", View::Top}, std::pair{"isometric", View::Iso}}) {
        render.camera = exporter::fit_camera(box, view, 4 / 3.0);
        render.camera.depth += reach_of(fixtures);
        std::ostringstream png;
        exporter::write_png(png, exporter::render_boundary(boundary, simulation.provenance, render,
                                                           overlay, shading));
        data.pictures.emplace_back(name, png.str());
    }
}

}  // namespace

report::PageData page_data(const Plan& plan, const Survey& survey, const Simulation& simulation,
                           const cda::Boundary& boundary, std::span<const verify::Fixture> fixtures,
                           bool has_pictures) {
    report::PageData data;
    data.source = plan.job.program.text;
    data.stock = survey.stock->box;
    const brep::Shading shading = shading_of(plan, survey, simulation, boundary);
    data.mesh = cda::triangulate(boundary, plan.threads);
    std::map<const brep::Surface*, std::uint32_t> forms;
    for (std::size_t t = 0; t < data.mesh.triangles.size(); ++t) {
        const std::uint32_t f = data.mesh.face[t];
        const cda::BoundaryFace& face = boundary.faces[f];
        const exporter::Provenance::Entry entry = simulation.provenance.of(face.origin);
        data.lines.push_back(entry.nc_line);
        data.tool_of.push_back(entry.tool);
        for (const std::uint32_t v : data.mesh.triangles[t])
            data.normals.push_back(shading.normal(f, face.normal, v, data.mesh.vertices[v]));
        std::uint32_t number = 0;
        if (const brep::Surface* surface = shading.surface_of(f)) {
            const auto next = static_cast<std::uint32_t>(data.forms.size() + 1);
            const auto [known, is_new] = forms.try_emplace(surface, next);
            if (is_new) data.forms.push_back(form_of(*surface));
            number = known->second;
        }
        data.form_of.push_back(number);
    }
    for (const verify::Fixture& fixture : fixtures) {
        const exporter::Body body = body_of(fixture);
        data.fixtures.push_back(
            {cda::triangulate(body.surface), {body.colour.r, body.colour.g, body.colour.b}});
    }
    if (has_pictures) add_pictures(survey, simulation, boundary, fixtures, shading, data);
    return data;
}

report::PlayData finish_play(PlayRecorder& play, const Simulation& simulation) {
    std::vector<std::uint32_t> lines;
    for (const exporter::Provenance::Entry& entry : simulation.provenance.entries)
        lines.push_back(entry.nc_line);
    return play.finish(*simulation.part, std::move(lines));
}

}  // namespace ncsim::simulation
