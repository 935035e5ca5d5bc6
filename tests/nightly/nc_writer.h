// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes blocks of an NC program and the motions of the blocks. All coordinates are integer numbers
// of ticks, the last decimal of the program, so words state the motions exactly and coincidences
// are exact.
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

/// Ticks of rotary axes per degree.
inline constexpr Ticks kDegree = 1000;

/// Returns `value` with at most `digits` decimals and without trailing zeros: "12.5".
std::string decimal(double value, int digits);

/// Positions of all axes, independent of the program zero.
struct Place {
    Triple x{};     ///< X, Y, Z
    Triple turn{};  ///< A, B, C
    bool operator==(const Place&) const = default;
};

/// Planes G17, G18, G19: seen from the positive end of the third axis, positive angles lead from
/// the first axis to the second (ISO 841).
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
    std::array<Ticks, 2> centre{};  ///< Relative to the start.
    /// Radius in place of the centre; negative for the longer arc.
    std::optional<Ticks> radius{};
    int turns = 0;  ///< The word P; 0: none.
};

struct Drilling {
    Plane plane = kPlanes[0];
    const char* code = "G81";
    std::string words{};  ///< Further words, as " P0.1".
    Ticks r = 0, bottom = 0;
    Ticks peck = 0;               ///< The word Q; 0: none.
    bool to_r = false;            ///< true: G99; false: G98.
    std::vector<Triple> holes{};  ///< Only the first two axes of the plane matter.
    /// Number of holes for incremental words. The distance between holes equals the distance of the
    /// first hole from the start.
    Ticks repeats = 1;
};

struct Move {
    Course course;
    std::size_t tool = 0;
    std::uint32_t line = 0;  ///< Line of the text, from 1.
};

class NcWriter {
public:
    NcWriter(bool inches, int decimals);

    double mm(Ticks t) const;
    Ticks ticks(double mm) const;

    /// Writes the head of a program, and the first rapid move, which starts at an unknown position
    /// and therefore leaves no trace.
    void begin(bool absolute_centres, const Triple& first);
    void end();

    const Place& at() const { return at_; }
    std::size_t tool() const { return tool_; }
    bool is_incremental() const { return incremental_; }
    /// Returns the coordinate in the frame of the program.
    Ticks named(std::size_t axis, Ticks coordinate) const { return coordinate - shift_[axis]; }

    void change_tool(std::size_t tool);
    void set_incremental(bool incremental);
    /// Writes G92, which gives the current position the coordinates `name`.
    void name_place(const Triple& name);

    /// Writes a straight move. Axes that do not move are written if `repeats` is true for them.
    /// `more` are further words.
    void straight(const Place& to, bool rapid, const std::array<bool, 3>& repeats,
                  const std::string& more);
    void arc(const ArcMove& arc, const std::array<bool, 3>& repeats, const std::string& more);
    void drill(const Drilling& drilling);

    Course way(const Place& to) const;
    /// Returns nothing if no circle of this radius passes through both ends, or if the radius is
    /// close to this limit.
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
