// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verification of a program.
#pragma once

#include <pybind11/pybind11.h>

namespace ncsim::python {

/// Adds the function check() to `module`.
void define_check(pybind11::module_& module);

}  // namespace ncsim::python
