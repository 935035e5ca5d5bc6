// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quoted strings for JSON and TOML.
#include "ncsim/report/json_string.h"

#include "json.h"

namespace ncsim::report {

std::string json_string(std::string_view text) {
    return to_line(Json(text));
}

}  // namespace ncsim::report
