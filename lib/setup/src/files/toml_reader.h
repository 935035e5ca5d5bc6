// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reader of the project's TOML files (jobs, machines, holders). Every key must be known, every
// value must have its type, and errors are reported with file, line and column.
#pragma once

#include "ncsim/cda/vec.h"

#include <toml++/toml.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::setup {

/// A TOML document with typed access.
class TomlReader {
public:
    /// Parses `text`. `name` is the name in all messages. Throws: std::runtime_error if `text` is
    /// not TOML.
    TomlReader(std::string name, const std::string& text);

    const toml::table& root() const { return root_; }
    const std::string& name() const { return name_; }

    // The following functions throw std::runtime_error if the node has another type. `key` is the
    // name of the node in messages, such as "travel.x".
    /// Returns the place of a node: "mill.toml:12:1".
    std::string place_of(const toml::node& node) const;
    [[noreturn]] void fail(const toml::node& node, const std::string& what) const;
    /// Returns a finite number of at most 1e6, a kilometre in mm.
    double number(const toml::node& node, const std::string& key) const;
    double positive(const toml::node& node, const std::string& key) const;
    double not_negative(const toml::node& node, const std::string& key) const;
    std::int64_t integer(const toml::node& node, const std::string& key, std::int64_t least,
                         std::int64_t most) const;
    std::string text(const toml::node& node, const std::string& key) const;
    bool yes_or_no(const toml::node& node, const std::string& key) const;
    const toml::table& table(const toml::node& node, const std::string& key) const;
    const toml::array& list(const toml::node& node, const std::string& key) const;
    const toml::array& list(const toml::node& node, const std::string& key, std::size_t size) const;
    cda::Vec3 vector(const toml::node& node, const std::string& key) const;
    std::vector<std::string> texts(const toml::node& node, const std::string& key) const;

    using Take = std::function<void(const toml::node&, const std::string& key)>;
    using Keys = std::map<std::string, Take, std::less<>>;
    /// Passes each key of `in` to its function, as "where.key". Unknown keys are refused.
    void each(const toml::table& in, const std::string& where, const Keys& known) const;
    /// Passes each table of [[key]] to `take`.
    void each_of(const toml::node& node, const std::string& key, const Take& take) const;

private:
    std::string name_;
    toml::table root_;
};

/// Reads origins of coordinate systems in machine coordinates, mm: a table with the keys G54 …
/// G59.3 and "G54.1 P1" …, numbered as in gcode::MachineState::system.
std::map<int, cda::Vec3> read_offsets(const TomlReader& reader, const toml::node& node,
                                      const std::string& key);

}  // namespace ncsim::setup
