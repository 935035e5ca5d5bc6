// SPDX-License-Identifier: GPL-3.0-or-later
//
// Animated pictures in all colours: APNG.
#pragma once

#include "ncsim/export/image.h"

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace ncsim::exporter {

/// Makes an animation frame by frame; the animation repeats for ever. Programs that do not know
/// APNG show the first frame, because the file is a PNG. Opacity is not kept.
///
/// Guarantees: equal input gives equal bytes.
/// Source: Portable Network Graphics (PNG) Specification, Third Edition, sections 4.9 and 11.3.4.
class ApngWriter {
public:
    /// Shows `frame` for `hundredths` of a second. Only the rectangle that differs from the frame
    /// before is kept.
    /// Throws: std::runtime_error if the frame has no pixels or differs in size from the first
    ///     frame.
    void add(const Image& frame, int hundredths);
    /// Writes the file.
    /// Requires: at least one frame was added.
    /// Throws: std::runtime_error if the stream fails.
    void write(std::ostream& out) const;

private:
    struct Frame {
        std::uint32_t left = 0, top = 0, width = 0, height = 0;
        int hundredths = 0;
        std::string pixels;  // compressed
    };
    std::vector<Frame> frames_;
    Image last_;
};

}  // namespace ncsim::exporter
