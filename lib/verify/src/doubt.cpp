// SPDX-License-Identifier: GPL-3.0-or-later
//
// Table of the reasons for doubt.
#include "ncsim/verify/doubt.h"

#include <algorithm>
#include <array>

namespace ncsim::verify {

namespace {

constexpr std::string_view kSettingNotUsed = "setting-not-used";

constexpr auto kReasons = std::to_array<ReasonInfo>({
    {"stock-guess", "The stock is not specified; the block was derived from the moves.",
     "specify --stock, or a comment such as (STOCK/BLOCK,…)"},
    {"tool-guess", "The shape of a tool is not specified, or only in part.",
     "specify it with --tool or --tool-table, or in a comment"},
    {"flutes-guess", "A tool cuts higher than its flutes are known to reach.",
     "specify the length of the flutes, as in --tool T1=flat:D6:L22"},
    {"units-guess", "Neither G20 nor G21 stands before the first length.",
     "specify --units mm or --units inch"},
    {"start-unknown", "The position of the tool at the start of the program is unknown.",
     "specify --start X,Y,Z, or start in the job file"},
    {"offset-guess", "The position of a coordinate system in the machine is not specified.",
     "specify [offsets] in the job or machine file"},
    {"length-offset", "The length offset may not be that of the tool in the spindle.",
     "program G43 with the number of the tool, or specify lengths in a tool table"},
    {"radius-guess", "The cutter diameter of a compensated path is not specified.",
     "specify the tool of the D number with its diameter"},
    {"kinematics-guess", "The rotary axes of the machine are not specified.",
     "specify preset, pivot and [offsets] in the machine file, or its [[link]]s"},
    {"reading-guess", "A block can be read in more than one way.",
     "write the block as the control requires it"},
    {"control-guess",
     "Controls execute the program in different ways, and neither the user nor the program names "
     "its control.",
     "specify --dialect, the control of the machine"},
    {"distance-guess", "Neither G90 nor G91 stands before the first move.",
     "program G90 or G91, or specify --dialect of a control that starts with G90"},
    {"variable-unknown", "The program depends on a variable that neither it nor the job sets.",
     "specify [variables] in the job file, or --variable #500=1"},
    {"block-delete", "The verdict depends on the switch for blocks that start with '/'.",
     "specify --block-delete on or --block-delete off"},
    {"decimal-point",
     "The verdict or the part depends on the meaning of numbers without a decimal point.",
     "specify --increments on or --increments off, or write decimal points"},
    {"path-blending", "Corners may be rounded by more than the space to a fixture or the design.",
     "program a smaller P of G64"},
    {"left-out", "Words or lines with an unknown meaning were left out.",
     "specify --allow if they are harmless"},
    {"not-simulated", "Moves were not simulated, so their effect is unknown.",
     "specify what the message names"},
    {"nothing-removed", "The program removes nothing; the stock may be in the wrong place.",
     "correct --stock, or the offsets of its coordinate system"},
    {"uncertain-contact", "A contact is within the accuracy of the tools.",
     "specify a finer --tool-tolerance"},
    {"probe-guess", "Moves depend on what a probe meets, which is unknown.",
     "accept the doubt if the part is in its place"},
    {"spindle-after-stop", "M0 may have stopped the spindle, and no block starts it again.",
     "program M3 after the stop, or specify --dialect if the control goes on"},
    {"below-stock", "A tool goes below the stock, where the table may be.",
     "specify below_stock in the machine file, or the table as a fixture"},
    {"rapid-path", "The verdict depends on the path of rapid moves, straight or axis by axis.",
     "specify --rapid linear or --rapid dog-leg"},
    {"contradiction", "Two sources specify different values for one thing.",
     "correct or remove one of the two"},
    {"file-origin",
     "A file was written by a run that made assumptions, marks a value as assumed, or does not "
     "record whether it did.",
     "measure what is marked as assumed, and use files of runs with everything specified"},
    {kSettingNotUsed, "The program does not use a setting that is specified.",
     "remove or correct the setting"},
    {"required", "A setting is required and not specified.", "specify what --require names"},
});

}  // namespace

std::span<const ReasonInfo> reasons() {
    return kReasons;
}

const ReasonInfo* find_reason(std::string_view id) {
    if (id == "told-not-used") id = kSettingNotUsed;  // name before 1.0
    const auto* found = std::ranges::find(kReasons, id, &ReasonInfo::id);
    return found == kReasons.end() ? nullptr : found;
}

}  // namespace ncsim::verify
