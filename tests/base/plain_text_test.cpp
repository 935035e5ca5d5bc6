// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/base/plain_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace ncsim {
namespace {

TEST(PlainText, KeepsWhatIsPlain) {
    EXPECT_EQ(printable("fr\xc3\xa4ser \xc3\x84: 5 # 3"), "fr\xc3\xa4ser \xc3\x84: 5 # 3");
}

TEST(PlainText, HasNoControlCharacters) {
    EXPECT_EQ(printable("a\tb\x1b[2J\r\nc\x7f"), "a b?[2J?\nc?");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m \x9b ok \xc3\xbc \xfc"),
              "??31m ? ok \xc3\xbc \xfc");
    EXPECT_EQ(printable("\xe2\x80\xae"
                        "reversed \xe2\x80\xa8 \xe2\x82\xac"),
              "???reversed ??? \xe2\x82\xac");
    EXPECT_EQ(one_line("a\nb"), "a?b");
}

// A terminal may take each byte of an overlong form or of a surrogate for a character of its own.
TEST(PlainText, HasNoControlCharactersInBytesThatAreNotUtf8) {
    EXPECT_EQ(printable("\xe0\x80\x9b"
                        "31m"),
              "\xe0??31m");
    EXPECT_EQ(printable("\xed\xa0\x9b"
                        "31m"),
              "\xed\xa0?31m");
    EXPECT_EQ(printable("\xf4\x90\xbf\x9b"), "\xf4?\xbf?");
}

TEST(PlainText, HasNothingThatACiServiceObeys) {
    EXPECT_EQ(printable("::error::x\n \t::add-mask::y\n\xc2\xa0::z\nok ::w"),
              "?:error::x\n  ?:add-mask::y\n\xc2\xa0?:z\nok ::w");
    EXPECT_EQ(printable("##[error]x\na ##vso[b] ###TeamCity[c]"),
              "#?[error]x\na #?vso[b] ##?TeamCity[c]");
    EXPECT_EQ(printable("G1 X##[100] Y##[#1] #[##2] Z##3"), "G1 X##[100] Y##[#1] #[##2] Z##3");
}

TEST(PlainText, LeavesPathsThatLeadToTheSameFile) {
    EXPECT_EQ(printable_path("a/b.nc"), "a/b.nc");
    for (const char* path : {"::error::x", "##[error]", " ::x", "=cmd.nc", "+1", "-1", "@a"})
        EXPECT_EQ(printable_path(path).substr(0, 2), "./") << path;
    EXPECT_EQ(printable_path("a\n::error::.nc"), "a??:error::.nc");
}

TEST(PlainText, LeavesJsonThatSaysTheSame) {
    const nlohmann::json json{"###vso[a]", "##[1]", "\\##[error]"};
    const std::string shown = printable_json(json.dump());
    EXPECT_EQ(shown.find("##v"), std::string::npos);
    EXPECT_EQ(shown.find("##[e"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(shown), json);
}

}  // namespace
}  // namespace ncsim
