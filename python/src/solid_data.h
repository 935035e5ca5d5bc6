// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part with true surfaces.
#pragma once

#include "ncsim/brep/measure.h"
#include "ncsim/simulation/solid.h"

#include <pybind11/pybind11.h>

namespace ncsim::python {

/// A solid with its mass properties.
struct SolidData {
    explicit SolidData(simulation::Solid made);

    simulation::Solid solid;
    brep::Mass mass;
};

/// Adds the class Solid to `module`.
void define_solid(pybind11::module_& module);

}  // namespace ncsim::python
