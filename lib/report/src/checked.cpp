// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of programs and files, and headlines of findings.
#include "ncsim/report/checked.h"

#include "ncsim/base/file_names.h"

#include <filesystem>

namespace ncsim::report {

std::string name_of(const Checked& checked) {
    return checked.program.empty() ? checked.path : checked.path + " (" + checked.program + ')';
}

std::string file_of(const Checked& checked, const verify::Place& place) {
    const auto& files = checked.verdict.files;
    if (place.file == 0 || place.file >= files.size()) return relative_path(checked.path);
    const auto folder = std::filesystem::path(checked.path).parent_path();
    return relative_path((folder / files[place.file]).string());
}

std::string headline(const verify::Finding& f) {
    std::string text = f.message;
    if (f.quantity) text += ": " + verify::text_of(*f.quantity);
    if (f.certainty == verify::Certainty::Within) {
        text += ", not certain: within the accuracy of the tool";
    }
    return text;
}

}  // namespace ncsim::report
