// SPDX-License-Identifier: GPL-3.0-or-later
//
// Schemas of the project's TOML files. docs/schemas has the table of keys, types, ranges and
// meanings; editors, the reference pages and the readers use the same table.
#pragma once

#include <toml++/toml.h>

#include <functional>
#include <string>
#include <string_view>

namespace ncsim::setup {

/// JSON schemas, draft 7.
extern const std::string_view kMachineSchema, kJobSchema, kHoldersSchema, kProjectSchema;

/// Follows a reference of `schema` within the schema `root`. `Json` is a type of JSON values.
template <class Json>
const Json& resolved_schema(const Json& root, const Json& schema) {
    const auto all = schema.find("allOf");
    const Json& target = all == schema.end() ? schema : all->front();
    const auto reference = target.find("$ref");
    if (reference == target.end()) return schema;
    return root.at(typename Json::json_pointer(reference->template get<std::string>().substr(1)));
}

/// Checks the keys of a document and their values: types, ranges of numbers, sizes of lists, and
/// words of short lists. Further rules of the schema, such as required keys, are left to the
/// readers.
/// Requires: the functions outlive the call.
struct SchemaCheck {
    std::string_view schema;
    /// True for a key that is an option of commands, whose values the schema does not restrict.
    std::function<bool(const std::string&)> is_option;
    /// Throws the error of a node.
    std::function<void(const toml::node&, const std::string&)> fail;

    void check(const toml::table& document) const;
};

}  // namespace ncsim::setup
