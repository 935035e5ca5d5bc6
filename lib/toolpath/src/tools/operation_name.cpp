// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recognises names of operations by the form of comments.
#include "ncsim/toolpath/operation_name.h"

#include "tools/comment_text.h"

#include <algorithm>
#include <array>

namespace ncsim::toolpath {

namespace {

constexpr std::size_t kMostBytes = 60, kMostWords = 6;

// Text in front of the name.
constexpr std::array<std::string_view, 6> kIntroductions{
    "BEGIN OPERATION:", "START OPERATION:", "OPERATION NAME:", "OPERATION:", "OP:", "TOOLPATH:"};
// Beginnings of comments without the name of an operation: ends of operations, and comments that
// controls execute.
constexpr std::array<std::string_view, 12> kOthers{
    "FINISH OPERATION", "END OPERATION", "END ",      "PATH:",      "MSG,",  "DEBUG,",
    "PRINT,",           "LOG",           "PROBEOPEN", "PROBECLOSE", "AXIS,", "HTTP"};

// Returns `text` without blanks, dashes, stars and similar characters at both ends.
std::string_view without_frame(std::string_view text) {
    constexpr std::string_view kFrame = " \t-*=#_~:";
    return trimmed(text, kFrame);
}

std::size_t words_in(std::string_view text) {
    std::size_t words = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
        words += text[i] != ' ' && (i == 0 || text[i - 1] == ' ') ? 1 : 0;
    return words;
}

}  // namespace

std::optional<std::string> operation_name_of(std::string_view comment) {
    if (comment.size() > 4 * kMostBytes) return std::nullopt;
    std::string_view name = without_frame(comment);
    const std::string upper = uppercase(name);
    const auto begins = [&upper](std::string_view words) { return upper.starts_with(words); };
    if (std::ranges::any_of(kOthers, begins)) return std::nullopt;
    if (const auto* const found = std::ranges::find_if(kIntroductions, begins);
        found != kIntroductions.end())
        name = without_frame(name.substr(found->size()));
    const bool is_value = name.find_first_of("=;%[]{}\\") != std::string_view::npos;
    if (name.size() < 2 || name.size() > kMostBytes || is_value || name.ends_with('.') ||
        name.ends_with('!') || name.ends_with('?') || words_in(name) > kMostWords ||
        std::ranges::count_if(name, text::is_letter) < 2)
        return std::nullopt;
    return std::string(name);
}

}  // namespace ncsim::toolpath
