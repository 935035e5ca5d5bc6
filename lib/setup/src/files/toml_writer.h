// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writer of the project's TOML files (jobs, machines, projects). The schemas of docs/schemas, with
// which the readers check files, determine the keys, their order, and the comments on values.
#pragma once

#include "ncsim/base/vec3.h"

#include <list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

/// A value; an object is an inline table.
using TomlValue = nlohmann::ordered_json;

TomlValue toml_value(Vec3 v);

/// Form of a document.
struct TomlStyle {
    bool blank_lines = true;    ///< Before tables that are not in a list of another table.
    bool decimal_point = true;  ///< 60.0 for 60; a whole number of the schema stays 60.
};

/// Common part of keys and tables. Comments are texts without the sign #.
struct TomlItem {
    std::string key;
    std::vector<std::string> above{};  ///< Comment lines before the key or the head of the table.
    std::string comment{};             ///< Comment behind the value or the head of the table.
    bool describes = false;            ///< The comment is the sentence of the schema.
    bool is_off = false;               ///< Written as a comment, for the user to complete.
};

/// A key with its value.
struct TomlEntry : TomlItem {
    TomlValue value;
};

/// A table of a document.
struct TomlSection : TomlItem {
    std::vector<std::string> comments{};  ///< Comment lines after the head.
    std::list<TomlEntry> entries{};
    std::list<TomlSection> tables{};
    bool is_in_list = false;  ///< Head is [[key]].

    TomlEntry& set(std::string name, TomlValue value);
    /// Sets `name` if the value is neither null nor an empty list, table or text.
    void set_filled(std::string name, TomlValue value);
    TomlSection& table(std::string name);
    TomlSection& add(std::string name);
};

/// Returns the text of a document. `document` has no key. Keys are in the order of the schema; keys
/// for which the schema has a pattern only come last, in the order of the section.
/// Throws: std::logic_error for a key that the schema does not have.
std::string toml_text(std::string_view schema, const TomlSection& document, TomlStyle style);

}  // namespace ncsim::setup
