// SPDX-License-Identifier: GPL-3.0-or-later
//
// ZIP archives without time stamps, such as 3MF files.
// Source: PKWARE, .ZIP File Format Specification (APPNOTE).
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

namespace ncsim::exporter {

/// Writes compressed files into an archive. `finish` ends the archive.
class ZipWriter {
public:
    explicit ZipWriter(std::ostream& out) : out_(out) {}

    /// Adds a file.
    /// Throws: std::runtime_error if the archive would exceed 4 GiB.
    void add(std::string_view name, std::string_view content);
    void finish();

private:
    void write(std::string_view bytes);

    std::ostream& out_;
    std::string directory_;
    std::uint64_t written_ = 0;
    std::uint16_t files_ = 0;
};

}  // namespace ncsim::exporter
