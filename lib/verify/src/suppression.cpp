// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parses suppressions in the comments of a program.
#include "ncsim/verify/suppression.h"

#include "ncsim/base/ascii.h"
#include "ncsim/gcode/language.h"
#include "ncsim/gcode/parser.h"
#include "ncsim/verify/rule.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace ncsim::verify {

namespace {

constexpr std::string_view kBlanks = " \t";

void skip_blanks(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : text) {
        const bool separates = c == ',' || kBlanks.find(c) != std::string_view::npos;
        if (!separates) word += c;
        if (separates && !word.empty()) words.push_back(std::exchange(word, {}));
    }
    if (!word.empty()) words.push_back(std::move(word));
    return words;
}

// Returns the words after "ncsim: ignore". Empty optional: the comment requests nothing. No words:
// the comment requests something but is not understood.
std::optional<std::vector<std::string>> ignored_in(std::string_view comment) {
    const std::string whole = lowercase(comment);
    std::string_view text = whole;
    skip_blanks(text);
    constexpr std::string_view kName = "ncsim";
    if (!text.starts_with(kName)) return std::nullopt;
    text.remove_prefix(kName.size());
    // A longer name belongs to a different program.
    if (!text.empty() && std::isalnum(static_cast<unsigned char>(text.front())) != 0)
        return std::nullopt;
    skip_blanks(text);
    if (!text.starts_with(':')) {
        // "ncsim found this" is a remark; "ncsim, ignore all" is a malformed request.
        while (!text.empty() && std::isalnum(static_cast<unsigned char>(text.front())) == 0)
            text.remove_prefix(1);
        if (text.starts_with("ignor")) return std::vector<std::string>{};
        return std::nullopt;
    }
    std::vector<std::string> words = words_of(text.substr(1));
    if (words.empty() || words.front() != "ignore") return std::vector<std::string>{};
    words.erase(words.begin());
    return words;
}

}  // namespace

Suppressions::Suppressions(const gcode::SourceFile& program) {
    gcode::BlockReader reader(program);
    const auto notes = gcode::notes_of(program);
    gcode::Block block;
    std::set<std::string, std::less<>> pending;
    while (notes ? notes->next(block) : reader.next(block)) {
        for (const gcode::Comment& comment : block.comments) {
            const auto names = ignored_in(comment.text);
            if (names && names->empty()) unknown_.push_back({{}, comment.span});
            for (const std::string& name : names.value_or(std::vector<std::string>{})) {
                const auto ids = rules_named(name);
                if (ids.empty()) unknown_.push_back({name, comment.span});
                pending.insert(ids.begin(), ids.end());
            }
        }
        const bool does_something = !block.words.empty() || !block.assignments.empty() ||
                                    block.control.word != gcode::ControlWord::None ||
                                    (notes && !block.text.empty());
        if (!does_something || pending.empty()) continue;
        lines_.emplace(block.line, std::move(pending));
        pending.clear();
    }
}

bool Suppressions::covers(std::uint32_t line, std::string_view rule) const {
    const auto found = lines_.find(line);
    return found != lines_.end() && found->second.contains(rule);
}

}  // namespace ncsim::verify
