// SPDX-License-Identifier: GPL-3.0-or-later
//
// Takes pictures during the cut.
#include "run/animation.h"

#include "ncsim/export/png.h"

#include "run/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <system_error>

namespace ncsim::app {

namespace {

// Default number of pictures: shows the progress of the part in a few seconds.
constexpr std::uint64_t kUsualFrames = 100;

// Hundredths of a second.
constexpr int kFrameTime = 8;
constexpr int kLastFrameTime = 200;

}  // namespace

Animation::Animation(const Options& options, const simulation::Survey& survey, OutputSet& outputs)
    : options_(options), outputs_(outputs) {
    if (options_.frames.empty() && options_.gif.empty() && options_.apng.empty()) return;
    every_ = options_.every != 0 ? options_.every
                                 : std::max<std::uint64_t>(1, survey.moves / kUsualFrames);
    if (!options_.gif.empty()) gif_.emplace(bytes_);
    if (!options_.apng.empty()) apng_.emplace();
    if (options_.frames.empty()) return;
    std::error_code error;
    std::filesystem::create_directory(options_.frames, error);
    if (error || !std::filesystem::is_directory(options_.frames)) {
        throw std::runtime_error(fmt::format("cannot make the folder '{}'{}", options_.frames,
                                             error ? ": " + error.message() : ""));
    }
}

void Animation::take(const Outcome& outcome) {
    exporter::Image image = picture(outcome);
    ++taken_;
    if (!options_.frames.empty()) {
        const auto name = fmt::format("frame-{:05}.png", taken_);
        const std::string path = (std::filesystem::path(options_.frames) / name).string();
        outputs_.write_now(path, [&](std::ostream& out) { exporter::write_png(out, image); });
    }
    if (!gif_ && !apng_) return;
    add_last(kFrameTime);
    last_ = std::move(image);
}

void Animation::add_last(int hundredths) {
    if (!last_) return;
    if (gif_) gif_->add(*last_, hundredths);
    if (apng_) apng_->add(*last_, hundredths);
}

void Animation::finish() {
    add_last(kLastFrameTime);
    last_.reset();
    if (gif_) gif_->finish();
}

void Animation::write_gif(std::ostream& out) const {
    out << bytes_.view();
}

void Animation::write_apng(std::ostream& out) const {
    apng_->write(out);
}

}  // namespace ncsim::app
