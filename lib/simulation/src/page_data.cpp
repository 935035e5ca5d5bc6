// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the data of a page from a simulation.
#include "ncsim/simulation/page_data.h"

#include "ncsim/brep/surface_forms.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/export/camera.h"
#include "ncsim/export/png.h"
#include "ncsim/export/render.h"
#include "ncsim/export/shrink.h"
#include "ncsim/simulation/face_form.h"
#include "ncsim/simulation/fixtures.h"
#include "ncsim/simulation/shading.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::simulation {

namespace {

// Parts with more triangles are shown by the last state of the play only. The states have the same
// geometry, on the grid of the recorder; forms and tools of faces are missing.
constexpr std::size_t kMostTriangles = 400'000;

// Forms, each listed once, from 1.
class FormList {
public:
    explicit FormList(std::vector<FaceForm>& forms) : forms_(forms) {}

    std::uint32_t number_of(FaceForm form) {
        // Motions along one bore leave the same cylinder; decimals that no page shows are dropped.
        std::vector<std::int64_t> key;
        for (const double length : form.dimensions)
            key.push_back(std::llround(1e5 * length));
        for (const Vec3& v : {form.axis, form.origin}) {
            for (const double c : {v.x, v.y, v.z})
                key.push_back(std::llround(1e5 * c));
        }
        key.push_back(form.is_hollow ? 1 : 0);
        const auto next = static_cast<std::uint32_t>(forms_.size() + 1);
        const auto [known, is_new] = numbers_.try_emplace({form.name, std::move(key)}, next);
        if (is_new) forms_.push_back(std::move(form));
        return known->second;
    }

private:
    std::vector<FaceForm>& forms_;
    std::map<std::pair<std::string, std::vector<std::int64_t>>, std::uint32_t> numbers_;
};

// Pixels of a picture of the page for each pixel of the small picture, along each side.
constexpr std::uint32_t kThumbnailFactor = 4;

std::string png_of(const exporter::Image& image) {
    std::ostringstream png;
    exporter::write_png(png, image);
    return std::move(png).str();
}

// Returns the number of triangles of a boundary, approximately.
std::size_t triangles_of(const cda::Boundary& boundary) {
    std::size_t count = 0;
    for (const cda::BoundaryFace& face : boundary.faces) {
        for (const auto& loop : face.loops)
            count += loop.size();
    }
    return count;
}

void add_pictures(const Survey& survey, const Simulation& simulation, const cda::Boundary& boundary,
                  std::span<const verify::Fixture> fixtures, const brep::Shading& shading,
                  PageData& data) {
    exporter::RenderOptions render;
    render.width = 800;
    render.height = 600;
    render.colouring = exporter::Colouring::Tool;
    exporter::Overlay overlay;
    for (const verify::Fixture& fixture : fixtures)
        overlay.bodies.push_back(body_of(fixture));
    const Box box = box_with_fixtures(survey.stock->box, fixtures);
    using exporter::View;
    for (const auto& [name, view] :
         {std::pair{"from above", View::Top}, std::pair{"isometric", View::Iso}}) {
        render.camera = exporter::fit_camera(box, view, 4 / 3.0);
        render.camera.depth += reach_of(fixtures);
        const exporter::Image image =
            exporter::render_boundary(boundary, simulation.provenance, render, overlay, shading);
        data.pictures.emplace_back(name, png_of(image));
        if (view == View::Iso) data.thumbnail = png_of(exporter::shrink(image, kThumbnailFactor));
    }
}

}  // namespace

PageData page_data(const Plan& plan, const Survey& survey, const Simulation& simulation,
                   const cda::Boundary& boundary, std::span<const verify::Fixture> fixtures,
                   bool has_pictures) {
    PageData data;
    data.source = plan.job.program.text;
    data.stock = survey.stock->box;
    for (const verify::Fixture& fixture : fixtures) {
        const exporter::Body body = body_of(fixture);
        data.fixtures.push_back({cda::triangulate(body.surface),
                                 {body.colour.r, body.colour.g, body.colour.b},
                                 verify::name_of(fixture)});
    }
    const bool is_large = triangles_of(boundary) > kMostTriangles;
    if (is_large && !has_pictures) return data;
    const brep::Shading shading = shading_of(plan, survey, simulation, boundary);
    if (has_pictures) add_pictures(survey, simulation, boundary, fixtures, shading, data);
    if (is_large) return data;
    data.mesh = cda::triangulate(boundary, plan.threads);
    std::map<const brep::Surface*, std::uint32_t> number_of;
    FormList forms(data.forms);
    for (std::size_t t = 0; t < data.mesh.triangles.size(); ++t) {
        const std::uint32_t f = data.mesh.face[t];
        const cda::BoundaryFace& face = boundary.faces[f];
        const mesh::Provenance::Entry entry = simulation.provenance.of(face.origin);
        data.lines.push_back(entry.nc_line);
        data.tool_of.push_back(entry.tool);
        for (const std::uint32_t v : data.mesh.triangles[t])
            data.normals.push_back(shading.normal(f, face.normal, v, data.mesh.vertices[v]));
        std::uint32_t number = 0;
        if (const brep::Surface* surface = shading.surface_of(f)) {
            const auto [known, is_new] = number_of.try_emplace(surface, 0);
            if (is_new) known->second = forms.number_of(form_of(*surface));
            number = known->second;
        }
        data.form_of.push_back(number);
    }
    return data;
}

PlayData finish_play(PlayRecorder& play, const Simulation& simulation) {
    std::vector<std::uint32_t> lines;
    for (const mesh::Provenance::Entry& entry : simulation.provenance.entries)
        lines.push_back(entry.nc_line);
    return play.finish(*simulation.part, std::move(lines));
}

}  // namespace ncsim::simulation
