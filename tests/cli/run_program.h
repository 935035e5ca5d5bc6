// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the built ncsim in a temporary folder, as a shell would.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ncsim::cli_test {

struct Ran {
    int exit_code = -1;  ///< Exit code; 128 + n after signal n.
    std::string out, err;
};

/// Temporary folder, removed by the destructor.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    void write(const std::string& name, const std::string& text) const;
    std::string read(const std::string& name) const;
    /// Returns lattice and cells of a .ncstock file, without assumptions, programs and lines.
    std::string read_cells(const std::string& name) const;
    bool has(const std::string& name) const;
    /// Returns the sorted names of all files.
    std::vector<std::string> files() const;
    /// Runs `ncsim arguments…` in the folder with an empty standard input.
    Ran run(const std::vector<std::string>& arguments) const;
    /// Runs a script of sh in the folder, in which "$0" is ncsim. Standard input is empty.
    Ran shell(const std::string& script) const;

private:
    Ran execute(std::vector<std::string> words) const;

    std::filesystem::path path_;
};

/// Program that cuts a slot of 10 x 2 mm across a block of 40 x 30 x 10 mm: 800 mm³.
inline constexpr const char* kSlot =
    "(T1 D=10. CR=0. - ZMIN=-2. - flat end mill)\n"
    "(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\n"
    "G21 G90 G17 (FROM/0.,0.,100.)\n"
    "T1 M6\n"
    "S1000 M3\n"
    "G0 X-30. Y0. Z5.\n"
    "G0 Z-2.\n"
    "G1 X30. F500.\n"
    "G0 Z5.\n"
    "M30\n";

/// True if `part` occurs in `text`.
inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace ncsim::cli_test
