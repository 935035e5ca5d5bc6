// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/verify/suppression.h"

#include "ncsim/gcode/parser.h"
#include "ncsim/verify/rule.h"

#include <algorithm>
#include <cctype>

namespace ncsim::verify {

namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

// The words behind "ncsim: ignore", or none.
std::vector<std::string> ignored_in(std::string_view comment) {
    const std::string text = lower(comment);
    std::vector<std::string> words;
    std::string word;
    for (const char c : text + " ") {
        if (c == ' ' || c == '\t' || c == ',') {
            if (!word.empty()) words.push_back(std::move(word));
            word.clear();
        } else {
            word += c;
        }
    }
    if (words.size() < 3 || words[0] != "ncsim:" || words[1] != "ignore") return {};
    words.erase(words.begin(), words.begin() + 2);
    return words;
}

}  // namespace

Suppressions::Suppressions(const gcode::SourceFile& program) {
    gcode::BlockReader reader(program);
    gcode::Block block;
    std::set<std::string, std::less<>> pending;
    while (reader.next(block)) {
        for (const gcode::Comment& comment : block.comments) {
            for (const std::string& name : ignored_in(comment.text)) {
                const auto ids = rules_named(name);
                if (ids.empty()) unknown_.push_back({name, comment.span});
                pending.insert(ids.begin(), ids.end());
            }
        }
        const bool does_something = !block.words.empty() || !block.assignments.empty() ||
                                    block.control.word != gcode::ControlWord::None;
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
