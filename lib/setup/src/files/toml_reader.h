// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reader of the project's TOML files (jobs, machines, holders). Every key must be known, every
// value must have its type, and errors are reported with file, line and column.
#pragma once

#include "ncsim/base/vec3.h"

#include <toml++/toml.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ncsim::setup {

/// A TOML document with typed access.
class TomlReader {
public:
    /// Parses `text`, and compares it with a schema. `name` is the name in all messages.
    /// `is_option`: as in SchemaCheck.
    /// Throws: std::runtime_error with line and column if `text` is not TOML, or has a key or a
    /// value that the schema does not permit.
    TomlReader(std::string name, const std::string& text, std::string_view schema,
               std::function<bool(const std::string&)> is_option = {});
    /// Parses `text` without a schema.
    TomlReader(std::string name, const std::string& text);

    const toml::table& root() const { return root_; }
    const std::string& name() const { return name_; }
    /// Returns the place of a node: "mill.toml:12:1".
    std::string place_of(const toml::node& node) const;
    /// Throws: std::runtime_error with the place of `node`.
    [[noreturn]] void fail(const toml::node& node, const std::string& what) const;

    // Requires: the node has the type that the schema permits.
    static double number(const toml::node& node);
    static std::string text(const toml::node& node);
    static const toml::table& table(const toml::node& node);
    static const toml::array& list(const toml::node& node);
    static Vec3 vector(const toml::node& node);
    static std::vector<std::string> texts(const toml::node& node);

    /// Takes the value of a key; `key` is the name of the node in messages, such as "travel.x".
    using Take = std::function<void(const toml::node&, const std::string& key)>;
    using Keys = std::map<std::string, Take, std::less<>>;
    /// Passes each key of `in` to its function, as "where.key".
    /// Requires: `known` has all keys of the schema that are no options.
    static void each(const toml::table& in, const std::string& where, const Keys& known);
    /// Passes each table of [[key]] to `take`.
    static void each_of(const toml::node& node, const std::string& key, const Take& take);

private:
    std::string name_;
    toml::table root_;
};

/// Type of the values of an optional; otherwise the type itself.
template <class Type>
struct ValueOf {
    using type = Type;
};
template <class Type>
struct ValueOf<std::optional<Type>> {
    using type = Type;
};

/// Returns a function that stores the value of a key in `value`: a number, a text, true or false,
/// a vector, a list of texts.
/// Requires: `value` outlives the function; the schema permits such values only.
template <class Value>
TomlReader::Take into(Value& value) {
    return [&value](const toml::node& node, const std::string&) {
        using Type = typename ValueOf<Value>::type;
        if constexpr (std::is_same_v<Type, Vec3>) {
            value = TomlReader::vector(node);
        } else if constexpr (std::is_same_v<Type, std::vector<std::string>>) {
            value = TomlReader::texts(node);
        } else {
            value = node.value<Type>().value();
        }
    };
}

/// Returns a function that calls take(node, key) for each table of [[key]].
TomlReader::Take tables(TomlReader::Take take);

/// Reads origins of coordinate systems in machine coordinates, mm: a table with the keys G54 …
/// G59.3 and "G54.1 P1" …, numbered as in gcode::MachineState::system.
std::map<int, Vec3> read_offsets(const TomlReader& reader, const toml::node& node);

}  // namespace ncsim::setup
