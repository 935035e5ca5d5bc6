// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces of a solid, and its STEP file.
#include "solid_data.h"

#include "ncsim/export/step.h"
#include "ncsim/simulation/face_form.h"

#include "interruptible.h"
#include "output_file.h"

#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <ostream>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ncsim::python {

namespace py = pybind11;

namespace {

py::tuple tuple_of(Vec3 v) {
    return py::make_tuple(v.x, v.y, v.z);
}

// Returns the areas of all faces, mm².
std::vector<double> areas_of(const brep::Part& part) {
    std::vector<double> areas;
    areas.reserve(part.faces.size());
    for (const brep::Face& face : part.faces)
        areas.push_back(brep::measure(part, face, {}).area);
    return areas;
}

// Returns the arguments of ncsim.Face.
py::dict face_dict(const SolidData& data, const brep::Face& face, double area) {
    const simulation::FaceForm form = simulation::form_of(face.surface);
    std::set<std::uint32_t> lines, tools;
    for (const cda::Origin origin : face.origins) {
        const auto entry = data.solid.provenance.of(origin);
        if (entry.is_stock()) continue;
        if (entry.nc_line != 0) lines.insert(entry.nc_line);
        tools.insert(entry.tool);
    }
    py::dict result;
    result["kind"] = form.name;
    result["dimensions"] = py::tuple(py::cast(form.dimensions));
    result["axis"] = tuple_of(form.axis);
    result["origin"] = tuple_of(form.origin);
    result["is_hollow"] = form.is_hollow;
    result["is_facet"] = face.is_facet;
    result["area"] = area;
    result["lines"] = py::tuple(py::cast(std::vector<std::uint32_t>(lines.begin(), lines.end())));
    result["tools"] = py::tuple(py::cast(std::vector<std::uint32_t>(tools.begin(), tools.end())));
    return result;
}

py::list faces_of(const SolidData& data) {
    const brep::Part& part = data.solid.recognised.part;
    const std::vector<double> areas =
        interruptible([&](const std::stop_token&) { return areas_of(part); });
    py::list faces;
    for (std::size_t i = 0; i < areas.size(); ++i)
        faces.append(face_dict(data, part.faces[i], areas[i]));
    return faces;
}

void write_step(const SolidData& data, const std::string& path, bool attributes) {
    interruptible([&](const std::stop_token&) {
        if (!data.solid.recognised.is_sound) throw std::runtime_error(exporter::kUnsoundSolid);
        exporter::StepOptions options;
        options.mass = data.mass;
        options.has_attributes = attributes;
        write_file(path, [&](std::ostream& out) {
            exporter::write_step_solid(out, data.solid.recognised.part, data.solid.provenance,
                                       options);
        });
    });
}

}  // namespace

SolidData::SolidData(simulation::Solid made)
    : solid(std::move(made)), mass(brep::mass_of(solid.recognised.part)) {}

void define_solid(py::module_& module) {
    py::class_<SolidData, std::shared_ptr<SolidData>>(module, "Solid")
        .def("faces", &faces_of)
        .def_property_readonly("volume", [](const SolidData& data) { return data.mass.volume; })
        .def_property_readonly("area", [](const SolidData& data) { return data.mass.area; })
        .def_property_readonly("centroid",
                               [](const SolidData& data) { return tuple_of(data.mass.centroid); })
        .def_property_readonly(
            "solids",
            [](const SolidData& data) { return data.solid.recognised.part.solids.size(); })
        .def_property_readonly(
            "facets", [](const SolidData& data) { return data.solid.recognised.facets_kept; })
        .def_property_readonly(
            "miss", [](const SolidData& data) { return data.solid.recognised.part.miss_mm; })
        .def("write_step", &write_step, py::arg("path"), py::arg("attributes"));
}

}  // namespace ncsim::python
