// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests 3MF files. lib3mf checks that the files are valid (read_3mf.cpp).
#include "ncsim/export/threemf.h"

#include "formats/zip.h"
#include "support/box_part.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace ncsim::exporter {
namespace {

std::string written(const cda::Boundary& boundary, const mesh::Provenance& provenance) {
    std::ostringstream out;
    write_3mf(out, boundary, provenance);
    return out.str();
}

TEST(ZipWriter, NamesEachFileTwiceAndHasNoTime) {
    std::ostringstream out;
    ZipWriter archive(out);
    archive.add("a.txt", std::string(1000, 'x'));
    archive.add("folder/b.txt", "");
    archive.finish();
    const std::string bytes = out.str();
    EXPECT_EQ(bytes.substr(0, 4), "PK\x03\x04");
    EXPECT_EQ(bytes.substr(10, 4), std::string("\0\0\x21\0", 4));  // 1980-01-01 00:00
    EXPECT_NE(bytes.find("a.txt"), bytes.rfind("a.txt"));
    EXPECT_NE(bytes.find("folder/b.txt"), bytes.rfind("folder/b.txt"));
    EXPECT_LT(bytes.size(), 400U);
    EXPECT_EQ(bytes.substr(bytes.size() - 22, 4), "PK\x05\x06");
}

TEST(Write3mf, SaysTheSameTwice) {
    const auto part = test::grooved_part();
    EXPECT_EQ(written(test::boundary_of(part), test::provenance_of(part)),
              written(test::boundary_of(part), test::provenance_of(part)));
}

TEST(Write3mf, TellsThatTheStreamFailed) {
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    EXPECT_THROW(write_3mf(out, {}, {}), std::runtime_error);
}

}  // namespace
}  // namespace ncsim::exporter
