// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes TOML documents by a schema.
#include "files/toml_writer.h"

#include "files/schema.h"
#include "files/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace ncsim::setup {

namespace {

// Has the keys in the order of the file.
using SchemaJson = nlohmann::ordered_json;

std::string comment_line(const std::string& text) {
    return text.empty() ? "#\n" : fmt::format("#{}{}\n", text.front() == ':' ? "" : " ", text);
}

std::string key_text(const std::string& key) {
    const bool is_bare = !key.empty() && std::ranges::all_of(key, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    });
    return is_bare ? key : quoted(key);
}

// A key of an inline table.
struct Member {
    std::string key;
    const TomlValue& value;
};

// Returns the text with a # before each line.
std::string switched_off(const std::string& text) {
    std::string result;
    bool is_start = true;
    for (const char c : text) {
        if (is_start && c != '\n') result += '#';
        is_start = c == '\n';
        result += c;
    }
    return result;
}

class Writer {
public:
    Writer(std::string_view schema, TomlStyle style)
        : root_(SchemaJson::parse(schema)), style_(style) {}

    std::string document(const TomlSection& root) const {
        std::string text = body(root, root_, "");
        return text.substr(text.starts_with('\n') ? 1 : 0);
    }

private:
    // Calls take(item, schema of the value) for all items in the order of the schema.
    template <class Items, class Take>
    static void in_order(const Items& items, const SchemaJson& schema, const std::string& where,
                         const Take& take) {
        using Item = typename Items::value_type;
        std::vector<std::tuple<std::size_t, const Item*, const SchemaJson*>> order;
        order.reserve(items.size());
        for (const Item& item : items) {
            const auto [rank, own] = property(schema, item.key, where);
            order.emplace_back(rank, &item, own);
        }
        std::ranges::stable_sort(order, {}, [](const auto& o) { return std::get<0>(o); });
        for (const auto& [rank, item, own] : order)
            take(*item, *own);
    }

    // Returns the place of a key in the schema of `table`, and the schema of the value.
    static std::pair<std::size_t, const SchemaJson*> property(const SchemaJson& table,
                                                              const std::string& key,
                                                              const std::string& where) {
        std::size_t rank = 0;
        if (const auto known = table.find("properties"); known != table.end()) {
            for (const auto& property : known->items()) {
                if (property.key() == key) return {rank, &property.value()};
                ++rank;
            }
        }
        if (const auto patterns = table.find("patternProperties"); patterns != table.end()) {
            const auto rule = patterns->begin();
            if (std::regex_search(key, std::regex(rule.key()))) return {rank, &*rule};
        }
        throw std::logic_error(fmt::format("'{}' is no key of the schema of '{}'", key, where));
    }

    // Returns the schema of a table: the first alternative that has all keys of the table.
    template <class Items>
    const SchemaJson& table_schema(const SchemaJson& any, const Items& items) const {
        const SchemaJson& whole = resolved_schema(root_, any);
        if (whole.contains("type") || !whole.contains("anyOf")) return whole;
        for (const SchemaJson& choice : whole["anyOf"]) {
            const SchemaJson& one = resolved_schema(root_, choice);
            const auto has = [&](const auto& item) {
                return one.contains("properties") && one["properties"].contains(item.key);
            };
            if (std::ranges::all_of(items, has)) return one;
        }
        return whole["anyOf"].back();
    }

    std::string number(double value) const {
        std::string text = fmt::format("{}", value + 0.0);
        if (style_.decimal_point && text.find_first_of(".e") == std::string::npos) text += ".0";
        return text;
    }

    std::string value(const TomlValue& v, const SchemaJson& any, const std::string& where) const {
        if (v.is_string()) return quoted(v.get<std::string>());
        if (v.is_number_float()) return number(v.get<double>());
        if (v.is_object()) return inline_table(v, any, where);
        if (!v.is_array()) return v.dump();
        const SchemaJson& schema = resolved_schema(root_, any);
        static const SchemaJson none = SchemaJson::object();
        const SchemaJson& items = schema.contains("items") ? schema["items"] : none;
        std::string text;
        for (const TomlValue& element : v)
            text += (text.empty() ? "" : ", ") + value(element, items, where);
        return fmt::format("[{}]", text);
    }

