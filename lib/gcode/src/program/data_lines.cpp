// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines of data of Fanuc, from G10 L50 to G11: parameters of the control, tool life, pitch errors.
#include "program/runner.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace ncsim::gcode {
namespace {

constexpr int kToolLife = 3;
constexpr int kParameters = 50;
constexpr int kPitchErrors = 51;
constexpr int kNewerParameters = 52;

struct NumberRange {
    std::uint32_t first, last;
};

/// Parameters of Fanuc 0i and 30i that change no motion: channels of data, displays, protection of
/// programs, counters of parts and of time.
constexpr auto kHarmless =
    std::to_array<NumberRange>({{20, 24}, {3100, 3199}, {3202, 3202}, {6711, 6713}, {6750, 6758}});

bool is_harmless(std::uint32_t parameter) {
    return std::ranges::any_of(kHarmless, [parameter](const NumberRange& range) {
        return parameter >= range.first && parameter <= range.last;
    });
}

bool has_g11(const Block& block) {
    return std::ranges::any_of(block.words, [](const Word& word) {
        return word.letter == 'G' && word.literal && word.number == 11.0;
    });
}

/// Returns the letters of lines of data behind G10 L`kind`.
std::string_view letters_of_data(int kind) {
    return kind == kToolLife ? "PLTHDQKRB" : "PQR";
}

}  // namespace

/// Begins to leave out lines if the block has G10 L3, L50, L51 or L52.
void Runner::begin_data_lines() {
    if (!rules_.has_data_lines() || command_.group(Group::OneShot) != Code::G10) return;
    const double l = command_.get('L', 0.0);
    constexpr std::array kKinds{kToolLife, kParameters, kPitchErrors, kNewerParameters};
    const auto* const kind = std::ranges::find(kKinds, l);
    if (kind == kKinds.end()) return;
    data_lines_ = *kind;
    const bool has_parameters = *kind == kParameters || *kind == kNewerParameters;
    if (!has_parameters)
        log_.add(Message::DataLines, command_.span, {join_label("G10 L", std::to_string(*kind))});
}

/// Leaves out a line of data, or ends the data at G11.
/// Returns: false if the block is to be executed.
bool Runner::take_data_line() {
    const std::string head = join_label("G10 L", std::to_string(data_lines_));
    if (has_g11(block_)) {
        data_lines_ = 0;
        return false;
    }
    const std::string_view expected = letters_of_data(data_lines_);
    const bool is_data = std::ranges::all_of(block_.words, [expected](const Word& word) {
        return expected.find(word.letter) != std::string_view::npos;
    });
    if (!is_data) {
        fault(Message::DataLinesOpen, block_.line_span(), {head});
        data_lines_ = 0;
        return false;
    }
    const bool writes_parameter = data_lines_ == kParameters || data_lines_ == kNewerParameters;
    if (!writes_parameter || !block_.has_number || is_harmless(block_.number)) return true;
    if (resolver_.is_allowed('N', block_.number)) return true;
    const std::string number = std::to_string(block_.number);
    log_.add(Message::DataLine, block_.line_span(), {head, number, number});
    return true;
}

}  // namespace ncsim::gcode
