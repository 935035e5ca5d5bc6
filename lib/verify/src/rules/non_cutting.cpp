// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rule non-cutting-contact: shanks and holders in material.
#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace ncsim::verify {

namespace {

bool has_body(const ToolFacts& facts) {
    return std::ranges::any_of(facts.tool.pieces,
                               [](const toolpath::ToolPiece& p) { return !p.cutting; });
}

double top_of(const toolpath::ToolPiece& piece) {
    return piece.profile.back().radius;
}

}  // namespace

std::optional<std::string> needs_bodies(const Setup& setup) {
    if (auto reason = needs_simulation(setup)) return reason;
    std::string neither, no_holder;
    for (const auto& [number, facts] : setup.tools) {
        if (facts.holder_specified) continue;
        std::string& list = has_body(facts) ? no_holder : neither;
        list += fmt::format("{}T{}", list.empty() ? "" : ", ", number);
    }
    if (neither.empty() && no_holder.empty()) return std::nullopt;
    std::string reason;
    if (!neither.empty())
        reason = "neither flute length, shank nor holder is specified for " + neither;
    if (!no_holder.empty()) {
        reason += fmt::format("{}no holder is specified for {}; the rest of {} was verified",
                              reason.empty() ? "" : "; ", no_holder,
                              no_holder.find(',') == std::string::npos ? "it" : "them");
    }
    return reason;
}

void judge_non_cutting(const Setup& setup, const Move& move, FindingLog& log) {
    for (const BodyContact& contact : move.bodies) {
        const toolpath::Tool& tool = facts_of(setup, move.motion->tool)->tool;
        const toolpath::ToolPiece& piece = tool.pieces[contact.piece];
        double diameter = 0.0;
        for (const toolpath::ProfilePoint& p : piece.profile)
            diameter = std::max(diameter, 2 * p.radius);
        Occurrence s{fmt::format(
            "the D{:.6g} segment of T{} from {:.6g} to {:.6g} mm above its tip, which does not "
            "cut, meets material",
            diameter, move.motion->tool, piece.profile.front().height,
            piece.profile.back().height)};
        s.quantity = Quantity{"stick-out missing", contact.raise_mm, "mm"};
        s.certainty = contact.certainty;
        s.rests_on = guesses_of(setup, move, contact.certainty);
        // A piece is assumed as thick as the piece below, except for mills with a neck. The true
        // holder may sit higher than the lowest possible place.
        const double below = contact.piece > 0 ? top_of(tool.pieces[contact.piece - 1]) : 0.0;
        const bool as_thick = diameter <= 2 * below + 1e-6 &&
                              !toolpath::is_undercutting(tool.kind) &&
                              tool.kind != toolpath::ToolKind::Other;
        if (piece.assumed && !as_thick) s.rests_on.emplace_back("tool-guess");
        s.point = contact.point;
        s.box = contact.box;
        s.assumptions = assumptions_of(setup, move);
        if (piece.assumed)
            s.assumptions.emplace_back("tool: not all of its shape above the flutes is specified");
        log.add("non-cutting-contact", move, std::move(s));
    }
}

}  // namespace ncsim::verify
