// SPDX-License-Identifier: GPL-3.0-or-later
//
// Long programs are restarted once with memory in large pages; short programs and further commands
// are not.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::cli_test {
namespace {

// Returns GLIBC_TUNABLES of a run that waits for its job. Before the restart, the process with the
// open job is the shell.
std::string tunables(const Folder& folder, const std::string& program, const char* before = "") {
    return folder
        .shell(std::string(before) + R"sh(
            mkfifo job; exec 3<>job
            "$0" run --job job )sh" +
               program + R"sh( >/dev/null 2>&1 3>&- &
            until [ "$(readlink /proc/$!/exe)" = "$(readlink -f "$0")" ] &&
                readlink /proc/$!/fd/* | grep -q job; do sleep 0.01; done
            tr '\0' '\n' < /proc/$!/environ | grep GLIBC_TUNABLES
            exec 3>&-; wait; rm job)sh")
        .out;
}

std::string comments(std::size_t bytes) {
    std::string text;
    while (text.size() < bytes)
        text += "(a comment that says nothing)\n";
    return text;
}

class LargePages : public testing::Test {
protected:
    void SetUp() override {
        folder.write("short.nc", kSlot);
        folder.write("long.nc", kSlot + comments(100'000));
    }
    Folder folder;
};

TEST_F(LargePages, AreForLongPrograms) {
    const std::string asked = "GLIBC_TUNABLES=glibc.malloc.hugetlb=1\n";
    EXPECT_EQ(tunables(folder, "long.nc"), asked);
    EXPECT_EQ(tunables(folder, "."), asked);
    EXPECT_EQ(tunables(folder, "short.nc"), "");
}

TEST_F(LargePages, AreForTheUserToDecide) {
    EXPECT_EQ(tunables(folder, "long.nc", "export GLIBC_TUNABLES=glibc.malloc.perturb=1;"),
              "GLIBC_TUNABLES=glibc.malloc.perturb=1\n");
    EXPECT_EQ(tunables(folder, "long.nc", "export LD_PRELOAD=libm.so.6;"), "");
}

TEST_F(LargePages, ChangeNothingElse) {
    const Ran with = folder.run({"run", "long.nc", "--stl", "a.stl"});
    const Ran without =
        folder.shell(R"(GLIBC_TUNABLES= "$0" run long.nc --stl b.stl; echo "code $?")");
    EXPECT_EQ(with.exit_code, 0) << with.err;
    EXPECT_EQ(with.out + "code 0\n", without.out);
    EXPECT_EQ(folder.read("a.stl"), folder.read("b.stl"));
    EXPECT_EQ(folder.run({"run", "long.nc", "--no-such-option"}).exit_code, 2);
}

}  // namespace
}  // namespace ncsim::cli_test
