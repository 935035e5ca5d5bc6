// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares TOML documents with schemas.
#include "files/schema.h"

#include "ncsim/setup/nearest_word.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

namespace ncsim::setup {

namespace {

using Json = nlohmann::json;

// Returns a parsed schema; each schema is parsed once.
const Json& parsed_schema(std::string_view text) {
    thread_local std::map<const char*, Json> known;
    const auto [schema, is_new] = known.try_emplace(text.data());
    if (is_new) schema->second = Json::parse(text);
    return schema->second;
}

// Comparison of one document with its schema. `key` is the path of a node in messages.
class Comparison {
public:
    explicit Comparison(const SchemaCheck& check)
        : check_(check), root_(parsed_schema(check.schema)) {}

    void compare(const toml::table& document) const { table(document, root_, ""); }

private:
    const Json& resolved(const Json& schema) const { return resolved_schema(root_, schema); }

    static std::string_view type_of(const Json& schema) {
        const auto type = schema.find("type");
        if (type != schema.end()) return type->get_ref<const std::string&>();
        const auto words = schema.find("enum");
        return words != schema.end() && words->front().is_string() ? "string" : "";
    }

    static bool has_type(const toml::node& node, std::string_view type) {
        return type == "string"   ? node.is_string()
               : type == "array"  ? node.is_array()
               : type == "object" ? node.is_table()
                                  : true;
    }

    // Returns the alternative of `schema` for a node: of its type, and with all required keys.
    const Json& chosen(const Json& schema, const toml::node& node) const {
        const Json& whole = resolved(schema);
        if (whole.contains("type") || !whole.contains("anyOf")) return whole;
        const Json* of_type = nullptr;
        for (const Json& choice : whole["anyOf"]) {
            const Json& one = resolved(choice);
            if (!has_type(node, type_of(one))) continue;
            if (!of_type) of_type = &one;
            const auto has = [&](const Json& key) {
                return node.as_table()->contains(key.get_ref<const std::string&>());
            };
            if (node.is_table() && one.contains("required") &&
                std::ranges::all_of(one["required"], has))
                return one;
        }
        return of_type ? *of_type : resolved(whole["anyOf"].back());
    }

    void value(const toml::node& node, const Json& any, const std::string& key) const {
        const Json& schema = chosen(any, node);
        const std::string_view type = type_of(schema);
        if (type == "string") {
            text(node, schema, key);
        } else if (type == "boolean") {
            if (!node.is_boolean()) fail(node, key, "expected true or false");
        } else if (type == "number") {
            number(node, schema, key);
        } else if (type == "integer") {
            integer(node, schema, key);
        } else if (type == "array") {
            list(node, schema, key);
        } else if (type == "object") {
            if (!node.is_table()) fail(node, key, "expected a table");
            table(*node.as_table(), schema, key);
        }
    }

    void text(const toml::node& node, const Json& schema, const std::string& key) const {
        if (!node.is_string()) fail(node, key, "expected a text in quotes");
        // The reader explains a single word, and names the place of long lists.
        constexpr std::size_t kFewest = 2, kMost = 20;
        if (!schema.contains("enum")) return;
        const Json& words = schema["enum"];
        if (words.size() < kFewest || words.size() > kMost) return;
        if (std::ranges::find(words, Json(node.as_string()->get())) != words.end()) return;
        std::string known;
        for (std::size_t i = 0; i < words.size(); ++i)
            known += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i].dump();
        fail(node, key, fmt::format("expected {}, not \"{}\"", known, node.as_string()->get()));
    }

    void number(const toml::node& node, const Json& schema, const std::string& key) const {
        const auto value = node.value<double>();
        constexpr double kLargest = 1e6;  // a kilometre in mm
        const double most = schema.value("maximum", kLargest);
        if (!node.is_number() || !value || !(std::abs(*value) <= most))
            fail(node, key, fmt::format("expected a number, at most {}", most));
        if (schema.contains("exclusiveMinimum") && *value <= 0.0)
            fail(node, key, "expected a number above 0");
        if (schema.value("minimum", -1.0) == 0.0 && *value < 0.0)
            fail(node, key, "expected 0 or more");
    }

