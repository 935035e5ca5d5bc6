// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that a check met: judged, judged with the caller, or left out; and the verdict of all.
#include "ncsim/report/scope.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ncsim::report {
namespace {

Entry entry(const std::string& path, const std::string& word, const std::string& reads = {},
            bool is_subprogram = false) {
    Entry made;
    made.path = path;
    made.word = word;
    made.reads = reads;
    made.is_subprogram = is_subprogram;
    return made;
}

Entries all_of(const std::vector<Entry>& list) {
    return [&list](const std::function<void(const Entry&)>& take) {
        for (const Entry& one : list)
            take(one);
    };
}

std::string paths(const Entries& all) {
    std::string text;
    all([&](const Entry& one) { text += one.path + ' '; });
    return text;
}

TEST(Scope, TheWorstVerdictCounts) {
    std::vector<Entry> list;
    EXPECT_EQ(worst_verdict(all_of(list)), "clean");
    for (const char* word : {"accepted", "not-proven", "failed", "not-verified"}) {
        list.push_back(entry("a.nc", word));
        EXPECT_EQ(worst_verdict(all_of(list)), word);
        list.push_back(entry("b.nc", "clean"));
        EXPECT_EQ(worst_verdict(all_of(list)), word);
    }
}

TEST(Scope, SubprogramsThatAJudgedProgramReadsAreCalled) {
    const std::vector<Entry> list{entry("s1.nc", "clean", "", true),
                                  entry("main.nc", "clean", "main.nc\n./x/../s1.nc\n"),
                                  entry("s2.nc", "clean", "s2.nc\ns3.nc", true),
                                  entry("s3.nc", "clean", "", true),
                                  entry("other.nc", "not-verified", "s2.nc\n"),
                                  entry("again.nc", "clean", "s1.nc\n")};
    const Entries all = all_of(list);
    const auto called = called_files(all);
    ASSERT_EQ(called.size(), 2U);
    EXPECT_EQ(called[0].path, "s1.nc");
    EXPECT_EQ(called[0].caller, "main.nc") << "the first caller";
    EXPECT_EQ(called[1].path, "s3.nc") << "s2 is judged as a program, because no verdict reads it";
    EXPECT_EQ(called[1].caller, "s2.nc");
    EXPECT_EQ(paths(remove_called(all, called)), "main.nc other.nc again.nc s2.nc ");
    EXPECT_EQ(paths(remove_called(all, called)), "main.nc other.nc again.nc s2.nc ") << "repeated";
    const std::vector<Entry> mains{entry("a.nc", "clean"), entry("b.nc", "clean", "a.nc\n")};
    EXPECT_TRUE(called_files(all_of(mains)).empty()) << "a main program is never called";
}

TEST(Scope, LeftOutFilesAreCountedByKind) {
    EXPECT_EQ(text_of(std::vector<ExcludedEntry>{}), "");
    EXPECT_EQ(text_of(std::vector<ExcludedEntry>{{"a.bin", "binary file"}}),
              "ncsim: 1 left out: no NC program; to judge one all the same, name it\n"
              "ncsim:   binary file: 1: a.bin\n");
    EXPECT_EQ(text_of(std::vector<ExcludedEntry>{{"p", "FIFO"},
                                                 {"a", "binary file"},
                                                 {"b", "binary file"},
                                                 {"c", "binary file"},
                                                 {"d", "binary file"}}),
              "ncsim: 5 left out: no NC programs; to judge one all the same, name it\n"
              "ncsim:   FIFO: 1: p\n"
              "ncsim:   binary file: 4: a, b, c and 1 more\n");
    Scope scope;
    EXPECT_EQ(counts_of(scope), "");
    scope.called = {{"a", "b"}};
    EXPECT_EQ(counts_of(scope), "; 1 subprogram, judged with its caller");
    scope.called.push_back({"c", "b"});
    scope.excluded = {{"x", "FIFO"}, {"y", "FIFO"}};
    EXPECT_EQ(counts_of(scope), "; 2 subprograms, judged with their callers; 2 left out");
}

}  // namespace
}  // namespace ncsim::report
