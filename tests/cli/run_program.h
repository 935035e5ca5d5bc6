// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the built ncsim as a shell would, in a folder of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ncsim::cli_test {

struct Ran {
    int exit_code = -1;  ///< 128 + n after signal n.
    std::string out, err;
};

/// A folder that disappears with it.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    void write(const std::string& name, const std::string& text) const;
    std::string read(const std::string& name) const;
    bool has(const std::string& name) const;
    /// Names of all files, sorted.
    std::vector<std::string> files() const;
    /// Runs `ncsim arguments…` here, with a standard input that is empty.
    Ran run(const std::vector<std::string>& arguments) const;
    /// The same for a script of sh, in which "$0" is ncsim.
    Ran shell(const std::string& script) const;

private:
    Ran execute(std::vector<std::string> words) const;

    std::filesystem::path path_;
};

/// A program that cuts one slot of 10 x 2 mm across a block of 40 x 30 x 10 mm: 800 mm³.
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
