// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of categories and severities, texts of quantities.
#include "ncsim/verify/finding.h"

#include <fmt/format.h>

namespace ncsim::verify {

std::string_view name_of(Category category) {
    switch (category) {
        case Category::Program: return "program";
        case Category::Collision: return "collision";
        case Category::Travel: return "travel";
        case Category::Process: return "process";
        case Category::SetUp: break;
    }
    return "set-up";
}

std::string_view name_of(Severity severity) {
    switch (severity) {
        case Severity::Note: return "note";
        case Severity::Warning: return "warning";
        case Severity::Error: break;
    }
    return "error";
}

std::string text_of(const Quantity& quantity) {
    return fmt::format("{} {:.6g}{}{}", quantity.name, quantity.value,
                       quantity.unit.empty() ? "" : " ", quantity.unit);
}

std::optional<Vec3> point_of(const Finding& finding) {
    if (finding.point || finding.first_box.is_empty()) return finding.point;
    return finding.first_box.centre();
}

bool less_is_worse(const Quantity& quantity) {
    return quantity.name == "apart";
}

}  // namespace ncsim::verify
