// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moving pictures that play everywhere: GIF89a, through giflib.
#pragma once

#include "ncsim/export/image.h"

#include <iosfwd>
#include <memory>

namespace ncsim::exporter {

/// Writes an animation frame by frame; it repeats for ever. A frame holds only what differs from
/// the one before, in the 255 colours that suit it best: what does not change never flickers.
///
/// Equal input gives equal bytes. All members throw std::runtime_error if the stream fails.
class GifWriter {
public:
    /// `out` must outlive the writer.
    explicit GifWriter(std::ostream& out);
    ~GifWriter();
    GifWriter(const GifWriter&) = delete;
    GifWriter& operator=(const GifWriter&) = delete;

    /// Shows `frame` for `hundredths` of a second. All frames must be as large as the first, which
    /// must have pixels; throws std::runtime_error if not.
    void add(const Image& frame, int hundredths);
    /// Ends the file. Requires a frame.
    void finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ncsim::exporter