    std::string inline_table(const TomlValue& table, const SchemaJson& any,
                             const std::string& where) const {
        std::vector<Member> members;
        members.reserve(table.size());
        for (const auto& member : table.items())
            members.push_back({member.key(), member.value()});
        std::string text;
        in_order(members, table_schema(any, members), where,
                 [&](const Member& member, const SchemaJson& own) {
                     text +=
                         fmt::format("{}{} = {}", text.empty() ? "" : ", ", key_text(member.key),
                                     value(member.value, own, member.key));
                 });
        return text.empty() ? "{}" : fmt::format("{{ {} }}", text);
    }

    // Returns the comment behind a value or the head of a table.
    std::string comment(const TomlItem& item, const SchemaJson& schema) const {
        std::string text = item.comment;
        if (item.describes) {
            const SchemaJson& whole = resolved_schema(root_, schema);
            text = schema.value("description", whole.value("description", ""));
            constexpr std::size_t kObvious = 2;
            if (whole.contains("enum") && whole["enum"].size() > kObvious) {
                std::string words;
                for (const SchemaJson& word : whole["enum"])
                    words += (words.empty() ? "" : ", ") + word.get<std::string>();
                text += fmt::format(" ({})", words);
            }
        }
        return text.empty() ? "" : "  # " + text;
    }

    // Returns the lines of a table without the head. `path`: path of the table, as in heads.
    std::string body(const TomlSection& section, const SchemaJson& schema,
                     const std::string& path) const {
        std::string text;
        for (const std::string& line : section.comments)
            text += comment_line(line);
        in_order(section.entries, schema, path, [&](const TomlEntry& entry, const SchemaJson& own) {
            for (const std::string& line : entry.above)
                text += comment_line(line);
            const std::string line =
                fmt::format("{} = {}{}\n", key_text(entry.key), value(entry.value, own, entry.key),
                            comment(entry, own));
            text += entry.is_off ? switched_off(line) : line;
        });
        in_order(section.tables, schema, path, [&](const TomlSection& one, const SchemaJson& own) {
            text += table(one, own, path);
        });
        return text;
    }

    // Returns the lines of a table. `above`: path of the enclosing table.
    std::string table(const TomlSection& section, const SchemaJson& any,
                      const std::string& above) const {
        const bool is_inner = !above.empty();
        const std::string path = (is_inner ? above + "." : "") + key_text(section.key);
        const SchemaJson& own = section.is_in_list ? resolved_schema(root_, any)["items"] : any;
        const std::string head =
            section.is_in_list ? fmt::format("[[{}]]", path) : fmt::format("[{}]", path);
        std::string text = style_.blank_lines && !is_inner ? "\n" : "";
        for (const std::string& line : section.above)
            text += comment_line(line);
        const std::string lines = head + comment(section, any) + "\n" +
                                  body(section, table_schema(own, section.entries), path);
        return text + (section.is_off ? switched_off(lines) : lines);
    }

    const SchemaJson root_;
    TomlStyle style_;
};

}  // namespace

TomlValue toml_value(Vec3 v) {
    return {v.x, v.y, v.z};
}

TomlEntry& TomlSection::set(std::string name, TomlValue value) {
    entries.push_back({{std::move(name)}, std::move(value)});
    return entries.back();
}

void TomlSection::set_filled(std::string name, TomlValue value) {
    const bool is_empty_text = value.is_string() && value.get_ref<const std::string&>().empty();
    if (!value.empty() && !is_empty_text) set(std::move(name), std::move(value));
}

TomlSection& TomlSection::table(std::string name) {
    tables.push_back({{std::move(name)}});
    return tables.back();
}

TomlSection& TomlSection::add(std::string name) {
    TomlSection& section = table(std::move(name));
    section.is_in_list = true;
    return section;
}

std::string toml_text(std::string_view schema, const TomlSection& document, TomlStyle style) {
    return Writer(schema, style).document(document);
}

}  // namespace ncsim::setup
