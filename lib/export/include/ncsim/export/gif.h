// SPDX-License-Identifier: GPL-3.0-or-later
//
// Animated pictures: GIF89a, written with giflib.
#pragma once

#include "ncsim/export/image.h"

#include <iosfwd>
#include <memory>

namespace ncsim::exporter {

/// Writes an animation frame by frame; the animation repeats for ever. Each frame after the first
/// holds only the pixels that differ from the frame before, in a palette of 255 colours of its own.
/// Unchanged pixels therefore never flicker.
///
/// Guarantees: equal input gives equal bytes.
/// Throws: every member throws std::runtime_error if the stream fails.
class GifWriter {
public:
    /// Requires: `out` outlives the writer.
    explicit GifWriter(std::ostream& out);
    ~GifWriter();
    GifWriter(const GifWriter&) = delete;
    GifWriter& operator=(const GifWriter&) = delete;

    /// Shows `frame` for `hundredths` of a second.
    /// Throws: std::runtime_error if the frame has no pixels, has a side of more than 65535 pixels,
    ///     or differs in size from the first frame.
    void add(const Image& frame, int hundredths);
    /// Ends the file.
    /// Requires: at least one frame was added.
    void finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ncsim::exporter
