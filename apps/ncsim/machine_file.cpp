// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine_file.h"

#include "job.h"
#include "mesh_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <set>
#include <stdexcept>
#include <string_view>

namespace ncsim::app {

namespace {

using verify::AxisRange;
using verify::MachineDescription;

class Reader {
public:
    explicit Reader(std::string path) : path_(std::move(path)) {}

    [[noreturn]] void fail(const toml::node& node, const std::string& what) const {
        const auto& at = node.source().begin;
        throw std::runtime_error(fmt::format("{}:{}:{}: {}", path_, at.line, at.column, what));
    }

    double number(const toml::node& node, const std::string& key) const {
        const auto value = node.value<double>();
        if (!value || !std::isfinite(*value) || !node.is_number()) {
            fail(node, fmt::format("'{}': expected a number", key));
        }
        return *value;
    }
    double positive(const toml::node& node, const std::string& key) const {
        const double value = number(node, key);
        if (value <= 0.0) fail(node, fmt::format("'{}': expected a number above 0", key));
        return value;
    }
    double not_negative(const toml::node& node, const std::string& key) const {
        const double value = number(node, key);
        if (value < 0.0) fail(node, fmt::format("'{}': expected 0 or more", key));
        return value;
    }
    const toml::table& table(const toml::node& node, const std::string& key) const {
        if (!node.is_table()) fail(node, fmt::format("'{}': expected a table", key));
        return *node.as_table();
    }
    const toml::array& array(const toml::node& node, const std::string& key,
                             std::size_t size) const {
        if (!node.is_array() || node.as_array()->size() != size) {
            fail(node, fmt::format("'{}': expected {} values in brackets", key, size));
        }
        return *node.as_array();
    }
    cda::Vec3 vector(const toml::node& node, const std::string& key) const {
        const toml::array& a = array(node, key, 3);
        return {number(a[0], key), number(a[1], key), number(a[2], key)};
    }
    std::string text(const toml::node& node, const std::string& key) const {
        if (!node.is_string()) fail(node, fmt::format("'{}': expected a text", key));
        return node.as_string()->get();
    }
    bool yes_or_no(const toml::node& node, const std::string& key) const {
        if (!node.is_boolean()) fail(node, fmt::format("'{}': expected true or false", key));
        return node.as_boolean()->get();
    }

