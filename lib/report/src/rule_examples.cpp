// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the files of a rule in the text that cmake/bundle.cmake writes.
#include "rule_examples.h"

#include <cstddef>
#include <string>

namespace ncsim::report {

extern const std::string_view kRuleExamples;

std::vector<ExampleFile> rule_example(std::string_view rule) {
    constexpr std::string_view kMark = "=== ";
    const std::string folder = std::string(rule) + '/';
    std::vector<ExampleFile> files;
    for (std::string_view rest = kRuleExamples; !rest.empty();) {
        const std::size_t line = rest.find('\n');
        std::string_view name = rest.substr(kMark.size(), line - kMark.size());
        rest.remove_prefix(line + 1);
        // A file begins at the start of a line.
        const std::size_t next = rest.starts_with(kMark) ? 0 : rest.find("\n=== ") + 1;
        const std::size_t end = next == 0 && !rest.starts_with(kMark) ? rest.size() : next;
        if (name.starts_with(folder)) {
            name.remove_prefix(folder.size());
            files.push_back({name, rest.substr(0, end)});
        }
        rest.remove_prefix(end);
    }
    return files;
}

}  // namespace ncsim::report
