// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim-mpi writes the bytes of ncsim run for any number of processes. Skipped if ncsim-mpi is not
// built.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

#ifdef NCSIM_MPI_PROGRAM

// Runs ncsim-mpi with mpirun. Messages of mpirun itself about failed ranks are not output of ncsim.
Ran with_ranks(const Folder& folder, int ranks, const std::string& arguments) {
    return folder.shell("mpirun --allow-run-as-root --oversubscribe --bind-to none -np " +
                        std::to_string(ranks) + " " NCSIM_MPI_PROGRAM " " + arguments);
}

TEST(Mpi, MakesTheBytesOfOneRun) {
    const Folder folder;
    std::ifstream in(std::filesystem::path(NCSIM_SOURCE_DIR) / "samples/complex.nc");
    std::ostringstream text;
    text << in.rdbuf();
    folder.write("complex.nc", text.str());
    const std::string words = "run complex.nc --gltf a.glb --stl a.stl --png a.png --report a.json";
    const Ran once = folder.shell("\"$0\" " + words);
    ASSERT_EQ(once.exit_code, 0) << once.err;
    std::vector<std::string> files;
    for (const char* name : {"a.glb", "a.stl", "a.png", "a.json"})
        files.push_back(folder.read(name));
    for (const int ranks : {1, 2, 7}) {
        SCOPED_TRACE(ranks);
        folder.shell("rm a.*");
        const Ran ran = with_ranks(folder, ranks, words);
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_EQ(ran.out, once.out);
        std::size_t i = 0;
        for (const char* name : {"a.glb", "a.stl", "a.png", "a.json"})
            EXPECT_TRUE(folder.read(name) == files[i++]) << name;
    }
    EXPECT_EQ(with_ranks(folder, 2, "run complex.nc -q --gltf mold/").exit_code, 0);
    EXPECT_TRUE(folder.has("mold.json"));
}

TEST(Mpi, SaysOnceWhatIsWrong) {
    const Folder folder;
    folder.write("rest.nc", "G21\nG0 X1.\nG2 X5. F10.\n");
    const Ran once = folder.shell("\"$0\" run rest.nc");
    const Ran ran = with_ranks(folder, 2, "run rest.nc");
    EXPECT_EQ(once.exit_code, 1);
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_EQ(ran.out, once.out);
    EXPECT_TRUE(contains(ran.err, once.err)) << ran.err;
    for (const std::string wrong :
         {"run nowhere.nc", "run rest.nc --step a.step", "check rest.nc"}) {
        EXPECT_EQ(with_ranks(folder, 2, wrong).exit_code, 2) << wrong;
    }
}

#else

TEST(Mpi, MakesTheBytesOfOneRun) {
    GTEST_SKIP() << "ncsim-mpi is not built: there is no MPI (./dev deps mpi)";
}

#endif

}  // namespace
}  // namespace ncsim::cli_test