    using Take = std::function<void(const toml::node&, const std::string&)>;
    using Keys = std::map<std::string, Take, std::less<>>;
    // Every key must be one of those known.
    void each(const toml::table& in, const std::string& where, const Keys& known) const {
        for (const auto& [key, node] : in) {
            const auto found = known.find(key.str());
            if (found == known.end()) {
                std::string names;
                for (const auto& [name, take] : known)
                    names += (names.empty() ? "" : ", ") + name;
                fail(node, fmt::format("'{}' is not known{}{}; expected {}", key.str(),
                                       where.empty() ? "" : " in ", where, names));
            }
            found->second(node, where.empty() ? found->first : where + "." + found->first);
        }
    }
    // x, y and z, each read by `take`.
    template <class Value, class Read>
    void axes(const toml::node& node, const std::string& key,
              std::array<std::optional<Value>, 3>& into, const Read& read) const {
        Keys keys;
        for (std::size_t i = 0; i < 3; ++i) {
            keys[std::string(1, "xyz"[i])] = [&into, &read, i](const toml::node& n,
                                                               const std::string& k) {
                into[i] = read(n, k);
            };
        }
        each(table(node, key), key, keys);
    }

private:
    std::string path_;
};

verify::Fixture read_fixture(const Reader& r, const std::filesystem::path& folder,
                             const toml::node& node, const std::string& key) {
    verify::Fixture fixture;
    r.each(r.table(node, key), key,
           {{"name", [&](const auto& n, const auto& k) { fixture.name = r.text(n, k); }},
            {"stl",
             [&](const auto& n, const auto& k) {
                 // As seen from the file that names it.
                 const std::filesystem::path named(r.text(n, k));
                 fixture.mesh = read_mesh_file((folder / named).string());
                 for (const cda::Vec3& v : fixture.mesh.vertices)
                     fixture.box.add(v);
             }},
            {"clearance",
             [&](const auto& n, const auto& k) { fixture.clearance_mm = r.not_negative(n, k); }},
            {"box", [&](const toml::node& n, const std::string& k) {
                 const toml::array& corners = r.array(n, k, 2);
                 fixture.box.add(r.vector(corners[0], k));
                 fixture.box.add(r.vector(corners[1], k));
                 const cda::Vec3 size = fixture.box.size();
                 if (size.x <= 0.0 || size.y <= 0.0 || size.z <= 0.0) {
                     r.fail(n, fmt::format("'{}': the box has no volume", k));
                 }
             }}});
    if (fixture.box.is_empty()) r.fail(node, "a fixture needs a box or an stl");
    if (!fixture.mesh.triangles.empty() && node.as_table()->contains("box")) {
        r.fail(node, "a fixture has a box or an stl, not both");
    }
    if (fixture.name.empty()) fixture.name = "fixture";
    return fixture;
}

void read_tool_limits(const Reader& r, const toml::node& node, const std::string& key,
                      std::map<int, verify::ToolFacts>& tools) {
    verify::ToolFacts facts;
    std::optional<int> number;
    const auto limit = [&r](std::optional<double>& into) {
        return [&r, &into](const toml::node& n, const std::string& k) { into = r.positive(n, k); };
    };
    r.each(r.table(node, key), key,
           {{"number",
             [&](const toml::node& n, const std::string& k) {
                 if (!n.is_integer()) r.fail(n, fmt::format("'{}': expected a tool number", k));
                 number = static_cast<int>(r.not_negative(n, k));
             }},
            {"max_feed", limit(facts.max_feed)},
            {"max_speed", limit(facts.max_rpm)},
            {"max_depth", limit(facts.max_depth)},
            {"max_engagement", limit(facts.max_engagement)},
            {"max_removal_rate", limit(facts.max_removal_rate)},
            {"blind_diameter",
             [&](const auto& n, const auto& k) { facts.blind_diameter = r.not_negative(n, k); }},
            {"left_handed",
             [&](const auto& n, const auto& k) { facts.left_hand = r.yes_or_no(n, k); }}});
    if (!number) r.fail(node, "a tool needs its number");
    if (!tools.emplace(*number, std::move(facts)).second) {
        r.fail(node, fmt::format("tool {} is described twice", *number));
    }
}

}  // namespace

MachineFile read_machine_file(const std::string& path) {
    MachineFile file;
    MachineDescription& m = file.machine;
    const Reader r(path);
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    const auto list = [&r](const toml::node& n, const std::string& k, const Reader::Take& take) {
        if (!n.is_array_of_tables()) r.fail(n, fmt::format("write [[{}]]", k));
        for (const toml::node& element : *n.as_array())
            take(element, k);
    };
    const auto positive = [&r](const auto& n, const auto& k) { return r.positive(n, k); };
    toml::table root;
    try {
        root = toml::parse(read_text_file(path), path);
    } catch (const toml::parse_error& e) {
        const auto& at = e.source().begin;
        throw std::runtime_error(
            fmt::format("{}:{}:{}: {}", path, at.line, at.column, e.description()));
    }
    const auto point = [&r](std::optional<cda::Vec3>& into) {
        return [&r, &into](const toml::node& n, const std::string& k) { into = r.vector(n, k); };
    };
    r.each(root, "",
           {{"name", [&](const auto& n, const auto& k) { m.name = r.text(n, k); }},
            {"travel",
             [&](const toml::node& n, const std::string& k) {
                 r.axes(n, k, m.travel, [&](const toml::node& node, const std::string& key) {
                     const toml::array& ends = r.array(node, key, 2);
                     const AxisRange range{r.number(ends[0], key), r.number(ends[1], key)};
                     if (range.min >= range.max) {
                         r.fail(node,
                                fmt::format("'{}': the first end must be below the second", key));
                     }
                     return range;
                 });
             }},
            {"rapid", [&](const auto& n, const auto& k) { r.axes(n, k, m.rapid, positive); }},
            {"acceleration",
             [&](const auto& n, const auto& k) { r.axes(n, k, m.acceleration, positive); }},
            {"spindle",
             [&](const toml::node& n, const std::string& k) {
                 r.each(r.table(n, k), k,
                        {{"min", [&](const auto& v,
                                     const auto& key) { m.min_rpm = r.not_negative(v, key); }},
                         {"max", [&](const auto& v, const auto& key) {
                              m.max_rpm = r.positive(v, key);
                          }}});
             }},
            {"feed",
             [&](const toml::node& n, const std::string& k) {
                 r.each(r.table(n, k), k, {{"max", [&](const auto& v, const auto& key) {
                                                m.max_feed = r.positive(v, key);
                                            }}});
             }},
            {"position",
             [&](const toml::node& n, const std::string& k) {
                 r.each(r.table(n, k), k,
                        {{"home", point(m.home)},
                         {"tool_change", point(m.tool_change)},
                         {"work_zero", point(m.work_zero)}});
             }},
            {"time",
             [&](const toml::node& n, const std::string& k) {
                 r.each(r.table(n, k), k,
                        {{"tool_change",
                          [&](const auto& v, const auto& key) {
                              m.tool_change_seconds = r.not_negative(v, key);
                          }},
                         {"junction_deviation", [&](const auto& v, const auto& key) {
                              m.junction_deviation = r.positive(v, key);
                          }}});
             }},
            {"fixture",
             [&](const toml::node& n, const std::string& k) {
                 list(n, k, [&](const toml::node& element, const std::string& key) {
                     m.fixtures.push_back(read_fixture(r, folder, element, key));
                 });
             }},
            {"tool", [&](const toml::node& n, const std::string& k) {
                 list(n, k, [&](const toml::node& element, const std::string& key) {
                     read_tool_limits(r, element, key, file.tools);
                 });
             }}});
    return file;
}

}  // namespace ncsim::app
