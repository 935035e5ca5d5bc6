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

std::string TomlTable::name_of(std::string_view key) const {
    return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

TomlTable TomlTable::table(std::string_view key) const {
    static const toml::table none;
    const toml::node* const node = table_.get(key);
    return {node ? TomlReader::table(*node) : none, name_of(key)};
}

void TomlTable::each(std::string_view key,
                     const std::function<void(const TomlTable&)>& take) const {
    const toml::node* const node = table_.get(key);
    if (!node) return;
    for (const toml::node& element : TomlReader::list(*node))
        take({element, name_of(key)});
}

void TomlTable::each_key(
    std::string_view key,
    const std::function<void(const toml::node&, const std::string& name)>& take) const {
    for (const auto& [name, node] : table(key).node())
        take(node, std::string(name.str()));
}

std::map<int, Vec3> read_offsets(const TomlReader& reader, const TomlTable& table) {
    std::map<int, Vec3> offsets;
    table.each_key("offsets", [&](const toml::node& node, const std::string& name) {
        const auto system = system_named(name);
        if (!system) {
            reader.fail(node, fmt::format("'{}' is no coordinate system: expected G54 to G59, "
                                          "G59.1 to G59.3 or \"G54.1 P1\" to \"G54.1 P300\"",
                                          name));
        }
        offsets[*system] = TomlReader::vector(node);
    });
    return offsets;
}

}  // namespace ncsim::setup
