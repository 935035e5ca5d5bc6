// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours severities and verdicts.
#include "system/colour.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace ncsim::app {

namespace {

constexpr std::string_view kReset = "\x1b[0m", kBold = "\x1b[1m", kGreen = "\x1b[32m";

struct Word {
    std::string_view text;  // between ": " and ":" or the end of the line
    std::string_view colour;
};
constexpr std::string_view kRed = "\x1b[1;31m", kYellow = "\x1b[1;33m", kCyan = "\x1b[1;36m";
constexpr Word kWords[] = {{"error", kRed},      {"failed", kRed},          {"not verified", kRed},
                           {"warning", kYellow}, {"doubt", kYellow},        {"not proven", kYellow},
                           {"note", kCyan},      {"accepted doubt", kCyan}, {"accepted", kGreen},
                           {"clean", kGreen}};

// Returns the length of the word at the start of `text`, if ":", "," or the end follows; 0: none.
const Word* word_at(std::string_view text) {
    const auto* const found = std::ranges::find_if(kWords, [&](const Word& word) {
        if (!text.starts_with(word.text)) return false;
        const std::string_view rest = text.substr(word.text.size());
        return rest.empty() || rest.front() == ':' || rest.front() == ',';
    });
    return found == std::end(kWords) ? nullptr : found;
}

// True for the line below a source line: blanks, carets, tildes.
bool is_caret_line(std::string_view line) {
    return line.find('^') != std::string_view::npos &&
           line.find_first_not_of(" |^~") == std::string_view::npos;
}

void add_line(std::string& out, std::string_view line) {
    if (is_caret_line(line)) {
        out.append(kGreen).append(line).append(kReset);
        return;
    }
    for (std::size_t at = line.find(": "); at != std::string_view::npos;
         at = line.find(": ", at + 1)) {
        const Word* const word = word_at(line.substr(at + 2));
        if (!word) continue;
        out.append(kBold).append(line.substr(0, at)).append(kReset).append(": ");
        out.append(word->colour).append(word->text).append(kReset);
        out.append(line.substr(at + 2 + word->text.size()));
        return;
    }
    out.append(line);
}

}  // namespace

std::optional<ColourMode> colour_mode(std::string_view name) {
    if (name == "auto") return ColourMode::Auto;
    if (name == "always") return ColourMode::Always;
    if (name == "never") return ColourMode::Never;
    return std::nullopt;
}

std::string take_colour(std::vector<std::string>& words) {
    constexpr std::string_view kOption = "--color";
    std::string mode = "auto";
    for (std::size_t i = 0; i < words.size() && words[i] != "--";) {
        const std::string word = words[i];
        const bool is_joined = word.starts_with("--color=");
        if (word != kOption && !is_joined) {
            ++i;
            continue;
        }
        const auto first = words.begin() + static_cast<std::ptrdiff_t>(i);
        if (is_joined || i + 1 == words.size()) {
            mode = is_joined ? word.substr(kOption.size() + 1) : "";
            words.erase(first);
        } else {
            mode = words[i + 1];
            words.erase(first, first + 2);
        }
    }
    return mode;
}

bool has_colours(ColourMode mode, int descriptor) {
    if (mode != ColourMode::Auto) return mode == ColourMode::Always;
    const char* const no_colour = std::getenv("NO_COLOR");
    if (no_colour && *no_colour != '\0') return false;
    const char* const terminal = std::getenv("TERM");
    return terminal && std::string_view(terminal) != "dumb" && ::isatty(descriptor) != 0;
}

std::string coloured(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        add_line(out, text.substr(0, end));
        if (end < text.size()) out += '\n';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out;
}

}  // namespace ncsim::app
