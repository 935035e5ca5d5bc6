// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the interpreter has to say, sorted under the rules.
#include "rule_table.h"

#include <array>
#include <utility>

namespace ncsim::verify {

std::string_view rule_of_diagnostic(std::string_view code) {
    using Entry = std::pair<std::string_view, std::string_view>;
    static constexpr auto kTable = std::to_array<Entry>({
        {"unknown-g", "unsupported-word"},
        {"unknown-g-with-axes", "unsupported-word"},
        {"unknown-m", "unsupported-word"},
        {"unknown-word", "unsupported-word"},
        {"o-word-unknown", "unsupported-word"},
        {"function-unknown", "unsupported-word"},
        {"console-command", "unsupported-word"},
        {"g10-form", "unsupported-word"},
        {"tilted-plane", "unsupported-word"},
        {"lathe-cycle", "unsupported-word"},
        {"tool-unknown", "tool-undefined"},
        {"offset-unknown", "offset-undefined"},
        {"compensation-radius-unknown", "offset-undefined"},
        // Told motion by motion by rules of their own.
        {"start-unknown", ""},
        {"feed-missing", ""},
    });
    for (const auto& [known, rule] : kTable) {
        if (known == code) return rule;
    }
    return "program-fault";
}

}  // namespace ncsim::verify
