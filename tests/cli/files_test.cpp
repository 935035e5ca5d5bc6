// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files of all kinds under any name: endless inputs, links, devices, "-". No output overwrites an
// input.
#include "ncsim/setup/input.h"

#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// --- Inputs ------------------------------------------------------------------------------------

TEST(Input, IsReadUpToALimit) {
    const Folder folder;
    folder.write("a", "12345");
    const std::string path = (folder.path() / "a").string();
    setup::InputSet inputs;
    EXPECT_EQ(inputs.read(path, 5), "12345");
    EXPECT_THROW(inputs.read(path, 4), std::runtime_error);
}

TEST(Input, ThatNeverEndsIsRefused) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    fs::create_symlink("/dev/zero", folder.path() / "zero.stl");
    const std::vector<std::pair<Words, std::string>> commands{
        {{"check", "/dev/zero"}, "larger than 64 MB"},
        {{"run", "/dev/zero"}, "larger than 64 MB"},
        {{"parse", "slot.nc", "--job", "/dev/zero"}, "larger than 64 MB"},
        {{"tools", "slot.nc", "--tool-table", "/dev/zero"}, "larger than 64 MB"},
        {{"run", "slot.nc", "--holders", "/dev/zero"}, "larger than 64 MB"},
        {{"run", "slot.nc", "--stock", "zero.stl"}, "larger than 64 MB"},
        {{"check", "slot.nc", "--machine", "/dev/zero"}, "larger than 64 MB"},
        {{"check", "slot.nc", "--design", "/dev/zero"}, "larger than 64 MB"},
        {{"diff", "slot.nc", "/dev/zero"}, "larger than 64 MB"},
        {{"check", "slot.nc", "--machine", "."}, "Is a directory"},
        {{"check", "slot.nc", "--design", "."}, "Is a directory"},
        {{"run", "."}, "Is a directory"},
        {{"run", "slot.nc", "--job", "."}, "Is a directory"},
        {{"run", "slot.nc", "--tool-table", "."}, "Is a directory"},
    };
    for (const auto& [command, message] : commands) {
        const Ran ran = folder.run(command);
        EXPECT_EQ(ran.exit_code, 2) << testing::PrintToString(command);
        EXPECT_TRUE(contains(ran.out + ran.err, message)) << ran.out << ran.err;
    }
    const Ran pipe = folder.shell(R"(mkfifo p; { exec yes >p 2>&-; } & "$0" run slot.nc --job p)");
    EXPECT_EQ(pipe.exit_code, 2);
    EXPECT_TRUE(contains(pipe.err, "larger than 64 MB")) << pipe.err;
}

TEST(Input, IsWhatIsNamedAndNothingThatItNames) {
    const Folder folder;
    folder.write("slot.nc", kSlot);
    const std::string json =
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"slot.nc"}]})";
    const auto word = [](std::size_t n) {
        std::string bytes;
        for (int shift = 0; shift < 32; shift += 8)
            bytes += static_cast<char>(n >> shift & 0xff);
        return bytes;
    };
    ASSERT_EQ(json.size() % 4, 0U);
    folder.write("a.glb",
                 "glTF" + word(2) + word(20 + json.size()) + word(json.size()) + "JSON" + json);
    const Ran ran = folder.run({"check", "slot.nc", "--design", "a.glb"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "no binary glTF that can be read")) << ran.err;
}

constexpr const char* kTable = "T1 P1 D10 ;a flat end mill\n";

// Writes files of all kinds next to a slot whose cut is in a subprogram.
void write_inputs(const Folder& folder) {
    std::string program(kSlot);
    program.replace(program.find("G1 X30. F500."), 13, "M98 P100");
    folder.write("slot.nc", program);
    folder.write("O100.nc", "O100\nG1 X30. F500.\nM99\n");
    folder.write("other.nc", kSlot);
    folder.write("tools.tbl", kTable);
    folder.write("holders.toml",
                 "[[holder]]\nname = \"h\"\nsegments = [[20, 20, 30]]\n"
                 "[[tool]]\nnumber = 1\nholder = \"h\"\nstick_out = 40\n");
    folder.write("job.toml",
                 "program = \"slot.nc\"\nholders = \"holders.toml\"\n[stock]\n"
                 "file = \"part.stl\"\n");
    folder.write("machine.toml", "[[fixture]]\nmesh = \"vice.stl\"\n");
    ASSERT_EQ(
        folder.run({"run", "other.nc", "--stl", "part.stl", "--save-stock", "left.ncstock", "-q"})
            .exit_code,
        0);
    folder.write("vice.stl", folder.read("part.stl"));
    folder.write("design.stl", folder.read("part.stl"));
}

