// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws a machine.
#include "run/machine_picture.h"

#include "ncsim/export/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace ncsim::app {

void make_transparent(setup::MachineFile& file, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        const auto link = std::ranges::find(file.bodies, name, &setup::MachineBody::link);
        if (link == file.bodies.end()) {
            throw std::runtime_error(
                fmt::format("--transparent: no link '{}' has a mesh in the machine", name));
        }
        link->is_transparent = true;
    }
}

// Each triangle becomes a face, except triangles without area.
exporter::Body machine_body(const setup::MachineBody& link, std::vector<Vec3> corners) {
    exporter::Body body;
    constexpr std::uint8_t kOpaque = 255, kTransparent = 76;  // three tenths
    body.colour = {link.colour[0], link.colour[1], link.colour[2],
                   link.is_transparent ? kTransparent : kOpaque};
    body.surface.vertices = std::move(corners);
    body.surface.shells = 1;
    for (const auto& t : link.mesh.triangles) {
        const auto& v = body.surface.vertices;
        const Vec3 across = cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]);
        if (norm(across) == 0.0) continue;
        cda::BoundaryFace face;
        face.normal = normalized(across);
        face.offset = dot(face.normal, v[t[0]]);
        face.loops = {{t[0], t[1], t[2]}};
        body.surface.faces.push_back(std::move(face));
    }
    return body;
}

exporter::Image picture_of(const setup::MachineFile& file, const machine::Values& values,
                           exporter::View view) {
    exporter::Overlay overlay;
    Box box;
    for (const setup::MachineBody& link : file.bodies) {
        overlay.bodies.push_back(machine_body(link, corners_at(link, values)));
        for (const Vec3& p : overlay.bodies.back().surface.vertices)
            box.add(p);
    }
    if (overlay.bodies.empty())
        throw std::runtime_error("--png: no link of the machine has a mesh");
    exporter::RenderOptions render;
    render.camera = exporter::fit_camera(box, view, 4 / 3.0);
    return exporter::render_boundary({}, {}, render, overlay);
}

}  // namespace ncsim::app
