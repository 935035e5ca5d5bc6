// SPDX-License-Identifier: GPL-3.0-or-later
//
// What all JSON of ncsim has in common: keys in the order in which they are told, numbers without
// dust, text that nobody obeys.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/diagnostic.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace ncsim::report {

using Json = nlohmann::ordered_json;

/// To a millionth: what a length (mm), an area or a volume can mean; the dust of decimal fractions
/// in binary is not worth a reader's time.
double tidy(double value);

/// A whole number that is not negative, of a file that anybody may have written. Throws
/// Json::exception if it is none, or larger than a T may be.
template <class T>
T whole_number(const Json& json) {
    const auto value = json.get_ref<const Json::number_unsigned_t&>();
    if (value > static_cast<Json::number_unsigned_t>(std::numeric_limits<T>::max()))
        throw Json::out_of_range::create(406, "a number is too large", &json);
    return static_cast<T>(value);
}

/// [x, y, z]
Json vector_json(cda::Vec3 v);

/// An array of {severity, code, message, file, line, column, count}.
Json findings_json(const gcode::Diagnostics& diagnostics);

/// One line of JSON; bytes that are no UTF-8 become U+FFFD.
std::string to_line(const Json& json);
/// JSON for files and for the standard output, a line for each thing; the same of bytes.
std::string to_text(const Json& json);

}  // namespace ncsim::report