TEST(Subprogram, IsFoundByItsNumberInAFileOfAnotherName) {
    Folder folder;
    write_inputs(folder);
    ASSERT_EQ(folder.run({"run", "slot.nc", "--stl", "a.stl", "-q"}).exit_code, 0);
    folder.shell("mv O100.nc pocket.nc");
    ASSERT_EQ(folder.run({"run", "slot.nc", "--stl", "b.stl", "-q"}).exit_code, 0);
    EXPECT_EQ(folder.read("b.stl"), folder.read("a.stl"));
    // The subprogram number in a different spelling, among further subprograms.
    folder.write("pocket.nc", "%\nO1000\nM99\n o00100 (POCKET)\nG1 X30. F500.\nM99\n%\n");
    ASSERT_EQ(folder.run({"run", "slot.nc", "--stl", "b.stl", "-q"}).exit_code, 0);
    EXPECT_EQ(folder.read("b.stl"), folder.read("a.stl"));
    // A subprogram is not found if two files match, or in a text that is not a program.
    folder.write("older.nc", "O100\nG1 X20. F500.\nM99\n");
    const Ran two = folder.run({"run", "slot.nc", "-q"});
    EXPECT_EQ(two.exit_code, 1);
    EXPECT_TRUE(contains(two.err, "nor one file alone in which it begins")) << two.err;
    folder.write("older.nc", "o100 sub\nG1 X20. F500.\no100 endsub\n");  // not a program number
    ASSERT_EQ(folder.run({"run", "slot.nc", "--stl", "b.stl", "-q"}).exit_code, 0);
    EXPECT_EQ(folder.read("b.stl"), folder.read("a.stl"));
    folder.shell("rm older.nc; mv pocket.nc pocket.doc");
    EXPECT_EQ(folder.run({"run", "slot.nc", "-q"}).exit_code, 1);
}

TEST(StandardInput, IsAnyFile) {
    Folder folder;
    write_inputs(folder);
    const std::vector<std::pair<std::string, std::string>> commands{
        {"parse - --canonical", "other.nc"},
        {"parse - --json", "other.nc"},
        {"run - --stl out -q", "other.nc"},
        {"check - --notes", "slot.nc"},
        {"run --job - --stl out -q", "job.toml"},
        {"tools other.nc --tool-table -", "tools.tbl"},
        {"run other.nc --holders - --save-job out -q", "holders.toml"},
        {"run other.nc --stock - --stl out -q", "part.stl"},
        {"run other.nc --stock - --stl out -q", "left.ncstock"},
        {"check other.nc other.nc --job - --notes -j 2", "job.toml"},
        {"check other.nc --machine - --notes", "machine.toml"},
        {"check other.nc --design - --notes", "design.stl"},
        {"diff other.nc -", "slot.nc"},
    };
    for (const auto& [command, file] : commands) {
        std::string named = command;
        named.replace(
            named.find(" - ") == std::string::npos ? named.size() - 1 : named.find(" - ") + 1, 1,
            file);
        // Names aside.
        const std::string script = R"({ "$0" )" + command + " <" + file +
                                   "; echo $?; } 2>&1 | sed 's/<stdin>/" + file +
                                   "/g' >1; mv out 1.out 2>&-; { \"$0\" " + named +
                                   "; echo $?; } >2 2>&1; mv out 2.out 2>&-; cat 2; cmp 1 2 && "
                                   "{ ! test -e 2.out || cmp 1.out 2.out; }";
        const Ran ran = folder.shell(script);
        EXPECT_EQ(ran.exit_code, 0) << command << '\n' << folder.read("1") << ran.out << ran.err;
        EXPECT_FALSE(contains(ran.out, "cannot read")) << ran.out;
        folder.shell("rm -f 1 2 1.out 2.out");
    }
}

TEST(StandardInput, IsOneFile) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    for (const Words& command :
         {Words{"check", "-", "-"}, Words{"run", "-", "--job", "-"}, Words{"diff", "-", "-"},
          Words{"check", "slot.nc", "--machine", "-", "--design", "-"}}) {
        const Ran ran = folder.run(command);
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_TRUE(contains(ran.err, "'-' is named twice")) << ran.err;
    }
    folder.write("-", kSlot);
    EXPECT_EQ(folder.run({"run", "./-"}).exit_code, 0);
}

// --- Outputs -----------------------------------------------------------------------------------

