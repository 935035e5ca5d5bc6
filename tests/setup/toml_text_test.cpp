// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/toml_text.h"

#include <gtest/gtest.h>

#include <string_view>

namespace ncsim::setup {
namespace {

TEST(JsonString, IsQuotedAndEscaped) {
    EXPECT_EQ(json_string(""), "\"\"");
    EXPECT_EQ(json_string("a\"b\\c\n"), "\"a\\\"b\\\\c\\n\"");
    EXPECT_EQ(json_string(std::string_view("\0", 1)), "\"\\u0000\"");
    EXPECT_EQ(json_string("\xFF"), "\"\xEF\xBF\xBD\"");
}

}  // namespace
}  // namespace ncsim::setup
