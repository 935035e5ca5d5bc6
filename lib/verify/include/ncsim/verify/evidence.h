// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a tile of the part was seen to meet. A Verifier of a tile asks its own part alone and judges
// nothing: it writes down what it saw, step by step. What all tiles saw together is what one that
// had the whole part would have seen, for each question is whether anything of the part is met, how
// much, or how far: a contact of one tile is a contact, volumes add up, of lengths the largest
// counts.
#pragma once

#include "ncsim/cda/tile_number.h"
#include "ncsim/cda/vec.h"
#include "ncsim/machine/chain.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::verify {

/// What was looked at. Those of a step stand in this order.
enum class Subject : std::uint8_t {
    FeedCut,       ///< What cuts, at feed; `value`: mm³, where it was measured.
    RapidCut,      ///< What cuts, at rapid; the same.
    Removed,       ///< What the step took away, where all of it is measured; `value`: mm³;
                   ///< `certain`: it touches if that is more than nothing.
    Body,          ///< Piece `index` of the tool; `value`: the raise that it needs, mm.
    Core,          ///< What does not cut; `value`: how far down it has material under it, mm.
    TooHigh,       ///< What cuts above the limit of depth; `value`: by how much, mm.
    UntoldFlutes,  ///< The same of flutes that nobody told.
    Wall,          ///< A thread mill at the start of the step: the wall of its thread.
    Mouth,         ///< The column above the tip; `value`: Z of the highest material in it, mm.
    Tip,           ///< A flat tip that does not cut.
    Fixture,       ///< Fixture `index` and piece `other` of the tool.
    Link,          ///< Pair `index` of a MachineScene; `value`: deep or apart, mm.
};

struct Observation {
    /// Of `step`: at the end of the motion.
    static constexpr std::uint64_t kAtEnd = ~std::uint64_t{0};

    std::uint64_t motion = 0;  ///< From 1, in the order of execution.
    std::uint64_t step = 0;    ///< Of the motion, from 1; 0: before them.
    Subject subject = Subject::FeedCut;
    std::uint32_t index = 0, other = 0;
    bool touches = true;             ///< Else it is rounding, or only a clearance is not kept.
    bool certain = false;            ///< Whatever the accuracy of the tool.
    bool assumed = false;            ///< Nobody told all of what meets there.
    std::optional<cda::Vec3> point;  ///< In both; W, mm.
    std::uint32_t rank = 0;          ///< Of several points the one of the lowest rank counts.
    cda::Box box;                    ///< Around the contact; W, mm.
    /// Volumes are what the tile adds to that of all of them, less than nothing maybe.
    std::optional<double> value;
    std::optional<machine::Values> values;  ///< Of the joints then, machine coordinates.
    std::vector<cda::Box> places;           ///< Where it is open; W, mm.

    bool operator==(const Observation&) const = default;
};

using Evidence = std::vector<Observation>;

/// Which share of a part a Verifier sees. All of it; or one tile, whose evidence it collects, and
/// judges nothing; or nothing, since all tiles were seen before.
struct Share {
    std::optional<cda::TileNumber> tile;
    std::shared_ptr<const Evidence> evidence;  ///< together() of all tiles.
};

/// What all tiles saw, in the order of the program; `tiles` in theirs.
Evidence together(std::vector<Evidence> tiles);

/// As text, a line each. Numbers come back as they are, to the last bit.
std::string bytes_of(const Evidence& evidence);
/// And back. Throws std::invalid_argument if it is none.
Evidence evidence_from(std::string_view bytes);

}  // namespace ncsim::verify
