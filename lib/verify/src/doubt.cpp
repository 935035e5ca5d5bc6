// SPDX-License-Identifier: GPL-3.0-or-later
//
// Table of the reasons for doubt.
#include "ncsim/verify/doubt.h"

#include <algorithm>
#include <array>

namespace ncsim::verify {

namespace {

constexpr auto kReasons = std::to_array<ReasonInfo>({
    {"stock-guess", "Nobody said what is cut; the block was derived from the moves.",
     "--stock, or a comment such as (STOCK/BLOCK,…)"},
    {"tool-guess", "Nobody said what a tool looks like, or not all of it.",
     "--tool, --tool-table, or a comment"},
    {"flutes-guess", "A tool cuts higher than anybody said that its flutes reach.",
     "the length of the flutes, as in --tool T1=flat:D6:L22"},
    {"units-guess", "Neither G20 nor G21 stands before the first length.",
     "--units mm or --units inch"},
    {"start-unknown", "Nobody said where the tool stands when the program starts.",
     "--start X,Y,Z, or start in the job file"},
    {"offset-guess", "Nobody said where a coordinate system lies in the machine.",
     "[offsets] in the job or machine file"},
    {"length-offset", "Nobody can tell whether the length of a tool is the one that counts.",
     "G43 with the number of the tool, or lengths in a tool table"},
    {"radius-guess", "Nobody said how wide the cutter of a compensated path is.",
     "the tool of the D number, with its diameter"},
    {"kinematics-guess", "Nobody said how the machine turns.",
     "preset, pivot and [offsets] in the machine file, or its [[link]]s"},
    {"reading-guess", "A block can be read in more than one way.",
     "write it as the control wants it"},
    {"control-guess",
     "Controls execute the program in different ways, and neither the user nor the program names "
     "its control.",
     "--dialect, the control of the machine"},
    {"distance-guess", "Neither G90 nor G91 stands before the first move.",
     "G90 or G91 in the program, or --dialect of a control that starts with G90"},
    {"variable-unknown", "A variable decides that neither the program nor the job sets.",
     "[variables] in the job file, or --variable #500=1"},
    {"block-delete", "The verdict depends on the switch for blocks that start with '/'.",
     "--block-delete on or --block-delete off"},
    {"decimal-point", "The verdict depends on what numbers without a decimal point mean.",
     "--increments on or --increments off, or points"},
    {"path-blending", "Corners may be cut by more than there is to a fixture or the design.",
     "a smaller P of G64"},
    {"left-out", "Words or lines were left out, because nobody knows what they do.",
     "--allow, if they are harmless"},
    {"not-simulated", "Moves were not simulated, so nothing is known of them.",
     "what the message says is missing"},
    {"nothing-removed", "The program takes nothing away: is the stock where it should be?",
     "--stock, and the offsets it lies in"},
    {"uncertain-contact", "Something touches within the accuracy of the tools.",
     "a finer --tool-tolerance"},
    {"probe-guess", "A probe decides what follows, and nobody knows what it met.",
     "nothing: accept it, if the part stands where it should"},
    {"spindle-after-stop", "M0 may have stopped the spindle, and nothing starts it again.",
     "M3 after the stop, or --dialect, if the control goes on"},
    {"below-stock", "A tool goes below the stock, where the table may be.",
     "below_stock in the machine file, or the table as a fixture"},
    {"rapid-path", "Rapid moves go straight or axis by axis, and the verdict depends on it.",
     "--rapid linear or --rapid dog-leg"},
    {"contradiction", "Two sources specify different values for one thing.",
     "one value: correct the other source, or remove it"},
    {"file-origin",
     "A file was written by a run that made assumptions, or does not record whether it did.",
     "a file from a run with everything specified"},
    {"told-not-used", "Something was told that the program does not use.",
     "take it away, or correct it"},
    {"required", "Something was asked for that nobody told.", "what --require names"},
});

}  // namespace

std::span<const ReasonInfo> reasons() {
    return kReasons;
}

const ReasonInfo* find_reason(std::string_view id) {
    const auto* found = std::ranges::find(kReasons, id, &ReasonInfo::id);
    return found == kReasons.end() ? nullptr : found;
}

}  // namespace ncsim::verify