    void integer(const toml::node& node, const Json& schema, const std::string& key) const {
        const auto value = node.value_exact<std::int64_t>();
        const auto least = schema["minimum"].get<std::int64_t>();
        const auto most = schema["maximum"].get<std::int64_t>();
        if (!value || *value < least || *value > most)
            fail(node, key, fmt::format("expected a whole number, {} to {}", least, most));
    }

    void list(const toml::node& node, const Json& schema, const std::string& key) const {
        const toml::array* const all = node.as_array();
        const Json& items = resolved(schema["items"]);
        const std::size_t least = schema.value("minItems", std::size_t{0});
        const bool has_size = least > 0 && schema.value("maxItems", std::size_t{0}) == least;
        const bool are_tables = type_of(items) == "object";
        const bool is_expected = all && (are_tables ? all->empty() || all->is_array_of_tables()
                                                    : !has_size || all->size() == least);
        if (!is_expected && are_tables) return check_.fail(node, fmt::format("write [[{}]]", key));
        if (!is_expected)
            return fail(node, key,
                        has_size ? fmt::format("expected {} values in brackets", least)
                                 : expected_list(items));
        for (const toml::node& element : *all)
            value(element, items, key);
    }

    static const char* expected_list(const Json& items) {
        if (type_of(items) != "array") return "expected a list in brackets";
        constexpr int kPair = 2;
        return items.value("maxItems", 0) == kPair ? "expected a list of pairs, [[\"a\", \"b\"]]"
                                                   : "expected a list of lists, [[…], […]]";
    }

    static bool is_of_rotary_axes(const Json& known) {
        return std::ranges::all_of(known.items(), [](const auto& property) {
            return property.key() == "A" || property.key() == "B" || property.key() == "C";
        });
    }

    void table(const toml::table& t, const Json& schema, const std::string& where) const {
        static const Json none = Json::object();
        const auto properties = schema.find("properties");
        const Json& known = properties == schema.end() ? none : *properties;
        const auto patterns = schema.find("patternProperties");
        for (const auto& [key, node] : t) {
            const std::string name(key.str());
            if (check_.is_option && check_.is_option(name)) continue;
            const std::string path = where.empty() ? name : fmt::format("{}.{}", where, name);
            if (const auto found = known.find(name); found != known.end()) {
                value(node, *found, path);
            } else if (patterns != schema.end()) {
                // The reader explains a wrong name.
                const auto rule = patterns->begin();
                if (std::regex_search(name, std::regex(rule.key()))) value(node, *rule, path);
            } else if (is_of_rotary_axes(known)) {
                fail(node, path, "expected A, B or C");
            } else {
                fail_unknown(node, name, where, known);
            }
        }
    }

    void fail(const toml::node& node, const std::string& key, const std::string& what) const {
        check_.fail(node, fmt::format("'{}': {}", key, what));
    }

    void fail_unknown(const toml::node& node, const std::string& key, const std::string& where,
                      const Json& known) const {
        std::vector<std::string> names;
        for (const auto& property : known.items())
            names.push_back(property.key());
        const std::string meant = nearest_word(key, names);
        check_.fail(node,
                    fmt::format("'{}' is not known{}{}; expected {}{}", key,
                                where.empty() ? "" : " in ", where, fmt::join(names, ", "),
                                meant.empty() ? "" : fmt::format(" (did you mean {}?)", meant)));
    }

    const SchemaCheck& check_;
    const Json& root_;
};

}  // namespace

void SchemaCheck::check(const toml::table& document) const {
    Comparison(*this).compare(document);
}

}  // namespace ncsim::setup
