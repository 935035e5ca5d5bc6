// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keys of tools in job files, for reading and writing.
#pragma once

#include "ncsim/toolpath/tool_spec.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::setup {

/// Versions of job files. Version 1 does not record assumptions.
inline constexpr std::int64_t kVersionWithoutOrigin = 1, kJobVersion = 2;

/// Kinds of tools by their names.
inline constexpr std::pair<std::string_view, toolpath::ToolKind> kKindKeys[] = {
    {"flat", toolpath::ToolKind::FlatEndMill},
    {"ball", toolpath::ToolKind::BallEndMill},
    {"bull", toolpath::ToolKind::BullNoseEndMill},
    {"face", toolpath::ToolKind::FaceMill},
    {"v", toolpath::ToolKind::VCutter},
    {"chamfer", toolpath::ToolKind::ChamferMill},
    {"countersink", toolpath::ToolKind::Countersink},
    {"drill", toolpath::ToolKind::Drill},
    {"taper", toolpath::ToolKind::TaperedEndMill},
    {"slot", toolpath::ToolKind::SlotMill},
    {"dovetail", toolpath::ToolKind::DovetailMill},
    {"lollipop", toolpath::ToolKind::LollipopMill},
    {"corner", toolpath::ToolKind::CornerRoundingMill},
    {"tap", toolpath::ToolKind::Tap},
    {"reamer", toolpath::ToolKind::Reamer},
    {"boring-bar", toolpath::ToolKind::BoringBar},
    {"thread", toolpath::ToolKind::ThreadMill},
    {"form", toolpath::ToolKind::Other}};

/// A length or an angle of a tool, and its key.
struct NamedValue {
    const char* name;
    std::optional<double> toolpath::ToolSpec::*value;
};
inline constexpr NamedValue kValueKeys[] = {{"diameter", &toolpath::ToolSpec::diameter},
                                            {"corner_radius", &toolpath::ToolSpec::corner_radius},
                                            {"tip_diameter", &toolpath::ToolSpec::tip_diameter},
                                            {"angle", &toolpath::ToolSpec::angle},
                                            {"taper", &toolpath::ToolSpec::taper},
                                            {"length", &toolpath::ToolSpec::length},
                                            {"pitch", &toolpath::ToolSpec::pitch},
                                            {"neck_diameter", &toolpath::ToolSpec::neck_diameter},
                                            {"neck_length", &toolpath::ToolSpec::neck_length},
                                            {"shank_diameter", &toolpath::ToolSpec::shank_diameter},
                                            {"shank_length", &toolpath::ToolSpec::shank_length},
                                            {"stick_out", &toolpath::ToolSpec::stick_out}};

/// Segments above the flutes, and their key.
struct NamedSegments {
    const char* name;
    std::vector<toolpath::ToolSegment> toolpath::ToolSpec::*value;
};
inline constexpr NamedSegments kSegmentKeys[] = {{"shaft", &toolpath::ToolSpec::shaft},
                                                 {"holder", &toolpath::ToolSpec::holder}};

}  // namespace ncsim::setup
