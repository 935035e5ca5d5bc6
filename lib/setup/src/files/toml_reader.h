// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the TOML files of the program (jobs, machines, holders): every key must be known, every
// value of its type, and what is wrong is told with file, line and column.
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

class TomlReader {
public:
    /// Throws std::runtime_error if `text` is no TOML. `name` stands in all messages.
    TomlReader(std::string name, const std::string& text);

    const toml::table& root() const { return root_; }
    const std::string& name() const { return name_; }

    // Each of these throws std::runtime_error where the node is something else. `key` names it in
    // messages, as "travel.x".
    /// "mill.toml:12:1".
    std::string place_of(const toml::node& node) const;
    [[noreturn]] void fail(const toml::node& node, const std::string& what) const;
    /// Finite, and no larger than a kilometre in mm.
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
    /// Hands each key of `in` to its taker, as "where.key"; one that is not known is refused.
    void each(const toml::table& in, const std::string& where, const Keys& known) const;
    /// The tables of [[key]].
    void each_of(const toml::node& node, const std::string& key, const Take& take) const;

private:
    std::string name_;
    toml::table root_;
};

/// Origins of coordinate systems in the machine, mm: a table with the keys G54 … G59.3 and
/// "G54.1 P1" …, numbered as in gcode::MachineState::system.
std::map<int, cda::Vec3> read_offsets(const TomlReader& reader, const toml::node& node,
                                      const std::string& key);

}  // namespace ncsim::setup
