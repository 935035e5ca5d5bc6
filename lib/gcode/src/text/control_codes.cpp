// SPDX-License-Identifier: GPL-3.0-or-later
//
// Codes that a program uses and a control lacks.
#include "ncsim/gcode/control_codes.h"

#include "ncsim/gcode/dialect.h"
#include "ncsim/gcode/parser.h"
#include "ncsim/gcode/print.h"

#include "text/number.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ncsim::gcode {
namespace {

constexpr ControlCodes kControls[] = {
#define NCSIM_CONTROL(name, title, g, optional_g, m, optional_m, axes, features, complete, \
                      otherwise, source)                                                   \
    {name, title, g, optional_g, m, optional_m, axes, features, complete, otherwise, source},
#include "text/control_codes.def"
#undef NCSIM_CONTROL
};

/// Returns ten times the number at the start of `text`, and removes the number from `text`.
int take_tenths(std::string_view& text) {
    const PlainNumber number = read_plain_number(text.data(), text.data() + text.size());
    text.remove_prefix(static_cast<std::size_t>(number.end - text.data()));
    return static_cast<int>(std::lround(number.value * 10.0));
}

/// Numbers of a letter's codes, in tenths.
using CodeSet = std::bitset<11'000>;

struct CodeSets {
    CodeSet g, optional_g, m, optional_m;
};

/// Reads "0 1 38.2 54-59". A range contains whole numbers unless the first number has a decimal.
CodeSet read_codes(std::string_view list) {
    CodeSet codes;
    while (!list.empty()) {
        if (list.front() == ' ') {
            list.remove_prefix(1);
            continue;
        }
        const int first = take_tenths(list);
        int last = first;
        if (list.starts_with('-')) {
            list.remove_prefix(1);
            last = take_tenths(list);
        }
        for (int tenths = first; tenths <= last; tenths += first % 10 == 0 ? 10 : 1)
            codes.set(static_cast<std::size_t>(tenths));
    }
    return codes;
}

/// Returns the sets of each control, in the order of the table.
const std::vector<CodeSets>& code_sets() {
    static const auto sets = [] {
        std::vector<CodeSets> all;
        for (const ControlCodes& control : kControls) {
            all.push_back({read_codes(control.g), read_codes(control.optional_g),
                           read_codes(control.m), read_codes(control.optional_m)});
        }
        return all;
    }();
    return sets;
}

/// True for kinds whose language is not G-code.
bool is_other_language(Kind kind) {
    switch (kind) {
        case Kind::Heidenhain:
        case Kind::HeidenhainIso:
        case Kind::Siemens:
        case Kind::Okuma:
        case Kind::Isg: return true;
        default: return false;
    }
}

class Census {
public:
    explicit Census(const ControlCodes& control) : control_(control) {}

    void take(const Block& block) {
        if (block.kind == BlockKind::Unreadable)
            return add("lines that ncsim cannot read", block.line_span(), CodeSupport::Unknown);
        if (block.kind != BlockKind::Words) return;
        take_course(block);
        if (block.block_delete) need(kBlockDelete, "lines that begin with '/'", block.line_span());
        if (block.deletable.length > 0 && !block.block_delete)
            need(kSkippedRest, "'/' within a line", block.deletable);
        if (!block.assignments.empty())
            need(kVariables, "variables", block.assignments.front().span);
        bool is_arc = false;
        for (const Word& word : block.words) {
            if (word.letter == 'G' && word.literal) {
                is_arc = word.number == 2.0 || word.number == 3.0;
                if (word.number < 4.0) arcs_ = is_arc;
            }
            take(word);
        }
        const Word* radius = find_word(block, 'R');
        const bool moves = find_word(block, 'X') || find_word(block, 'Y') || find_word(block, 'Z');
        if (radius && moves && (is_arc || (arcs_ && !has_g(block))))
            need(kArcsByRadius, "arcs by radius (R)", radius->span);
    }

    std::vector<CodeUse> uses() && { return std::move(uses_); }

private:
    static bool has_g(const Block& block) { return find_word(block, 'G') != nullptr; }

