// SPDX-License-Identifier: GPL-3.0-or-later
//
// Full disks, missing write permission, and two processes that write the same file: an error is
// reported and no data is lost. The tests mount disks of a few kilobytes in a private namespace and
// are skipped where mounting is not permitted.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

// Runs the script with a disk that is mounted at "disk" with `options`.
Ran with_disk(const Folder& folder, const std::string& options, const std::string& script) {
    std::filesystem::create_directories(folder.path() / "disk");
    folder.write("script", "mount -t tmpfs -o " + options + " none disk || exit 99\n" + script);
    return folder.shell("unshare -rm sh ./script \"$0\"");
}

bool may_mount() {
    const Folder folder;
    return with_disk(folder, "size=64k", "exit 0").exit_code == 0;
}

#define NCSIM_NEEDS_DISKS() \
    if (!may_mount()) GTEST_SKIP() << "mounting a disk is not permitted here (unshare -rm)"

// Only the files that the script lists with "ls" remain.
TEST(FullDisk, IsToldOfEveryResult) {
    NCSIM_NEEDS_DISKS();
    const Folder folder;
    folder.write("slot.nc", kSlot);
    const std::string full = "head -c 60000 /dev/zero > disk/full\n";
    for (const std::string command :
         {"check slot.nc --shard 0/1 --out disk -q", "check slot.nc --json disk/a.json",
          "run slot.nc -q --tile 0/2 --tile-out disk", "run slot.nc -q --stl disk/a.stl",
          "run slot.nc -q --gltf disk/a.glb --report disk/a.json",
          "check slot.nc --write-baseline disk/a.json"}) {
        // Fills the last page of the disk, so no room is left.
        const Ran ran = with_disk(folder, "size=64k",
                                  full + "head -c 4000 /dev/zero >> disk/full\n\"$1\" " + command +
                                      "; echo code $?; ls disk");
        EXPECT_TRUE(contains(ran.out, "code 2\nfull\n")) << command << '\n' << ran.out << ran.err;
        EXPECT_TRUE(contains(ran.err, "No space left on device")) << command << '\n' << ran.err;
    }
}

TEST(FullDisk, IsToldOfAFolderOfMeshes) {
    NCSIM_NEEDS_DISKS();
    const Folder folder;
    folder.write("slot.nc", kSlot);
    for (const char* tile : {"0/2", "1/2"})
        ASSERT_EQ(
            folder.run({"run", "slot.nc", "-q", "--tile", tile, "--tile-out", "tiles"}).exit_code,
            0);
    const Ran ran = with_disk(folder, "size=4k",
                              "\"$1\" merge tiles -q --gltf disk/mold/; echo code $?; ls disk "
                              "disk/mold | grep -v 0000.glb");
    EXPECT_TRUE(contains(ran.out, "code 2\n")) << ran.out << ran.err;
    EXPECT_TRUE(contains(ran.err, "No space left on device")) << ran.err;
    EXPECT_FALSE(contains(ran.out, "json")) << ran.out;
    EXPECT_FALSE(contains(ran.out, "tmp")) << ran.out;
}

TEST(FullDisk, DoesNotMatterToACache) {
    NCSIM_NEEDS_DISKS();
    const Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran plain = folder.run({"check", "slot.nc"});
    for (const std::string options : {"size=4k", "ro", "size=64k,nr_inodes=2"}) {
        const Ran ran = with_disk(folder, options,
                                  "for i in 1 2; do \"$1\" check slot.nc --cache disk; done; "
                                  "find disk -type f");
        EXPECT_EQ(ran.out, plain.out + plain.out) << options;
        EXPECT_TRUE(contains(ran.err, "ncsim: cannot write to the cache 'disk': ")) << ran.err;
    }
}

// A second writer stores the same bytes; a concurrent reader reads either copy.
TEST(Cache, MayHaveManyWriters) {
    const Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran plain = folder.run({"check", "slot.nc"});
    const Ran many = folder.shell(
        "for i in 1 2 3 4 5 6 7 8; do \"$0\" check slot.nc --cache cache > out.$i & done; wait\n"
        "for i in 1 2 3 4 5 6 7 8; do cat out.$i; done; find cache -type f | wc -l");
    std::string expected;
    for (int i = 0; i < 8; ++i)
        expected += plain.out;
    EXPECT_EQ(many.out, expected + "1\n");
    EXPECT_EQ(folder.run({"check", "slot.nc", "--cache", "cache"}).out, plain.out);
}

}  // namespace
}  // namespace ncsim::cli_test