const std::vector<Words> kOutputs{{"run", "other.nc", "--report"},
                                  {"run", "other.nc", "--png"},
                                  {"run", "other.nc", "--gltf"},
                                  {"run", "other.nc", "--stl"},
                                  {"run", "other.nc", "--ply"},
                                  {"run", "other.nc", "--3mf"},
                                  {"run", "other.nc", "--step"},
                                  {"run", "other.nc", "--vrml"},
                                  {"run", "other.nc", "--gif"},
                                  {"run", "other.nc", "--save-job"},
                                  {"run", "other.nc", "--save-stock"},
                                  {"run", "other.nc", "--xml"},
                                  {"tools", "other.nc", "--save-job"},
                                  {"check", "other.nc", "--json"},
                                  {"check", "other.nc", "--sarif"},
                                  {"check", "other.nc", "--junit"},
                                  {"check", "other.nc", "--csv"},
                                  {"check", "other.nc", "--html"},
                                  {"diff", "other.nc", "other.nc", "--json"}};

TEST(StandardOutput, IsAnyFileAndNothingElse) {
    Folder folder;
    folder.write("other.nc", kSlot);
    for (const Words& command : kOutputs) {
        const Ran named = folder.run(command + Words{"file"});
        const std::string expected = folder.read("file");
        EXPECT_FALSE(expected.empty());
        for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
            if (name[0] == '/' && command.back() != "--json") continue;
            SCOPED_TRACE(testing::PrintToString(command + Words{name}));
            const Ran ran = folder.run(command + Words{name});
            EXPECT_EQ(ran.exit_code, named.exit_code) << ran.err;
            EXPECT_TRUE(ran.out == expected) << ran.out.substr(0, 500);
            // Text for readers goes to the second stream.
            EXPECT_TRUE(contains(ran.err, named.out)) << ran.err;
        }
        EXPECT_TRUE(fs::is_symlink("/dev/stdout"));
        EXPECT_EQ(folder.files(), (Words{"file", "other.nc"}));
    }
}

TEST(StandardOutput, IsOneFile) {
    Folder folder;
    folder.write("other.nc", kSlot);
    for (const Words& command : {Words{"run", "other.nc", "--png", "-", "--stl", "-"},
                                 Words{"run", "other.nc", "--png", "-", "--report", "/dev/stdout"},
                                 Words{"check", "other.nc", "--github", "--json", "-"},
                                 Words{"tools", "other.nc", "--json", "--save-job", "-"}}) {
        const Ran ran = folder.run(command);
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_EQ(ran.out, "");
        EXPECT_TRUE(contains(ran.err, "the standard output can be one of them")) << ran.err;
    }
}

TEST(Output, IsWrittenThroughLinksAndPipes) {
    Folder folder;
    folder.write("other.nc", kSlot);
    fs::create_directory(folder.path() / "there");
    folder.write("there/old.json", "old");
    fs::create_symlink("there/old.json", folder.path() / "old");
    fs::create_symlink("new.json", folder.path() / "there/new");
    fs::create_symlink("there/new", folder.path() / "new");
    fs::create_symlink("circle", folder.path() / "circle");
    EXPECT_EQ(folder.run({"check", "other.nc", "--json", "old", "-q"}).exit_code, 0);
    EXPECT_EQ(folder.run({"check", "other.nc", "--json", "new", "-q"}).exit_code, 0);
    EXPECT_TRUE(fs::is_symlink(folder.path() / "old"));
    EXPECT_TRUE(fs::is_symlink(folder.path() / "new"));
    EXPECT_TRUE(contains(folder.read("there/old.json"), "\"programs\""));
    EXPECT_EQ(folder.read("there/old.json"), folder.read("there/new.json"));
    const Ran circle = folder.run({"check", "other.nc", "--json", "circle"});
    EXPECT_EQ(circle.exit_code, 2);
    EXPECT_TRUE(contains(circle.err, "cannot write 'circle'")) << circle.err;

    const Ran ran =
        folder.shell(R"(mkfifo p; cat p >read & "$0" check other.nc --json p -q; wait; test -p p)");
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(folder.read("read"), folder.read("there/new.json"));
    // An output file that is already open is appended in place.
    const Ran open = folder.shell(
        R"({ echo head >&3; "$0" check other.nc --json /dev/fd/3 -q; echo tail >&3; } 3>log)");
    EXPECT_EQ(open.exit_code, 0) << open.err;
    EXPECT_EQ(folder.read("log"), "head\n" + folder.read("read") + "tail\n");
}

// --- No output overwrites an input --------------------------------------------------------------

