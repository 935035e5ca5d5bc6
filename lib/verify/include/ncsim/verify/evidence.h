// SPDX-License-Identifier: GPL-3.0-or-later
//
// Observations of a tile of the part. The Verifier of a tile observes the contacts of this tile
// only and judges nothing; it records observations step by step. The observations of all tiles
// together equal the observations of a run with the whole part, because each question is whether
// any material is met, how much, or how far: a contact in one tile is a contact, volumes add up,
// and the largest length counts.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/tile_number.h"
#include "ncsim/machine/chain.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::verify {

/// Kind of an observation. The observations of a step are sorted in this order.
enum class Subject : std::uint8_t {
    FeedCut,   ///< Cutter meets material at feed; `value`: mm³, if measured.
    RapidCut,  ///< Cutter meets material at rapid; `value`: mm³, if measured.
    /// Material removed by the step, if all volumes are measured; `value`: mm³; `certain`: the step
    /// touches material if the volume is positive.
    Removed,
    Body,  ///< Contact of piece `index` of the tool; `value`: required raise, mm.
    /// Contact of the core that does not cut; `value`: length of the descent above material, mm.
    Core,
    TooHigh,  ///< Contact of the cutter above the depth limit; `value`: excess, mm.
    /// Contact of the flutes above the certain flute length; `value` as for TooHigh.
    UnspecifiedFlutes,
    Wall,     ///< Contact of a thread mill with the wall of its thread at the start of the step.
    Mouth,    ///< The column above the tip; `value`: Z of the highest material in the column, mm.
    Tip,      ///< Contact of a flat tip that does not cut.
    Fixture,  ///< Contact of fixture `index` with piece `other` of the tool.
    /// Contact of pair `index` of a MachineScene; `value`: penetration or distance, mm.
    Link,
};

/// Observation of a tile in a step.
struct Observation {
    /// Value of `step` for the end of the motion.
    static constexpr std::uint64_t kAtEnd = ~std::uint64_t{0};

    std::uint64_t motion = 0;  ///< Number of the motion from 1, in the order of execution.
    /// Number of the step in the motion from 1; 0: before the first step.
    std::uint64_t step = 0;
    Subject subject = Subject::FeedCut;
    std::uint32_t index = 0, other = 0;
    bool touches = true;        ///< False: rounding only, or only the clearance is violated.
    bool certain = false;       ///< True for every accuracy of the tool.
    bool assumed = false;       ///< The shape of a body in contact is not fully specified.
    std::optional<Vec3> point;  ///< Common point of both bodies; mm, W.
    /// If there are several points, the point with the lowest rank counts.
    std::uint32_t rank = 0;
    Box box;  ///< Box around the contact; mm, W.
    /// Measured value. A volume is the contribution of this tile to the sum; the contribution can
    /// be negative.
    std::optional<double> value;
    /// Positions of the joints at the contact, machine coordinates.
    std::optional<machine::Values> values;
    std::vector<Box> places;  ///< Boxes in which the contact is open; mm, W.

    bool operator==(const Observation&) const = default;
};

using Evidence = std::vector<Observation>;

/// Share of the part that a Verifier observes. Default: the whole part. With `tile`: one tile; the
/// Verifier collects evidence and judges nothing. With `evidence`: no part; the Verifier judges the
/// evidence of all tiles.
struct Share {
    std::optional<cda::TileNumber> tile;
    std::shared_ptr<const Evidence> evidence;  ///< Result of together() for all tiles.
};

/// Merges the evidence of all tiles, in the order of the program.
/// Requires: `tiles` is in the order of the tiles.
Evidence together(std::vector<Evidence> tiles);

/// Formats `evidence` as text, one observation a line. evidence_from() restores all numbers to the
/// last bit.
std::string bytes_of(const Evidence& evidence);
/// Parses the text that bytes_of() wrote.
/// Throws: std::invalid_argument if the text is malformed.
Evidence evidence_from(std::string_view bytes);

}  // namespace ncsim::verify
