// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values and texts for JSON output.
#include "json.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/verify/finding.h"

#include <cmath>
#include <utility>

namespace ncsim::report {

double round_value(double value) {
    return std::round(value * 1e6) / 1e6 + 0.0;
}

Json vector_json(Vec3 v) {
    return Json::array({round_value(v.x), round_value(v.y), round_value(v.z)});
}

Json rounded_json(const std::optional<double>& value) {
    return value ? Json(round_value(*value)) : Json();
}

Json box_json(const Box& box) {
    if (box.is_empty()) return nullptr;
    return {{"min", vector_json(box.min)}, {"max", vector_json(box.max)}};
}

Json findings_json(const gcode::Diagnostics& diagnostics) {
    Json findings = Json::array();
    for (const gcode::Diagnostic& d : diagnostics) {
        Json finding{
            {"severity", verify::name_of(d.severity)}, {"code", d.code}, {"message", d.message}};
        if (!d.file.empty()) finding["file"] = d.file;
        if (d.span.line != 0) {
            finding["line"] = d.span.line;
            finding["column"] = d.span.column;
        }
        finding["count"] = d.count;
        findings.push_back(std::move(finding));
    }
    return findings;
}

std::string to_line(const Json& json) {
    return printable_json(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string to_text(const Json& json) {
    return printable_json(json.dump(1, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace ncsim::report
