// SPDX-License-Identifier: GPL-3.0-or-later
//
// Typed access to TOML with error messages.
#include "files/toml_reader.h"

#include "ncsim/setup/coordinate_systems.h"
#include "ncsim/setup/nearest_word.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace ncsim::setup {

namespace {

constexpr double kLargestKey = 1e6;

std::string place(const std::string& name, const toml::source_region& where) {
    return fmt::format("{}:{}:{}", name, where.begin.line, where.begin.column);
}

}  // namespace

TomlReader::TomlReader(std::string name, const std::string& text) : name_(std::move(name)) {
    try {
        root_ = toml::parse(std::string_view(text), std::string_view(name_));
    } catch (const toml::parse_error& e) {
        throw std::runtime_error(fmt::format("{}: {}", place(name_, e.source()), e.description()));
    }
}

std::string TomlReader::place_of(const toml::node& node) const {
    return place(name_, node.source());
}

void TomlReader::fail(const toml::node& node, const std::string& what) const {
    throw std::runtime_error(fmt::format("{}: {}", place_of(node), what));
}

double TomlReader::number(const toml::node& node, const std::string& key) const {
    const auto value = node.value<double>();
    if (!value || !node.is_number() || !(std::abs(*value) <= kLargestKey)) {
        fail(node, fmt::format("'{}': expected a number, at most 1000000", key));
    }
    return *value;
}

double TomlReader::positive(const toml::node& node, const std::string& key) const {
    const double value = number(node, key);
    if (value <= 0.0) fail(node, fmt::format("'{}': expected a number above 0", key));
    return value;
}

double TomlReader::not_negative(const toml::node& node, const std::string& key) const {
    const double value = number(node, key);
    if (value < 0.0) fail(node, fmt::format("'{}': expected 0 or more", key));
    return value;
}

std::int64_t TomlReader::integer(const toml::node& node, const std::string& key, std::int64_t least,
                                 std::int64_t most) const {
    const auto value = node.value_exact<std::int64_t>();
    if (!value || *value < least || *value > most) {
        fail(node, fmt::format("'{}': expected a whole number, {} to {}", key, least, most));
    }
    return *value;
}

std::string TomlReader::text(const toml::node& node, const std::string& key) const {
    if (!node.is_string()) fail(node, fmt::format("'{}': expected a text in quotes", key));
    return node.as_string()->get();
}

bool TomlReader::yes_or_no(const toml::node& node, const std::string& key) const {
    if (!node.is_boolean()) fail(node, fmt::format("'{}': expected true or false", key));
    return node.as_boolean()->get();
}

const toml::table& TomlReader::table(const toml::node& node, const std::string& key) const {
    if (!node.is_table()) fail(node, fmt::format("'{}': expected a table", key));
    return *node.as_table();
}

const toml::array& TomlReader::list(const toml::node& node, const std::string& key) const {
    if (!node.is_array()) fail(node, fmt::format("'{}': expected a list in brackets", key));
    return *node.as_array();
}

const toml::array& TomlReader::list(const toml::node& node, const std::string& key,
                                    std::size_t size) const {
    if (!node.is_array() || node.as_array()->size() != size) {
        fail(node, fmt::format("'{}': expected {} values in brackets", key, size));
    }
    return *node.as_array();
}

cda::Vec3 TomlReader::vector(const toml::node& node, const std::string& key) const {
    const toml::array& a = list(node, key, 3);
    return {number(a[0], key), number(a[1], key), number(a[2], key)};
}

std::vector<std::string> TomlReader::texts(const toml::node& node, const std::string& key) const {
    std::vector<std::string> all;
    for (const toml::node& element : list(node, key))
        all.push_back(text(element, key));
    return all;
}

void TomlReader::each(const toml::table& in, const std::string& where, const Keys& known) const {
    for (const auto& [key, node] : in) {
        const auto found = known.find(key.str());
        if (found == known.end()) {
            std::vector<std::string> names;
            for (const auto& [name, take] : known)
                names.push_back(name);
            const std::string meant = nearest_word(key.str(), names);
            fail(node, fmt::format("'{}' is not known{}{}; expected {}{}", key.str(),
                                   where.empty() ? "" : " in ", where, fmt::join(names, ", "),
                                   meant.empty() ? "" : fmt::format(" (did you mean {}?)", meant)));
        }
        found->second(node, where.empty() ? found->first : where + "." + found->first);
    }
}

void TomlReader::each_of(const toml::node& node, const std::string& key, const Take& take) const {
    const bool is_empty = node.is_array() && node.as_array()->empty();
    if (!is_empty && !node.is_array_of_tables()) fail(node, fmt::format("write [[{}]]", key));
    for (const toml::node& element : *node.as_array())
        take(element, key);
}

std::map<int, cda::Vec3> read_offsets(const TomlReader& reader, const toml::node& node,
                                      const std::string& key) {
    std::map<int, cda::Vec3> offsets;
    for (const auto& [name, value] : reader.table(node, key)) {
        const auto system = system_named(std::string(name.str()));
        if (!system) {
            reader.fail(value, fmt::format("'{}' is no coordinate system: expected G54 to G59, "
                                           "G59.1 to G59.3 or \"G54.1 P1\" to \"G54.1 P300\"",
                                           name.str()));
        }
        offsets[*system] = reader.vector(value, fmt::format("{}.{}", key, name.str()));
    }
    return offsets;
}

}  // namespace ncsim::setup
