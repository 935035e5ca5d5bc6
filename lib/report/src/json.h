// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conventions for all JSON of ncsim: keys in the order of insertion, rounded numbers, and text
// without commands for CI services.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/diagnostic.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace ncsim::report {

using Json = nlohmann::ordered_json;

/// Rounds to a millionth of the unit, finer than any meaningful length (mm), area or volume, to
/// hide the rounding errors of binary fractions.
double round_value(double value);

/// Returns a non-negative whole number from an untrusted file.
/// Throws: Json::exception if `json` is not a non-negative whole number, or is too large for T.
template <class T>
T whole_number(const Json& json) {
    const auto value = json.get_ref<const Json::number_unsigned_t&>();
    if (value > static_cast<Json::number_unsigned_t>(std::numeric_limits<T>::max()))
        throw Json::out_of_range::create(406, "a number is too large", &json);
    return static_cast<T>(value);
}

/// Returns the rounded value; null if there is none.
Json rounded_json(const std::optional<double>& value);
/// Returns [x, y, z].
Json vector_json(Vec3 v);
/// Returns {min, max}; null for an empty box.
Json box_json(const Box& box);

/// Returns an array of {severity, code, message, file, line, column, count}.
Json findings_json(const gcode::Diagnostics& diagnostics);

/// Returns one line of JSON; bytes that are not UTF-8 become U+FFFD.
std::string to_line(const Json& json);
/// Returns indented JSON for files and for the standard output; bytes that are not UTF-8 become
/// U+FFFD.
std::string to_text(const Json& json);

}  // namespace ncsim::report
