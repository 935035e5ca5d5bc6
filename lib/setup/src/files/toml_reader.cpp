// SPDX-License-Identifier: GPL-3.0-or-later
//
// Typed access to TOML with error messages.
#include "files/toml_reader.h"

#include "ncsim/setup/coordinate_systems.h"

#include "files/schema.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace ncsim::setup {

namespace {

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

TomlReader::TomlReader(std::string name, const std::string& text, std::string_view schema,
                       std::function<bool(const std::string&)> is_option)
    : TomlReader(std::move(name), text) {
    const auto refuse = [this](const toml::node& node, const std::string& what) {
        fail(node, what);
    };
    SchemaCheck{schema, std::move(is_option), refuse}.check(root_);
}

std::string TomlReader::place_of(const toml::node& node) const {
    return place(name_, node.source());
}

void TomlReader::fail(const toml::node& node, const std::string& what) const {
    throw std::runtime_error(fmt::format("{}: {}", place_of(node), what));
}

double TomlReader::number(const toml::node& node) {
    return node.value<double>().value();
}

std::string TomlReader::text(const toml::node& node) {
    return node.as_string()->get();
}

const toml::table& TomlReader::table(const toml::node& node) {
    return *node.as_table();
}

const toml::array& TomlReader::list(const toml::node& node) {
    return *node.as_array();
}

Vec3 TomlReader::vector(const toml::node& node) {
    const toml::array& a = list(node);
    return {number(a[0]), number(a[1]), number(a[2])};
}

std::vector<std::string> TomlReader::texts(const toml::node& node) {
    std::vector<std::string> all;
    for (const toml::node& element : list(node))
        all.push_back(text(element));
    return all;
}

void TomlReader::each(const toml::table& in, const std::string& where, const Keys& known) {
    for (const auto& [key, node] : in) {
        const std::string name(key.str());
        known.at(name)(node, where.empty() ? name : fmt::format("{}.{}", where, name));
    }
}

void TomlReader::each_of(const toml::node& node, const std::string& key, const Take& take) {
    for (const toml::node& element : list(node))
        take(element, key);
}

TomlReader::Take tables(TomlReader::Take take) {
    return [take = std::move(take)](const toml::node& node, const std::string& key) {
        TomlReader::each_of(node, key, take);
    };
}

std::map<int, Vec3> read_offsets(const TomlReader& reader, const toml::node& node) {
    std::map<int, Vec3> offsets;
    for (const auto& [name, value] : TomlReader::table(node)) {
        const auto system = system_named(std::string(name.str()));
        if (!system) {
            reader.fail(value, fmt::format("'{}' is no coordinate system: expected G54 to G59, "
                                           "G59.1 to G59.3 or \"G54.1 P1\" to \"G54.1 P300\"",
                                           name.str()));
        }
        offsets[*system] = TomlReader::vector(value);
    }
    return offsets;
}

}  // namespace ncsim::setup
