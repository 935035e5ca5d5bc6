// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures taken while the part is cut: as numbered files, as one moving picture.
#pragma once

#include "ncsim/export/gif.h"

#include "run/outcome.h"
#include "system/output.h"

#include <cstdint>
#include <optional>
#include <sstream>

namespace ncsim::app {

class Animation {
public:
    /// Makes the folder for frames if it is not there; throws std::runtime_error if that fails.
    Animation(const Options& options, const simulation::Survey& survey, OutputSet& outputs);

    /// Moves from one picture to the next; 0: none are asked for.
    std::uint64_t every() const { return every_; }

    /// A picture of the part as it is now. A frame is written to its file at once, whole or not
    /// at all. Throws std::runtime_error if the world fails.
    void take(const Outcome& outcome);
    /// The moving picture, to `out`. Its last frame stays for two seconds.
    void write_gif(std::ostream& out);

private:
    const Options& options_;
    OutputSet& outputs_;
    std::uint64_t every_ = 0;
    std::uint32_t taken_ = 0;
    std::ostringstream bytes_;
    std::optional<exporter::GifWriter> gif_;
    std::optional<exporter::Image> last_;  // not yet in the GIF: it may have to stay longer
};

}  // namespace ncsim::app
