// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of TOML documents with a schema.
#include "files/schema.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace ncsim::setup {
namespace {

constexpr std::string_view kSchema = R"({
  "properties": {
    "name": {"type": "string"},
    "kind": {"enum": ["flat", "ball", "v"]},
    "fixed": {"enum": ["table"]},
    "on": {"type": "boolean"},
    "length": {"type": "number", "exclusiveMinimum": 0, "maximum": 1000},
    "depth": {"type": "number", "minimum": 0},
    "count": {"type": "integer", "minimum": 0, "maximum": 9},
    "at": {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2},
    "pairs": {"type": "array",
              "items": {"type": "array", "items": {"type": "string"}, "minItems": 2, "maxItems": 2}},
    "rows": {"type": "array", "items": {"$ref": "#/definitions/row"}},
    "turn": {"type": "object", "properties": {"A": {"type": "number"}}},
    "codes": {"type": "object", "patternProperties": {"^M[0-9]+$": {"type": "string"}}},
    "stock": {"anyOf": [{"type": "string"},
                        {"type": "object", "required": ["min"], "properties": {"min": {"type": "number"}}},
                        {"type": "object", "required": ["file"], "properties": {"file": {"type": "string"}}}]}
  },
  "definitions": {"row": {"type": "object", "properties": {"size": {"type": "number"}}}}
})";

// Returns the line, column and message of the first error; empty if there is none.
std::string error_in(const std::string& text) {
    const toml::table document = toml::parse(text);
    const auto fail = [](const toml::node& node, const std::string& what) {
        const auto at = node.source().begin;
        throw std::runtime_error(std::to_string(at.line) + ":" + std::to_string(at.column) + ": " +
                                 what);
    };
    try {
        SchemaCheck{kSchema, [](const std::string& key) { return key == "option"; }, fail}.check(
            document);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return {};
}

TEST(Schema, PermitsValuesOfItsTypes) {
    EXPECT_EQ(
        error_in("name = \"a\"\nkind = \"v\"\nfixed = \"other\"\non = true\nlength = 1000\n"
                 "depth = 0\ncount = 9\nat = [1, -2.5]\npairs = [[\"a\", \"b\"]]\n"
                 "turn = { A = 1 }\n"
                 "codes = { M1 = \"a\", N1 = 3 }\nstock = { file = \"a.stl\" }\noption = [{}]\n"
                 "[[rows]]\nsize = 1\n"),
        "");
    EXPECT_EQ(error_in("rows = []\nstock = \"1x2x3\"\n"), "");
}

TEST(Schema, RefusesOtherValuesWithTheirPlace) {
    EXPECT_EQ(error_in("\nname = 1"), "2:8: 'name': expected a text in quotes");
    EXPECT_EQ(error_in("kind = \"drill\""),
              "1:8: 'kind': expected \"flat\", \"ball\" or \"v\", not \"drill\"");
    EXPECT_EQ(error_in("on = 1"), "1:6: 'on': expected true or false");
    for (const char* number : {"1001", "inf", "nan", "true", "\"1\""})
        EXPECT_EQ(error_in(std::string("length = ") + number),
                  "1:10: 'length': expected a number, at most 1000")
            << number;
    EXPECT_EQ(error_in("length = 0"), "1:10: 'length': expected a number above 0");
    EXPECT_EQ(error_in("depth = -0.1"), "1:9: 'depth': expected 0 or more");
    EXPECT_EQ(error_in("depth = 2e6"), "1:9: 'depth': expected a number, at most 1000000");
    for (const char* number : {"-1", "10", "1.0"})
        EXPECT_EQ(error_in(std::string("count = ") + number),
                  "1:9: 'count': expected a whole number, 0 to 9")
            << number;
}

TEST(Schema, RefusesOtherListsAndTablesWithTheirPlace) {
    for (const char* list : {"[1]", "[1, 2, 3]", "1"})
        EXPECT_EQ(error_in(std::string("at = ") + list), "1:6: 'at': expected 2 values in brackets")
            << list;
    EXPECT_EQ(error_in("at = [1, \"b\"]"), "1:10: 'at': expected a number, at most 1000000");
    EXPECT_EQ(error_in("pairs = 1"), "1:9: 'pairs': expected a list of pairs, [[\"a\", \"b\"]]");
    EXPECT_EQ(error_in("rows = 1"), "1:8: write [[rows]]");
    EXPECT_EQ(error_in("[[rows]]\nsize = \"a\""),
              "2:8: 'rows.size': expected a number, at most 1000000");
    EXPECT_EQ(error_in("[[rows]]\nsise = 1"),
              "2:8: 'sise' is not known in rows; expected size (did you mean size?)");
    EXPECT_EQ(error_in("turn = { A = \"a\" }"),
              "1:14: 'turn.A': expected a number, at most 1000000");
    EXPECT_EQ(error_in("turn = { A = 1, Q = 2 }"), "1:21: 'turn.Q': expected A, B or C");
    EXPECT_EQ(error_in("codes = { M1 = 1 }"), "1:16: 'codes.M1': expected a text in quotes");
    EXPECT_EQ(error_in("stock = 1"), "1:9: 'stock': expected a table");
    EXPECT_EQ(error_in("stock = { min = \"a\" }"),
              "1:17: 'stock.min': expected a number, at most 1000000");
    EXPECT_EQ(error_in("stock = { file = \"a\", max = 2 }"),
              "1:29: 'max' is not known in stock; expected file");
}

}  // namespace
}  // namespace ncsim::setup
