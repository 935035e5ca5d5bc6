// SPDX-License-Identifier: GPL-3.0-or-later
#include "number_range.h"

#include <fmt/format.h>

#include <string>

namespace ncsim::app {

CLI::Validator number_range(double least, double most) {
    const auto refused = [least, most](std::string& text) {
        double number = 0.0;
        const bool is_number = CLI::detail::lexical_cast(text, number);
        if (is_number && number >= least && number <= most) return std::string();
        return fmt::format("expected {:g} to {:g}, not {}", least, most, text);
    };
    return CLI::Validator(refused, "");
}

}  // namespace ncsim::app
