// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules machine-collision and machine-near-miss: contacts of links.
#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ncsim::verify {

namespace {

// Formats the positions of the existing joints: "X10 Z-120 A30".
std::string text_of(const machine::Chain& chain, const machine::Values& values) {
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const char letter = machine::kLetters[i];
        if (!chain.find(letter)) continue;
        text += fmt::format("{}{}{:.6g}", text.empty() ? "" : " ", letter, values[i] + 0.0);
    }
    return text;
}

bool is_of_part(const MachineContact& contact) {
    return contact.first == "the part";
}

bool is_of_tool(const MachineContact& contact) {
    return contact.second == "the tool";
}

std::vector<std::string_view> guesses_of_links(const Setup& setup, const Move& move,
                                               const MachineContact& contact) {
    std::vector<std::string_view> guesses = guesses_of(setup, move, contact.certainty);
    // A contact between links does not depend on the stock or the tool. It does depend on the
    // kinematics, because the position of the axes moves all links.
    std::erase_if(guesses, [&](std::string_view reason) {
        return (reason == "stock-guess" && !is_of_part(contact)) ||
               (reason == "tool-guess" && !is_of_tool(contact));
    });
    if (contact.assumed) guesses.emplace_back("tool-guess");
    const bool knows_axes = std::ranges::find(guesses, "kinematics-guess") != guesses.end();
    if (is_turned(*move.motion) && !setup.axes_guess.empty() && !knows_axes)
        guesses.emplace_back("kinematics-guess");
    return guesses;
}

Occurrence sighting_of(const Setup& setup, const Move& move, const MachineContact& contact,
                       std::string message) {
    Occurrence s{std::move(message)};
    s.lasts = true;
    s.certainty = contact.certainty;
    s.point = contact.point;
    s.box = move.path;
    s.bodies = {contact.first, contact.second};
    s.joints = contact.values;
    s.assumptions = assumptions_of(setup, move);
    std::erase_if(s.assumptions, [&contact](const std::string& text) {
        return (text.starts_with("stock:") && !is_of_part(contact)) ||
               (text.starts_with("tool:") && !is_of_tool(contact));
    });
    s.assumptions.insert(s.assumptions.end(), contact.hulls.begin(), contact.hulls.end());
    if (contact.assumed)
        s.assumptions.emplace_back("tool: not all of its shape above the flutes is specified");
    return s;
}

}  // namespace

std::optional<std::string> needs_links(const Setup& setup) {
    if (!setup.bodies || !setup.bodies->has_meshes())
        return "no mesh of a link is specified (machine.toml, [[link]] mesh)";
    if (!setup.machine.work_zero)
        return "the position of the work zero (G54) in the machine is not specified";
    std::string without;
    std::size_t count = 0;
    const LinkBodies& specified = setup.bodies->specified();
    for (std::size_t i = 0; i < specified.links.size(); ++i) {
        if (setup.bodies->body(i)) continue;
        without += fmt::format("{}'{}'", without.empty() ? "" : ", ", specified.links[i].name);
        ++count;
    }
    if (count == 0) return std::nullopt;
    return fmt::format("no mesh is specified for the link{} {}; the others were verified",
                       count == 1 ? "" : "s", without);
}

std::optional<std::string> needs_clearance(const Setup& setup) {
    if (auto reason = needs_links(setup)) return reason;
    const auto& links = setup.bodies->specified().links;
    if (std::ranges::any_of(links, [](const LinkBody& l) { return l.clearance_mm > 0.0; }))
        return std::nullopt;
    return "no clearance of a link is specified (machine.toml, [[link]] clearance)";
}

void judge_machine_collision(const Setup& setup, const Move& move, FindingLog& log) {
    for (const MachineContact& contact : move.machine) {
        if (!contact.touches) continue;
        Occurrence s = sighting_of(setup, move, contact,
                                   fmt::format("{} meets {}", contact.second, contact.first));
        s.rests_on = guesses_of_links(setup, move, contact);
        if (contact.amount_mm > 0.0) s.quantity = Quantity{"deep", contact.amount_mm, "mm"};
        s.hint = fmt::format(
            "It happens with the axes of the machine at {}. Lead the tool around it, or clamp the "
            "part elsewhere; if they touch by design: ignore in the machine file.",
            text_of(setup.kinematics->chain, contact.values));
        log.add("machine-collision", move, std::move(s));
    }
}

void judge_machine_near_miss(const Setup& setup, const Move& move, FindingLog& log) {
    for (const MachineContact& contact : move.machine) {
        if (contact.touches) continue;
        Occurrence s =
            sighting_of(setup, move, contact,
                        fmt::format("{} comes closer than {:.6g} mm to {}", contact.second,
                                    contact.clearance_mm, contact.first));
        s.rests_on = guesses_of_links(setup, move, contact);
        if (contact.amount_mm > 0.0) s.quantity = Quantity{"apart", contact.amount_mm, "mm"};
        log.add("machine-near-miss", move, std::move(s));
    }
}

}  // namespace ncsim::verify
