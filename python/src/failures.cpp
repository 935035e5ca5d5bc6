// SPDX-License-Identifier: GPL-3.0-or-later
//
// Translates failures to Python exceptions.
#include "failures.h"

#include "ncsim/verify/finding.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace ncsim::python {

namespace py = pybind11;

namespace {

// Sets the Python error to ncsim._errors.NAME(arguments…).
template <class... Arguments>
void set_error(const char* name, Arguments&&... arguments) {
    const py::object type = py::module_::import("ncsim._errors").attr(name);
    const py::object error = type(std::forward<Arguments>(arguments)...);
    PyErr_SetObject(type.ptr(), error.ptr());
}

void translate(std::exception_ptr failure) {
    try {
        if (failure) std::rethrow_exception(std::move(failure));
    } catch (const UsageFailure& e) {
        set_error("UsageError", e.what());
    } catch (const ProgramFailure& e) {
        set_error("ProgramError", e.what(), diagnostic_list(e.diagnostics, e.program));
    } catch (const py::builtin_exception&) {
        throw;  // a Python exception of pybind11 itself
    } catch (const std::runtime_error& e) {
        set_error("Error", e.what());
    }
}

}  // namespace

py::list diagnostic_list(const gcode::Diagnostics& diagnostics, const std::string& program) {
    py::list list;
    for (const gcode::Diagnostic& d : diagnostics) {
        list.append(py::make_tuple(std::string(verify::name_of(d.severity)), d.code, d.message,
                                   d.file.empty() ? program : d.file, d.span.line, d.span.column,
                                   d.count));
    }
    return list;
}

void register_failures() {
    py::register_exception_translator(&translate);
}

}  // namespace ncsim::python
