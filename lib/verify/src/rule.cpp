// SPDX-License-Identifier: GPL-3.0-or-later
//
// Table of all rules.
#include "ncsim/verify/rule.h"

#include "rule_table.h"

#include <array>
#include <vector>

namespace ncsim::verify {

namespace {

constexpr std::array kRules = {
    Rule{{"program-fault", Category::Program, Severity::Error,
          "A control stops at a block it cannot read, or reads it as something else.",
          "Correct the block as the message says."}},
    Rule{{"unsupported-word", Category::Program, Severity::Warning,
          "What is not understood is not verified either.",
          "Remove the word, or declare it harmless with --allow."}},
    Rule{{"suppression", Category::Program, Severity::Warning,
          "A comment that names no rule suppresses nothing.",
          "Name a rule or a category; ncsim rules lists them."}},

    Rule{{"rapid-in-material", Category::Collision, Severity::Error,
          "A rapid move through material breaks the tool, or worse.",
          "Retract before the move, or make it at feed."},
         true,
         needs_simulation,
         judge_rapid_in_material},
    Rule{{"non-cutting-contact", Category::Collision, Severity::Error,
          "A shank or a holder does not cut; it rubs, burns and breaks.",
          "Give the tool that much more stick-out or flute length, or cut less deep."},
         true,
         needs_bodies,
         judge_non_cutting},
    Rule{{"fixture-contact", Category::Collision, Severity::Error,
          "A tool in the vice or in a clamp costs a spindle.",
          "Move the fixture, or lead the tool around it."},
         true,
         needs_fixtures,
         judge_fixture_contact},
    Rule{{"fixture-clearance", Category::Collision, Severity::Error,
          "Fixtures never stand exactly where the drawing has them.",
          "Keep the stated distance from the fixture."},
         true,
         needs_fixtures,
         judge_fixture_clearance},
    Rule{
        {"machine-collision", Category::Collision, Severity::Error,
         "A head in the table costs a spindle, and months.",
         "Lead the tool around it, or clamp the part elsewhere; parts that touch by design: ignore "
         "in the machine file."},
        true,
        needs_links,
        judge_machine_collision},
    Rule{{"machine-near-miss", Category::Collision, Severity::Error,
          "Hoses, covers and cables are in no mesh.", "Keep the stated distance from the link."},
         true,
         needs_clearance,
         judge_machine_near_miss},

    Rule{{"below-stock", Category::Collision, Severity::Warning,
          "Below the stock is the table, or nothing; the program does not know.",
          "Cut no deeper than the stock, or say what is free below it (below_stock)."},
         false,
         needs_stock,
         judge_below_stock},

    Rule{{"over-travel", Category::Travel, Severity::Error,
          "The machine stops at its end switch, in the middle of the cut.",
          "Move the part on the table, or split the program."},
         false,
         needs_travel,
         judge_over_travel},
    Rule{{"rotary-over-travel", Category::Travel, Severity::Error,
          "A rotary axis stops at its end switch, or winds up its cables.",
          "Go the other way round, or turn the part on the table."},
         false,
         needs_rotary_travel,
         judge_rotary_over_travel},
    Rule{{"turns-while-clamped", Category::Travel, Severity::Error,
          "A clamp that holds an axis which turns is torn, or the drive stops.",
          "Let the axis go before it turns, with the M code of its clamp."},
         false,
         needs_nothing,
         judge_clamps},
    Rule{{"singular-pose", Category::Travel, Severity::Warning,
          "Near the axis of a joint a small tilt takes large turns, and the feed breaks down.",
          "Tilt the part on the table, or lead the tool around that direction."},
         false,
         needs_nothing,
         judge_singular_pose},
    Rule{{"unreachable-orientation", Category::Travel, Severity::Error,
          "A control stops where its machine cannot turn the tool.",
          "Tilt the part on the table, or take a machine that reaches it."}},
    Rule{{"path-deviation", Category::Travel, Severity::Error,
          "Without tip control an axis that turns takes the tip off its line.",
          "Switch tip control on, or let the post divide the move."},
         false,
         needs_path_deviation,
         judge_path_deviation},
    Rule{{"start-unknown", Category::Travel, Severity::Warning,
          "What a move from an unknown position meets is unknown.",
          "Move to X, Y and Z at rapid, clear of the part, before the first cut."},
         false,
         needs_nothing,
         judge_start_unknown},

    Rule{{"path-accuracy", Category::Program, Severity::Error,
          "What is not followed is not verified.",
          "Divide the move, or allow a larger --tolerance."},
         true,
         needs_simulation,
         judge_path_accuracy},

    Rule{{"spindle-off", Category::Process, Severity::Error,
          "A tool that stands still does not cut; it breaks.",
          "Start the spindle (S and M3) before the tool meets material."},
         true,
         needs_simulation,
         judge_spindle_off},
    Rule{{"spindle-reversed", Category::Process, Severity::Error,
          "A tool that turns the wrong way does not cut; it breaks.",
          "Use M3 for right-handed tools and M4 for left-handed ones."},
         true,
         needs_simulation,
         judge_spindle_reversed},
    Rule{{"spindle-limit", Category::Process, Severity::Error,
          "The control clamps the speed, or the tool flies apart.",
          "Program a speed within the limits of machine and tool."},
         false,
         needs_speed_limit,
         judge_spindle_limit},
    Rule{{"no-feed", Category::Process, Severity::Error,
          "Without a feed a control stops, or uses the one of the last program.",
          "Program F before or with the first feed move."},
         false,
         needs_nothing,
         judge_no_feed},
    Rule{{"feed-limit", Category::Process, Severity::Error,
          "The control clamps the feed, or the tool is overloaded.",
          "Program a feed within the limits of machine and tool."},
         false,
         needs_feed_limit,
         judge_feed_limit},
    Rule{{"plunge", Category::Process, Severity::Error,
          "A tool that does not cut at its centre cannot drill.",
          "Enter on a ramp or a helix, or into a drilled hole."},
         true,
         needs_simulation,
         judge_plunge},
    Rule{{"sideways-cut", Category::Process, Severity::Error,
          "Drills, taps, reamers and boring bars cut along their axis alone; sideways they break.",
          "Use a mill, or specify the kind of the tool (--tool T1=flat:D6)."},
         true,
         needs_simulation,
         judge_sideways},
    Rule{{"tap-feed", Category::Process, Severity::Error,
          "A tap that is not fed by its pitch strips the thread, or breaks.",
          "Feed pitch times speed: F = S x pitch, or G95 and the pitch."},
         true,
         needs_simulation,
         judge_tap_feed},
    Rule{{"tap-retract", Category::Process, Severity::Error,
          "A tap is screwed out as it was screwed in; pulled out, it takes the thread along.",
          "Tap with G84 (left-hand taps: G74)."},
         true,
         needs_simulation,
         judge_tap_retract},
    Rule{{"drill-depth", Category::Process, Severity::Error,
          "Flutes carry the chips out; a drill that is deeper than its flutes jams.",
          "Use a longer drill, or drill in steps from both sides."},
         true,
         needs_simulation,
         judge_drill_depth},
    Rule{{"bar-retract", Category::Process, Severity::Error,
          "A back-boring bar passes a narrower bore only with its edge turned and stepped aside.",
          "Stop with M19 and step aside before the way in and out, or use G87 with Q."},
         true,
         needs_simulation,
         judge_bar_retract},
    Rule{{"thread-retract", Category::Process, Severity::Error,
          "A thread mill that goes straight up in the thread tears off its crests.",
          "Lead the mill to the middle of the hole, then up (of a stud: away from it)."},
         true,
         needs_simulation,
         judge_thread_retract},
    Rule{{"countersink-depth", Category::Process, Severity::Error,
          "Above its cone a countersink has no edges; the hole becomes wider and its rim is torn.",
          "Go less deep, or use a countersink of a larger diameter."},
         true,
         needs_simulation,
         judge_countersink_depth},
    Rule{{"tip-cut", Category::Process, Severity::Error,
          "The flat tip of a chamfer mill has no edges; what it meets sideways breaks it.",
          "Lift the mill, or lead it farther out, so that its flank alone meets the edge."},
         true,
         needs_simulation,
         judge_tip_cut},
    Rule{{"depth-limit", Category::Process, Severity::Error,
          "Deeper than the tool is made for it bends, chatters and breaks.", "Cut in more passes."},
         true,
         needs_depth_limit,
         judge_depth},
    Rule{{"engagement-limit", Category::Process, Severity::Error,
          "More material on the way than the tool is made for overloads it.",
          "Take smaller steps sideways or in depth."},
         true,
         needs_engagement_limit,
         judge_engagement},
    Rule{{"removal-rate", Category::Process, Severity::Error,
          "More material per minute than the tool is made for overloads it, or the spindle.",
          "Lower the feed, or take smaller steps."},
         true,
         needs_removal_limit,
         judge_removal_rate},
    Rule{{"part-cut-free", Category::Process, Severity::Error,
          "What nothing holds any more flies, or jams under the tool.",
          "Leave tabs or a skin, or hold the piece."},
         true,
         needs_counting},
    Rule{{"gouge", Category::Process, Severity::Error,
          "Material that the design needs does not come back.",
          "Correct the path, the tool or its offset at the lines that cut there."},
         true,
         needs_design},
    Rule{{"excess", Category::Process, Severity::Error,
          "What is left beyond the design is not finished.",
          "Cut there, or compare with a design that has the allowance."},
         true,
         needs_design},
    Rule{{"air-cut", Category::Process, Severity::Note, "Feed moves that remove nothing cost time.",
          "Make them rapid moves, or drop them."},
         false,
         needs_air_cuts},

    Rule{{"tool-undefined", Category::SetUp, Severity::Warning,
          "A tool without a description cannot be simulated.",
          "Describe it in a comment, in a tool table or with --tool."}},
    Rule{{"wrong-length-offset", Category::SetUp, Severity::Error,
          "A tool that is longer than the control believes goes that much too deep.",
          "Give G43 the number of the tool (H), after every tool change."},
         false,
         needs_nothing,
         judge_length_offset},
    Rule{{"no-length-offset", Category::SetUp, Severity::Error,
          "Without its length the control drives the spindle where the tip should be.",
          "Program G43 with the number of the tool before it goes down."}},
    Rule{{"offset-undefined", Category::SetUp, Severity::Warning,
          "An unknown offset moves everything that follows.",
          "Specify the offset in the job, or set it in the program (G10)."}},
};

constexpr auto kInfos = [] {
    std::array<RuleInfo, kRules.size()> infos{};
    for (std::size_t i = 0; i < infos.size(); ++i)
        infos[i] = kRules[i].info;
    return infos;
}();

}  // namespace

std::span<const Rule> rule_table() {
    return kRules;
}

std::span<const RuleInfo> rules() {
    return kInfos;
}

const RuleInfo* find_rule(std::string_view id) {
    for (const RuleInfo& rule : kInfos) {
        if (rule.id == id) return &rule;
    }
    return nullptr;
}

std::vector<std::string_view> rules_named(std::string_view name) {
    std::vector<std::string_view> ids;
    for (const RuleInfo& rule : kInfos) {
        if (name == "all" || rule.id == name || name_of(rule.category) == name) {
            ids.push_back(rule.id);
        }
    }
    return ids;
}

}  // namespace ncsim::verify
