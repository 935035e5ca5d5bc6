// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shanks and holders in material.
#include "rule_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace ncsim::verify {

namespace {

bool has_body(const ToolFacts& facts) {
    return std::ranges::any_of(facts.tool.pieces,
                               [](const toolpath::ToolPiece& p) { return !p.cutting; });
}

}  // namespace

std::optional<std::string> needs_bodies(const Setup& setup) {
    if (auto reason = needs_simulation(setup)) return reason;
    std::string without;
    bool any = false;
    for (const auto& [number, facts] : setup.tools) {
        if (has_body(facts)) {
            any = true;
        } else {
            without += fmt::format("{}T{}", without.empty() ? "" : ", ", number);
        }
    }
    if (without.empty()) return std::nullopt;
    return fmt::format("{} tell{} neither shank nor holder{}", without,
                       without.find(',') == std::string::npos ? "s" : "",
                       any ? "; the other tools were verified" : "");
}

void judge_non_cutting(const Setup& setup, const Move& move, FindingLog& log) {
    for (const BodyContact& contact : move.bodies) {
        const toolpath::Tool& tool = facts_of(setup, move.motion->tool)->tool;
        const toolpath::ToolPiece& piece = tool.pieces[contact.piece];
        double diameter = 0.0;
        for (const toolpath::ProfilePoint& p : piece.profile)
            diameter = std::max(diameter, 2 * p.radius);
        Sighting s{fmt::format(
            "the D{:.6g} segment of T{} from {:.6g} to {:.6g} mm above its tip, which does not "
            "cut, meets material",
            diameter, move.motion->tool, piece.profile.front().height,
            piece.profile.back().height)};
        s.quantity = Quantity{"stick-out missing", contact.raise_mm, "mm"};
        s.certainty = contact.certainty;
        s.weakened = contact.certainty == Certainty::Within || rests_on_guesses(setup, move);
        s.point = contact.point;
        s.box = contact.box;
        s.assumptions = assumptions_of(setup, move);
        log.add("non-cutting-contact", move, std::move(s));
    }
}

}  // namespace ncsim::verify
