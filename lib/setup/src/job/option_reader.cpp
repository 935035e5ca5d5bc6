// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads options of commands in TOML files.
#include "job/option_reader.h"

#include <fmt/format.h>

namespace ncsim::setup {

OptionSetting read_option(const TomlReader& reader, const std::string& option,
                          const std::string& key, const toml::node& node) {
    const auto value_of = [&](const toml::node& value) {
        if (value.is_string()) return TomlReader::text(value);
        if (value.is_number()) return fmt::format("{}", TomlReader::number(value));
        reader.fail(value,
                    fmt::format("'{}': expected a text, a number, true, false or a list", key));
    };
    OptionSetting setting;
    setting.option = option;
    setting.where = reader.place_of(node);
    if (node.is_boolean()) {
        setting.is_flag = true;
        setting.is_on = node.as_boolean()->get();
    } else if (node.is_array()) {
        for (const toml::node& one : *node.as_array())
            setting.values.push_back(value_of(one));
    } else {
        setting.values.push_back(value_of(node));
    }
    return setting;
}

}  // namespace ncsim::setup
