// SPDX-License-Identifier: GPL-3.0-or-later
//
// Output files that are written completely or not at all.
#include "system/output.h"

#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <stdexcept>

namespace ncsim::app {
namespace {

using cli_test::Folder;

class Outputs : public testing::Test {
protected:
    std::string at(const char* name) const { return (folder.path() / name).string(); }
    static void hello(std::ostream& out) { out << "hello"; }
    Folder folder;
    setup::InputSet inputs;
};

TEST_F(Outputs, AppearAllAtOnceWhenCommitted) {
    OutputSet outputs(inputs);
    outputs.reserve(at("a"));
    outputs.write(at("a"), hello);
    EXPECT_FALSE(folder.has("a"));
    outputs.commit();
    EXPECT_EQ(folder.read("a"), "hello");
    EXPECT_EQ(folder.files().size(), 1U);
}

TEST_F(Outputs, LeaveWhatWasThereWhenTheyAreNot) {
    folder.write("a", "old");
    {
        OutputSet outputs(inputs);
        outputs.reserve(at("a"));
        outputs.write(at("a"), hello);
    }
    EXPECT_EQ(folder.read("a"), "old");
    EXPECT_EQ(folder.files().size(), 1U);
}

TEST_F(Outputs, ThatWereReservedButNotWrittenDisappear) {
    OutputSet outputs(inputs);
    outputs.reserve(at("a"));
    outputs.commit();
    EXPECT_TRUE(folder.files().empty());
}

TEST_F(Outputs, ThatFailHalfwayLeaveNothing) {
    {
        OutputSet outputs(inputs);
        outputs.reserve(at("a"));
        EXPECT_THROW(outputs.write(at("a"),
                                   [](std::ostream& out) {
                                       out << "half";
                                       throw std::runtime_error("no");
                                   }),
                     std::runtime_error);
    }
    EXPECT_TRUE(folder.files().empty());
}

TEST_F(Outputs, KeepThePermissionsOfWhatTheyReplace) {
    folder.write("a", "old");
    std::filesystem::permissions(at("a"), std::filesystem::perms::owner_all);
    OutputSet outputs(inputs);
    outputs.reserve(at("a"));
    outputs.write(at("a"), hello);
    outputs.commit();
    EXPECT_EQ(std::filesystem::status(at("a")).permissions(), std::filesystem::perms::owner_all);
}

TEST_F(Outputs, LargerThanTheirBufferArriveWhole) {
    OutputSet outputs(inputs);
    outputs.reserve(at("a"));
    outputs.write(at("a"), [](std::ostream& out) {
        for (int i = 0; i < 100000; ++i)
            out << "0123456789";
    });
    outputs.commit();
    EXPECT_EQ(folder.read("a").size(), 1000000U);
}

TEST_F(Outputs, WithoutAPathAreNotWanted) {
    OutputSet outputs(inputs);
    outputs.reserve("");
    outputs.write("", [](std::ostream&) { FAIL(); });
}

}  // namespace
}  // namespace ncsim::app
