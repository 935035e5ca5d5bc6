// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the mesh of a part, and its NumPy arrays.
#include "mesh_data.h"

#include "ncsim/cda/triangulate.h"
#include "ncsim/export/stl.h"

#include "arrays.h"
#include "interruptible.h"
#include "output_file.h"

#include <memory>
#include <ostream>

namespace ncsim::python {

namespace py = pybind11;

namespace {

using SharedMesh = std::shared_ptr<const MeshData>;

// The arrays refer to the coordinates and indices as rows of three.
static_assert(sizeof(Vec3) == 3 * sizeof(double));
static_assert(sizeof(std::array<std::uint32_t, 3>) == 3 * sizeof(std::uint32_t));

py::array vertices_of(const SharedMesh& data) {
    const auto& vertices = data->mesh.vertices;
    const double* const first = vertices.empty() ? nullptr : &vertices.front().x;
    return view_of(first, {static_cast<py::ssize_t>(vertices.size()), 3}, data);
}

py::array triangles_of(const SharedMesh& data) {
    const auto& triangles = data->mesh.triangles;
    const std::uint32_t* const first = triangles.empty() ? nullptr : triangles.front().data();
    return view_of(first, {static_cast<py::ssize_t>(triangles.size()), 3}, data);
}

void write_stl(const SharedMesh& data, const std::string& path) {
    interruptible([&](const std::stop_token&) {
        write_file(path, [&](std::ostream& out) {
            exporter::write_stl(out, data->mesh, data->threads, data->assumed);
        });
    });
}

}  // namespace

MeshData mesh_data(const cda::Boundary& boundary, const mesh::Provenance& provenance,
                   unsigned threads) {
    MeshData data;
    data.mesh = cda::triangulate(boundary, threads);
    data.lines.reserve(data.mesh.triangles.size());
    data.tools.reserve(data.mesh.triangles.size());
    for (const std::uint32_t face : data.mesh.face) {
        const mesh::Provenance::Entry entry = provenance.of(boundary.faces[face].origin);
        data.lines.push_back(entry.nc_line);
        data.tools.push_back(entry.tool);
    }
    data.volume = cda::volume(boundary);
    data.area = cda::area(boundary);
    data.shells = boundary.shells;
    data.threads = threads;
    data.assumed = provenance.assumed;
    return data;
}

void define_mesh(py::module_& module) {
    py::class_<MeshData, std::shared_ptr<MeshData>>(module, "Mesh")
        .def_property_readonly("vertices", &vertices_of)
        .def_property_readonly("triangles", &triangles_of)
        .def_property_readonly("lines",
                               [](const SharedMesh& data) { return view_of(data->lines, data); })
        .def_property_readonly("tools",
                               [](const SharedMesh& data) { return view_of(data->tools, data); })
        .def_property_readonly(
            "faces", [](const SharedMesh& data) { return view_of(data->mesh.face, data); })
        .def_readonly("volume", &MeshData::volume)
        .def_readonly("area", &MeshData::area)
        .def_readonly("shells", &MeshData::shells)
        .def("write_stl", &write_stl, py::arg("path"));
}

}  // namespace ncsim::python
