// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names and dimensions of surfaces.
#include "ncsim/simulation/face_form.h"

#include "ncsim/base/angles.h"

#include <variant>

namespace ncsim::simulation {

FaceForm form_of(const brep::Surface& surface) {
    FaceForm form;
    form.name = "swept surface";
    if (surface.form.index() < brep::kForms.size()) form.name = brep::kForms[surface.form.index()];
    form.is_hollow = surface.is_hollow;
    if (const auto* plane = std::get_if<brep::Plane>(&surface.form)) {
        form.axis = plane->normal;
    } else if (const auto* cylinder = std::get_if<brep::Cylinder>(&surface.form)) {
        form.origin = cylinder->origin;
        form.axis = cylinder->axis;
        form.dimensions = {2 * cylinder->radius};
    } else if (const auto* cone = std::get_if<brep::Cone>(&surface.form)) {
        form.origin = cone->apex;
        form.axis = cone->axis;
        form.dimensions = {2 * angle_of(1.0, cone->slope)};
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

}  // namespace ncsim::simulation
