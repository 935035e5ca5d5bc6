// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures during the cut: numbered files, or animated pictures.
#pragma once

#include "ncsim/export/apng.h"
#include "ncsim/export/gif.h"

#include "run/outcome.h"
#include "system/output.h"

#include <cstdint>
#include <optional>
#include <sstream>

namespace ncsim::app {

class Animation {
public:
    /// Creates the folder for frames if necessary.
    /// Throws: std::runtime_error if the folder cannot be created.
    Animation(const Options& options, const simulation::Survey& survey, OutputSet& outputs);

    /// Returns the number of moves between two pictures; 0: no pictures.
    std::uint64_t every() const { return every_; }

    /// Takes a picture of the current part. A frame is written to its file at once, completely or
    /// not at all.
    /// Throws: std::runtime_error if a frame cannot be written.
    void take(const Outcome& outcome);
    /// Ends the animated pictures. The last frame stays for two seconds.
    void finish();
    /// Write an animated picture to `out`.
    /// Requires: finish() was called.
    void write_gif(std::ostream& out) const;
    void write_apng(std::ostream& out) const;

private:
    void add_last(int hundredths);

    const Options& options_;
    OutputSet& outputs_;
    std::uint64_t every_ = 0;
    std::uint32_t taken_ = 0;
    std::ostringstream bytes_;
    std::optional<exporter::GifWriter> gif_;
    std::optional<exporter::ApngWriter> apng_;
    // Not yet in the animated pictures, because the last frame stays longer.
    std::optional<exporter::Image> last_;
};

}  // namespace ncsim::app