    void take(const Word& word) {
        if (word.comma) return need(kCornerWords, "corners by ,R and ,C", word.span);
        constexpr std::string_view kOtherAxes = "ABCUVW";
        const bool is_axis = kOtherAxes.find(word.letter) != std::string_view::npos;
        if (is_axis && control_.axes.find(word.letter) == std::string_view::npos)
            return add(std::string("axis ") + word.letter, word.span);
        const bool is_code = word.letter == 'G' || word.letter == 'M';
        if (!word.literal && is_code && (control_.features & (kVariables | kExpressions)) != 0)
            return add("codes by expressions", word.span, CodeSupport::Unknown);
        if (!word.literal) {
            const bool by_variable = word.text.find('#') != std::string_view::npos;
            if (by_variable) return need(kVariables, "variables", word.span);
            return need(kExpressions, "expressions", word.span);
        }
        if (!is_code) return;
        const CodeSupport support = support_of(control_, word.letter, word.number);
        if (support == CodeSupport::Yes) return;
        std::string name(1, word.letter);
        print_number(name, std::round(word.number * 1e4) / 1e4);
        add(name, word.span, support);
    }

    void take_course(const Block& block) {
        switch (block.control.word) {
            case ControlWord::None:
            case ControlWord::ProgramNumber: return;
            case ControlWord::If:
            case ControlWord::Goto:
            case ControlWord::While:
            case ControlWord::End:
                return need(kMacroB, "IF, WHILE and GOTO of Macro B", block.control.span);
            default: return need(kOWords, "O-words (sub, if, while)", block.control.span);
        }
    }

    void need(ControlFeature feature, std::string_view name, SourceSpan span) {
        if ((control_.features & feature) == 0) add(std::string(name), span);
    }

    void add(const std::string& what, SourceSpan span, CodeSupport support = CodeSupport::No) {
        const auto known = std::ranges::find(uses_, what, &CodeUse::what);
        if (known != uses_.end()) {
            ++known->count;
            return;
        }
        constexpr std::size_t kMostUses = 1000;
        if (uses_.size() < kMostUses) uses_.push_back({what, span, 1, support});
    }

    const ControlCodes& control_;
    bool arcs_ = false;  // G2 or G3 is the motion mode.
    std::vector<CodeUse> uses_;
};

}  // namespace

std::span<const ControlCodes> all_control_codes() {
    return kControls;
}

const ControlCodes* find_control_codes(std::string_view name) {
    const auto* found = std::ranges::find(kControls, name, &ControlCodes::name);
    return found == std::end(kControls) ? nullptr : found;
}

CodeSupport support_of(const ControlCodes& control, char letter, double number) {
    const CodeSets& sets = code_sets()[static_cast<std::size_t>(&control - kControls)];
    const double tenths = std::round(number * 10.0);
    if (std::abs(number * 10.0 - tenths) > 1e-3 || tenths < 0.0 ||
        tenths >= static_cast<double>(sets.g.size()))
        return CodeSupport::No;
    const auto at = static_cast<std::size_t>(tenths);
    const bool is_g = letter == 'G';
    if ((is_g ? sets.g : sets.m).test(at)) return CodeSupport::Yes;
    return (is_g ? sets.optional_g : sets.optional_m).test(at) ? CodeSupport::Option
                                                               : CodeSupport::No;
}

std::vector<CodeUse> missing_codes(const SourceFile& program, const ControlCodes& control) {
    const DialectFindings findings = detect_dialect(program);
    const auto whole = [&](std::string what, CodeSupport support) {
        const bool has_line = !findings.kind_evidence.empty();
        const std::uint32_t line = has_line ? findings.kind_evidence.front().line : 1;
        return std::vector<CodeUse>{{std::move(what), {std::max(line, 1U), 1, 1}, 1, support}};
    };
    if (is_other_language(findings.kind)) {
        return whole("reader for the language of " + std::string(name_of(findings.kind)),
                     CodeSupport::No);
    }
    if (findings.kind == Kind::NotAProgram)
        return whole("files without NC words", CodeSupport::Unknown);
    Census census(control);
    BlockReader reader(program);
    Block block;
    while (reader.next(block))
        census.take(block);
    return std::move(census).uses();
}

}  // namespace ncsim::gcode
