// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words of blocks, and motions of blocks.
#include "nightly/nc_writer.h"

#include <algorithm>
#include <cstdio>

namespace ncsim::nightly {

namespace {

constexpr std::array<char, 3> kLinear{'X', 'Y', 'Z'};
constexpr std::array<char, 3> kRotary{'A', 'B', 'C'};
constexpr std::array<char, 3> kCentre{'I', 'J', 'K'};

double power_of_ten(int n) {
    double p = 1.0;
    for (int i = 0; i < n; ++i)
        p *= 10.0;
    return p;
}

std::string word_of(char letter, const std::string& number) {
    std::string word(1, ' ');
    word += letter;
    return word += number;
}

}  // namespace

std::string decimal(double value, int digits) {
    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.*f", digits, value);
    std::string text = buffer.data();
    if (digits > 0) text.erase(text.find_last_not_of('0') + 1);
    if (digits == 0) text += '.';
    return text == "-0." ? "0." : text;
}

NcWriter::NcWriter(bool inches, int decimals)
    : unit_mm_(inches ? 25.4 : 1.0),
      ticks_in_unit_(power_of_ten(decimals)),
      decimals_(decimals),
      inches_(inches) {}

double NcWriter::mm(Ticks t) const {
    return static_cast<double>(t) / ticks_in_unit_ * unit_mm_;
}

Ticks NcWriter::ticks(double mm) const {
    return static_cast<Ticks>(std::llround(mm / unit_mm_ * ticks_in_unit_));
}

Axes NcWriter::axes(const Place& place) const {
    Axes axes;
    for (std::size_t i = 0; i < 3; ++i) {
        axes.x[i] = mm(place.x[i]);
        axes.turn[i] = static_cast<double>(place.turn[i]) / kDegree;
    }
    return axes;
}

// --- Text --------------------------------------------------------------------------------

void NcWriter::block(const std::string& text) {
    text_ += text;
    text_ += '\n';
    ++line_;
}

std::string NcWriter::word(char letter, Ticks t) const {
    return word_of(letter, decimal(static_cast<double>(t) / ticks_in_unit_, decimals_));
}

std::string NcWriter::words_to(const Place& to, const std::array<bool, 3>& repeats) const {
    std::string words;
    for (std::size_t i = 0; i < 3; ++i) {
        if (to.x[i] == at_.x[i] && !repeats[i]) continue;
        words += word(kLinear[i], incremental_ ? to.x[i] - at_.x[i] : named(i, to.x[i]));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (to.turn[i] == at_.turn[i]) continue;
        const Ticks t = incremental_ ? to.turn[i] - at_.turn[i] : to.turn[i];
        words += word_of(kRotary[i], decimal(static_cast<double>(t) / kDegree, 3));
    }
    return words;
}

void NcWriter::select(const Plane& plane) {
    if (plane_ == plane.code) return;
    plane_ = plane.code;
    block(plane.code);
}

void NcWriter::begin(bool absolute_centres, const Triple& first) {
    block(std::string(inches_ ? "G20" : "G21") + " G90 G17 G40 G49 G80 G94");
    absolute_centres_ = absolute_centres;
    block(absolute_centres ? "G90.1" : "G91.1");
    block("T1 M6");
    block("S1000 M3");
    block("G0" + words_to({first, {}}, {true, true, true}));
    at_.x = first;
}

void NcWriter::end() {
    block("M30");
}

void NcWriter::change_tool(std::size_t tool) {
    tool_ = tool;
    std::string text(1, 'T');
    text += std::to_string(tool + 1);
    block(text += " M6");
}

void NcWriter::set_incremental(bool incremental) {
    if (incremental_ == incremental) return;
    incremental_ = incremental;
    block(incremental ? "G91" : "G90");
}

void NcWriter::name_place(const Triple& name) {
    std::string text = "G92";
    for (std::size_t i = 0; i < 3; ++i) {
        shift_[i] = at_.x[i] - name[i];
        text += word(kLinear[i], name[i]);
    }
    block(text);
}

// --- Motions -----------------------------------------------------------------------------

void NcWriter::follow(const Course& course, const Place& to) {
    moves_.push_back({course, tool_, line_});
    at_ = to;
}

Course NcWriter::way(const Place& to) const {
    return Course::straight(axes(at_), axes(to));
}

void NcWriter::straight(const Place& to, bool rapid, const std::array<bool, 3>& repeats,
                        const std::string& more) {
    const Course course = way(to);
    block((rapid ? "G0" : "G1") + words_to(to, repeats) + more);
    follow(course, to);
}

std::optional<Course> NcWriter::way(const ArcMove& arc) const {
    const std::size_t first = arc.plane.first;
    const std::size_t second = arc.plane.second;
    std::array<double, 2> centre{mm(at_.x[first] + arc.centre[0]),
                                 mm(at_.x[second] + arc.centre[1])};
    if (arc.radius) {
        // Two circles pass through both ends. The arc in the given direction is short on one circle
        // and long on the second; a negative R selects the long arc.
        const double r = mm(std::abs(*arc.radius));
        const double dx = mm(arc.to.x[first]) - mm(at_.x[first]);
        const double dy = mm(arc.to.x[second]) - mm(at_.x[second]);
        const double chord = std::sqrt(dx * dx + dy * dy);
        if (chord > 1.98 * r || chord < 0.02 * r) return std::nullopt;
        const double height = std::sqrt(r * r - chord * chord / 4);
        // A short counter-clockwise arc has its centre on the left of the chord.
        const bool is_left = arc.counter_clockwise == (*arc.radius > 0);
        const double left = is_left ? height / chord : -height / chord;
        centre = {mm(at_.x[first]) + dx / 2 - left * dy, mm(at_.x[second]) + dy / 2 + left * dx};
    }
    return Course::arc(axes(at_), axes(arc.to), first, second, centre, arc.counter_clockwise,
                       std::max(0, arc.turns - 1));
}

void NcWriter::arc(const ArcMove& arc, const std::array<bool, 3>& repeats,
                   const std::string& more) {
    const std::optional<Course> course = way(arc);
    if (!course) return;
    select(arc.plane);
    std::string text = arc.counter_clockwise ? "G3" : "G2";
    text += words_to(arc.to, repeats);
    if (arc.radius) {
        text += word('R', *arc.radius);
    } else {
        for (std::size_t i = 0; i < 2; ++i) {
            const std::size_t axis = i == 0 ? arc.plane.first : arc.plane.second;
            const Ticks centre = at_.x[axis] + arc.centre[i];
            text += word(kCentre[axis], absolute_centres_ ? named(axis, centre) : arc.centre[i]);
        }
    }
    if (arc.turns > 0) text += word_of('P', std::to_string(arc.turns));
    block(text + more);
    follow(*course, arc.to);
}

void NcWriter::drill(const Drilling& d) {
    const std::size_t depth = d.plane.third;
    const Ticks initial = at_.x[depth];
    const Ticks clear = d.to_r ? d.r : std::max(initial, d.r);
    select(d.plane);
    for (std::size_t hole = 0; hole < d.holes.size(); ++hole) {
        Triple step{};
        std::string where;
        for (const std::size_t axis : {d.plane.first, d.plane.second}) {
            step[axis] = d.holes[hole][axis] - at_.x[axis];
            where +=
                word(kLinear[axis], incremental_ ? step[axis] : named(axis, d.holes[hole][axis]));
        }
        if (hole == 0) {
            std::string text = d.to_r ? "G99 " : "G98 ";
            text += d.code;
            text += where;
            text += word(kLinear[depth], incremental_ ? d.bottom - d.r : named(depth, d.bottom));
            text += word('R', incremental_ ? d.r - initial : named(depth, d.r));
            if (d.peck > 0) text += word('Q', d.peck);
            if (d.repeats > 1) text += word_of('L', std::to_string(d.repeats));
            block(text += d.words);
        } else {
            block(where.substr(1));
        }
        for (Ticks i = 0; i < d.repeats; ++i)
            follow_hole(d, step, clear);
    }
    block("G80");
}

// Follows RS274/NGC, 3.5.16: moves to the hole at the larger of the current height and R, then to
// R, down, and out. Pecks between R and the bottom stay on the same line.
void NcWriter::follow_hole(const Drilling& d, const Triple& step, Ticks clear) {
    const std::size_t depth = d.plane.third;
    Place to = at_;
    const auto go = [&] {
        if (to != at_) follow(way(to), to);
    };
    to.x[depth] = std::max(to.x[depth], d.r);
    go();
    for (std::size_t i = 0; i < 3; ++i)
        to.x[i] += step[i];
    go();
    for (const Ticks height : {d.r, d.bottom, clear}) {
        to.x[depth] = height;
        go();
    }
}

}  // namespace ncsim::nightly
