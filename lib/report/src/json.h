// SPDX-License-Identifier: GPL-3.0-or-later
//
// What all JSON of ncsim has in common: keys in the order in which they are told, numbers without
// dust, text that nobody obeys.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/diagnostic.h"

#include <nlohmann/json.hpp>
#include <string>

namespace ncsim::report {

using Json = nlohmann::ordered_json;

/// To a millionth: what a length (mm), an area or a volume can mean; the dust of decimal fractions
/// in binary is not worth a reader's time.
double tidy(double value);

/// [x, y, z]
Json vector_json(cda::Vec3 v);

/// An array of {severity, code, message, file, line, column, count}.
Json findings_json(const gcode::Diagnostics& diagnostics);

/// One line of JSON; bytes that are no UTF-8 become U+FFFD.
std::string to_line(const Json& json);
/// JSON for files and for the standard output, a line for each thing; the same of bytes.
std::string to_text(const Json& json);

}  // namespace ncsim::report
