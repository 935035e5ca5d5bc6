// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reader of the project's TOML files (jobs, machines, holders). Every key must be known, every
// value must have its type, and errors are reported with file, line and column.
#pragma once

#include "ncsim/base/vec3.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ncsim::setup {

/// Type of the values of an optional; otherwise the type itself.
template <class Type>
struct ValueOf {
    using type = Type;
};
template <class Type>
struct ValueOf<std::optional<Type>> {
    using type = Type;
};

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
    static double number(const toml::node& node) { return value<double>(node); }
    static std::string text(const toml::node& node) { return value<std::string>(node); }
    static const toml::table& table(const toml::node& node) { return *node.as_table(); }
    static const toml::array& list(const toml::node& node) { return *node.as_array(); }
    static Vec3 vector(const toml::node& node) { return value<Vec3>(node); }
    /// Returns a number, a text, true or false, a vector, or a list of these.
    template <class Value>
    static Value value(const toml::node& node);

private:
    std::string name_;
    toml::table root_;
};

template <class Value>
Value TomlReader::value(const toml::node& node) {
    if constexpr (std::is_same_v<Value, Vec3>) {
        const auto [x, y, z] = value<std::array<double, 3>>(node);
        return {x, y, z};
    } else if constexpr (requires(Value list) { list.begin(); } &&
                         !std::is_same_v<Value, std::string>) {
        using Element = typename Value::value_type;
        Value all{};
        if constexpr (requires { all.resize(0); }) all.resize(list(node).size());
        std::ranges::transform(list(node), all.begin(), value<Element>);
        return all;
    } else {
        return node.value<Value>().value();
    }
}

/// A table of a document.
class TomlTable {
public:
    /// `name` is the name of the table in messages, such as "travel".
    /// Requires: `table` outlives this object.
    TomlTable(const toml::table& table, std::string name) : table_(table), name_(std::move(name)) {}
    TomlTable(const toml::node& node, std::string name)
        : TomlTable(TomlReader::table(node), std::move(name)) {}

    const toml::table& node() const { return table_; }
    const std::string& name() const { return name_; }
    /// Returns the value of a key; null if the table does not have the key.
    const toml::node* operator[](std::string_view key) const { return table_.get(key); }
    /// Returns the name of a key in messages, such as "travel.x".
    std::string name_of(std::string_view key) const;
    /// Returns the table of a key; an empty table if this table does not have the key.
    TomlTable table(std::string_view key) const;
    /// Stores the value of a key in `value`, if the table has the key.
    template <class Value>
    void read(std::string_view key, Value& value) const {
        if (const toml::node* const node = table_.get(key))
            value = TomlReader::value<typename ValueOf<Value>::type>(*node);
    }
    /// Calls take(table) for each table of [[key]]. Calls take(node, name) for each key of the
    /// table of a key, as "key.name".
    void each(std::string_view key, const std::function<void(const TomlTable&)>& take) const;
    void each_key(
        std::string_view key,
        const std::function<void(const toml::node&, const std::string& name)>& take) const;

private:
    const toml::table& table_;
    std::string name_;
};

/// Reads origins of coordinate systems in machine coordinates, mm: a table with the keys G54 …
/// G59.3 and "G54.1 P1" …, numbered as in gcode::MachineState::system. Empty if the table `table`
/// has no key `offsets`.
std::map<int, Vec3> read_offsets(const TomlReader& reader, const TomlTable& table);

}  // namespace ncsim::setup
