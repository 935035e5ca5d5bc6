// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules fixture-contact and fixture-clearance.
#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

namespace ncsim::verify {

namespace {

std::string describe_contact(const Setup& setup, const Move& move, const FixtureContact& contact) {
    const auto* tool = facts_of(setup, move.motion->tool);
    const bool cuts = tool->tool.pieces[contact.piece].cutting;
    return fmt::format("{} of T{}", cuts ? "the cutter" : "shank or holder", move.motion->tool);
}

}  // namespace

std::optional<std::string> needs_fixtures(const Setup& setup) {
    if (auto reason = needs_simulation(setup)) return reason;
    if (setup.machine.fixtures.empty() && !setup.machine.fixtures_specified)
        return "no fixtures are specified";
    return std::nullopt;
}

void judge_fixture_contact(const Setup& setup, const Move& move, FindingLog& log) {
    for (const FixtureContact& contact : move.fixtures) {
        if (!contact.touches) continue;
        const std::string fixture = name_of(setup.machine.fixtures[contact.fixture]);
        Occurrence s{fmt::format("{} meets {}", describe_contact(setup, move, contact), fixture)};
        s.bodies = {fixture};
        s.certainty = contact.certainty;
        s.rests_on = guesses_of(setup, move, contact.certainty);
        std::erase(s.rests_on, "stock-guess");  // fixtures do not depend on the stock
        s.box = contact.box;
        s.assumptions = assumptions_of(setup, move);
        log.add("fixture-contact", move, std::move(s));
    }
}

void judge_fixture_clearance(const Setup& setup, const Move& move, FindingLog& log) {
    for (const FixtureContact& contact : move.fixtures) {
        if (contact.touches) continue;
        const Fixture& fixture = setup.machine.fixtures[contact.fixture];
        Occurrence s{fmt::format("{} comes closer than {:.6g} mm to {}",
                                 describe_contact(setup, move, contact), fixture.clearance_mm,
                                 name_of(fixture))};
        s.bodies = {name_of(fixture)};
        s.certainty = contact.certainty;
        s.rests_on = guesses_of(setup, move, contact.certainty);
        std::erase(s.rests_on, "stock-guess");  // fixtures do not depend on the stock
        s.box = contact.box;
        s.assumptions = assumptions_of(setup, move);
        log.add("fixture-clearance", move, std::move(s));
    }
}

}  // namespace ncsim::verify