TEST(Output, DestroysNoInput) {
    Folder folder;
    write_inputs(folder);
    const Words check{"check", "slot.nc", "-q"};
    const std::map<std::string, Words> readers{
        {"slot.nc", check},
        {"O100.nc", check},
        {"job.toml", check + Words{"--job", "job.toml"}},
        {"holders.toml", check + Words{"--job", "job.toml"}},
        {"part.stl", check + Words{"--job", "job.toml"}},
        {"machine.toml", check + Words{"--machine", "machine.toml"}},
        {"vice.stl", check + Words{"--machine", "machine.toml"}},
        {"design.stl", check + Words{"--design", "design.stl"}},
        {"tools.tbl", check + Words{"--tool-table", "tools.tbl"}},
        {"left.ncstock", check + Words{"--stock", "left.ncstock"}},
    };
    fs::create_directory(folder.path() / "links");
    for (const auto& [input, command] : readers) {
        const std::string before = folder.read(input);
        const fs::path at = folder.path() / input;
        fs::create_symlink("../" + input, folder.path() / "links/soft");
        fs::create_hard_link(at, folder.path() / "links/hard");
        for (const std::string& output : {input, "./" + input, "links/../" + input, at.string(),
                                          std::string("links/soft"), std::string("links/hard")}) {
            SCOPED_TRACE(testing::PrintToString(command) + " " + output);
            const Ran ran = folder.run(command + Words{"--json", output, "--csv", "a.csv"});
            EXPECT_EQ(ran.exit_code, 2) << ran.out;
            EXPECT_TRUE(contains(ran.err, "'" + output + "' is read, too")) << ran.err;
            EXPECT_FALSE(folder.has("a.csv"));
            EXPECT_EQ(folder.read(input), before);
            EXPECT_TRUE(fs::is_symlink(folder.path() / "links/soft"));
        }
        fs::remove(folder.path() / "links/soft");
        fs::remove(folder.path() / "links/hard");
    }
    for (const Words& command :
         {Words{"run", "--job", "job.toml", "--report", "job.toml"},
          Words{"run", "--job", "job.toml", "--report", "slot.nc"},
          Words{"run", "--job", "job.toml", "--save-job", "./job.toml"},
          Words{"run", "slot.nc", "--stl", "O100.nc"},
          Words{"run", "other.nc", "--stock", "part.stl", "--stl", "./part.stl"},
          Words{"tools", "slot.nc", "--tool-table", "tools.tbl", "--save-job", "./tools.tbl"},
          Words{"diff", "slot.nc", "other.nc", "--json", "./other.nc"},
          Words{"diff", "slot.nc", "other.nc", "--json", "O100.nc"}}) {
        const std::string before = folder.read(command.back());
        const Ran ran = folder.run(command);
        EXPECT_EQ(ran.exit_code, 2) << testing::PrintToString(command);
        EXPECT_TRUE(contains(ran.err, "' is read, too")) << ran.err;
        EXPECT_EQ(folder.read(command.back()), before);
    }
}

TEST(Output, DestroysNoOther) {
    Folder folder;
    folder.write("other.nc", kSlot);
    folder.write("old", "old");
    fs::create_directory(folder.path() / "real");
    fs::create_directory_symlink("real", folder.path() / "link");
    fs::create_symlink("old", folder.path() / "soft");
    fs::create_hard_link(folder.path() / "old", folder.path() / "hard");
    for (const auto& [a, b] :
         std::vector<std::pair<std::string, std::string>>{{"a", "./a"},
                                                          {"real/a", "link/../real/a"},
                                                          {"real/a", "link/a"},
                                                          {"old", "soft"},
                                                          {"hard", "old"}}) {
        const Ran ran = folder.run({"run", "other.nc", "--stl", a, "--report", b});
        EXPECT_EQ(ran.exit_code, 2) << a << ' ' << b;
        EXPECT_TRUE(contains(ran.err, "'" + b + "' is named twice")) << ran.err;
    }
    EXPECT_EQ(folder.read("old"), "old");
    EXPECT_EQ(folder.run({"run", "other.nc", "--stl", "a", "--report", "real/a"}).exit_code, 0);
    EXPECT_EQ(
        folder.run({"run", "other.nc", "--stl", "/dev/null", "--report", "/dev/null"}).exit_code,
        0);
    const Ran frames =
        folder.run({"run", "other.nc", "--frames", "real", "--png", "link/frame-00001.png"});
    EXPECT_EQ(frames.exit_code, 2);
    EXPECT_TRUE(contains(frames.err, "is named twice")) << frames.err;
}

}  // namespace
}  // namespace ncsim::cli_test
