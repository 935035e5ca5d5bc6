// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes blocks of an NC program and, beside them, what they do. All coordinates are whole numbers
// of ticks, the last decimal that the program writes, so that a word says exactly what its motion
// does, and coincidences are coincidences.
#pragma once

#include "nightly/course.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::nightly {

using Ticks = std::int64_t;
using Triple = std::array<Ticks, 3>;

/// Ticks of rotary axes in a degree.
inline constexpr Ticks kDegree = 1000;

/// "12.5": up to so many digits behind the point, no zeros at the end.
std::string decimal(double value, int digits);

/// Where all axes are, whatever the program calls that place.
struct Place {
    Triple x{};     ///< X, Y, Z
    Triple turn{};  ///< A, B, C
    bool operator==(const Place&) const = default;
};

/// G17, G18, G19: seen from the positive end of the third axis, the first turns into the second
/// (ISO 841).
struct Plane {
    const char* code;
    std::size_t first, second, third;
};
inline constexpr std::array<Plane, 3> kPlanes{
    {{"G17", 0, 1, 2}, {"G18", 2, 0, 1}, {"G19", 1, 2, 0}}};

struct ArcMove {
    Plane plane = kPlanes[0];
    bool counter_clockwise = true;
    Place to;                       ///< Equal to the start in the plane: a full circle.
    std::array<Ticks, 2> centre{};  ///< Seen from the start.
    /// Instead of the centre; negative for the longer way round.
    std::optional<Ticks> radius{};
    int turns = 0;  ///< The word P; 0: none.
};

struct Drilling {
    Plane plane = kPlanes[0];
    const char* code = "G81";
    std::string words{};  ///< More of them, as " P0.1".
    Ticks r = 0, bottom = 0;
    Ticks peck = 0;               ///< The word Q; 0: none.
    bool to_r = false;            ///< G99, else G98.
    std::vector<Triple> holes{};  ///< Only the first two axes of the plane count.
    /// With incremental words: so many holes, each as far from the one before as the first from
    /// here.
    Ticks repeats = 1;
};

struct Move {
    Course course;
    std::size_t tool = 0;
    std::uint32_t line = 0;  ///< Of the text, from 1.
};

class NcWriter {
public:
    NcWriter(bool inches, int decimals);

    double mm(Ticks t) const;
    Ticks ticks(double mm) const;

    /// The head of a program, and the first rapid move, which comes from an unknown place and so
    /// leaves no trace.
    void begin(bool absolute_centres, const Triple& first);
    void end();

    const Place& at() const { return at_; }
    std::size_t tool() const { return tool_; }
    bool is_incremental() const { return incremental_; }
    /// What the program calls a coordinate.
    Ticks named(std::size_t axis, Ticks coordinate) const { return coordinate - shift_[axis]; }

    void change_tool(std::size_t tool);
    void set_incremental(bool incremental);
    /// G92: from now on the place of now has this name.
    void name_place(const Triple& name);

    /// Axes that do not move are named where `repeats` says so. `more` are other words.
    void straight(const Place& to, bool rapid, const std::array<bool, 3>& repeats,
                  const std::string& more);
    void arc(const ArcMove& arc, const std::array<bool, 3>& repeats, const std::string& more);
    void drill(const Drilling& drilling);

    Course way(const Place& to) const;
    /// None if no circle of that radius goes through both ends, or hardly one.
    std::optional<Course> way(const ArcMove& arc) const;

    const std::string& text() const { return text_; }
    const std::vector<Move>& moves() const { return moves_; }

private:
    void block(const std::string& text);
    std::string word(char letter, Ticks t) const;
    std::string words_to(const Place& to, const std::array<bool, 3>& repeats) const;
    void select(const Plane& plane);
    void follow(const Course& course, const Place& to);
    void follow_hole(const Drilling& drilling, const Triple& step, Ticks clear);
    Axes axes(const Place& place) const;

    double unit_mm_, ticks_in_unit_;
    int decimals_;
    std::string text_;
    std::uint32_t line_ = 0;
    std::vector<Move> moves_;
    Place at_;
    Triple shift_{};
    std::size_t tool_ = 0;
    std::string plane_ = "G17";
    bool inches_, incremental_ = false, absolute_centres_ = false;
};

}  // namespace ncsim::nightly
