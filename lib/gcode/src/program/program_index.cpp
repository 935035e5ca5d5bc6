// SPDX-License-Identifier: GPL-3.0-or-later
//
// Builds the index of a file in a single pass.
#include "program/program_index.h"

#include <algorithm>
#include <tuple>

namespace ncsim::gcode {

std::string plain_label(std::string_view label) {
    if (label.starts_with('<') && label.ends_with('>'))
        return std::string(label.substr(1, label.size() - 2));
    const std::size_t first = label.find_first_not_of('0');
    if (first == std::string_view::npos) return "0";
    return std::string(label.substr(first));
}

ProgramIndex::ProgramIndex(const SourceFile& file) {
    BlockReader reader(file);
    Block block;
    BlockReader::Place at = reader.place();
    while (reader.next(block)) {
        if (block.control.word != ControlWord::None) {
            markers_.push_back({block.control.word, plain_label(block.control.label), block.line,
                                at, reader.place()});
        }
        if (block.control.word == ControlWord::ProgramNumber) heads_.push_back(block.line);
        if (block.has_number) numbers_.push_back({block.number, block.line, at});
        at = reader.place();
    }
    std::ranges::sort(numbers_, {}, [](const Number& n) { return std::tuple(n.number, n.line); });
}

std::optional<std::size_t> ProgramIndex::at_line(std::uint32_t line) const {
    const auto found = std::ranges::lower_bound(markers_, line, {}, &Marker::line);
    if (found == markers_.end() || found->line != line) return std::nullopt;
    return static_cast<std::size_t>(found - markers_.begin());
}

std::optional<std::size_t> ProgramIndex::find(ControlWord word, std::string_view label) const {
    for (std::size_t i = 0; i < markers_.size(); ++i) {
        if (is(i, label, word)) return i;
    }
    return std::nullopt;
}

std::optional<BlockReader::Place> ProgramIndex::find_number(std::uint32_t number,
                                                            std::uint32_t line) const {
    const auto next_head = std::ranges::upper_bound(heads_, line);
    const std::uint32_t begin = next_head == heads_.begin() ? 0 : *(next_head - 1);
    const auto place = [](const Number& n) { return std::tuple(n.number, n.line); };
    const auto first = std::ranges::lower_bound(numbers_, std::tuple(number, begin), {}, place);
    const auto last =
        next_head == heads_.end()
            ? std::ranges::upper_bound(numbers_, number, {}, &Number::number)
            : std::ranges::lower_bound(numbers_, std::tuple(number, *next_head), {}, place);
    if (first == last) return std::nullopt;
    const auto after = std::find_if(first, last, [&](const Number& n) { return n.line >= line; });
    return (after == last ? first : after)->at;
}

}  // namespace ncsim::gcode
