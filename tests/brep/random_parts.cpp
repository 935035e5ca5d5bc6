// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writers of random programs: common operations, rasters, and moves with B.
#include "brep/random_parts.h"

#include "brep/random_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ncsim::brep::test {

namespace {

class Writer : RandomProgram {
public:
    explicit Writer(std::uint64_t seed)
        : RandomProgram(seed),
          has_helices_(seed >= kWithHelices),
          has_slopes_(seed >= kWithSlopes) {}

    std::string write() {
        text_ = std::string(kRandomTools) + "(STOCK/BLOCK,80.,60.,15.,0.,0.,15.)\nG21 G90 G17\n";
        choose_grid();
        const int operations = has_slopes_ ? pick(1, 4) : pick(2, 9);
        for (int i = 0; i < operations; ++i)
            operation();
        return text_ + "M30\n";
    }

private:
    void operation() {
        const int tool = has_slopes_ ? pick(2, 4) : has_helices_ ? pick(1, 2) : pick(1, 7);
        line(fmt::format("T{} M6 S5000 M3", tool));
        x_ = length(0, 80), y_ = length(0, 60);
        is_ramp_ = has_slopes_ || pick(0, 2) == 0;
        const double depth = tool == 5 ? length(1, 4) : tool > 5 ? length(2, 20) : length(1, 8);
        line(fmt::format("G0 X{:.3f} Y{:.3f} Z5", x_, y_));
        line(fmt::format("G1 Z{:.3f} F300", -depth));
        z_ = -depth;
        const int moves = tool > 5 ? 0 : pick(0, 5);
        for (int i = 0; i < moves; ++i) {
            if (pick(0, 1) == 0) {
                straight(is_ramp_);
            } else {
                arc_down();
            }
        }
        line("G0 Z5");
    }

    void arc_down() {
        const auto next = next_arc();
        if (!next) return;
        std::string down;
        if (has_helices_ && pick(0, 1) == 0) {
            z_ = std::max(-12.0, z_ - length(0, 3));
            down = fmt::format(" Z{:.3f}", z_);
        }
        arc(*next, down);
    }

    bool has_helices_, has_slopes_;
    bool is_ramp_ = false;  // straight moves go up and down
};

// Program of a ball that moves back and forth over a wavy surface, as in finishing.
class Raster {
public:
    explicit Raster(std::uint64_t seed) : random_(seed) {}

    std::string write() {
        const double diameter = 2.0 * pick(1, 4), along = diameter * tenths(1, 5);
        const double across = diameter * tenths(1, 5);
        const int moves = pick(4, 9), rows = pick(3, 7);
        amplitude_ = diameter * tenths(1, 4);
        length_ = diameter * tenths(20, 60);
        phase_x_ = tenths(0, 63), phase_y_ = tenths(0, 63);
        // The rows end slightly beyond the stock, within the stock, or at its edge.
        const double margin = pick(0, 2) == 0 ? -0.1 * diameter : pick(0, 1) == 0 ? diameter : 0.0;
        const double x = moves * along, y = rows * across;
        std::string text = fmt::format(
            "(T1 D={} CR={} - ball end mill)\n"
            "(STOCK/BLOCK,{:.3f},{:.3f},30.,{:.3f},{:.3f},30.)\nG21 G90 G17\nT1 M6 S5000 M3\n",
            diameter, 0.5 * diameter, x + 2.0 * margin, y + 2.0 * margin, margin, margin);
        text += fmt::format("G0 X0 Y0 Z10\nG1 Z{:.3f} F600\n", height(0.0, 0.0));
        for (int row = 0; row <= rows; ++row) {
            for (int i = 0; i <= moves; ++i) {
                const double at = along * (row % 2 == 0 ? i : moves - i), to = across * row;
                text += fmt::format("X{:.3f} Y{:.3f} Z{:.3f}\n", at, to, height(at, to));
            }
        }
        return text + "G0 Z10\nM30\n";
    }

private:
    int pick(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
    }
    double tenths(int low, int high) { return 0.1 * pick(low, high); }
    double height(double x, double y) const {
        return -1.5 * amplitude_ +
               amplitude_ * std::sin(x / length_ + phase_x_) * std::cos(y / length_ + phase_y_);
    }

    std::mt19937_64 random_;
    double amplitude_ = 0.0, length_ = 1.0, phase_x_ = 0.0, phase_y_ = 0.0;
};

// Program of grooves with a nearly level tip while B rotates the tool about the zero.
class TurningTool {
public:
    explicit TurningTool(std::uint64_t seed) : random_(seed), is_deep_(seed >= kTurningSides) {}

    std::string write() {
        std::string text = is_deep_ ? tool_at_random() : "(T1 D=8. CR=4. - ball end mill)\n";
        text += "(STOCK/BLOCK,80.,60.,15.,0.,0.,15.)\nG21 G90 G17\nT1 M6 S5000 M3\n";
        for (int groove = pick(1, 3); groove > 0; --groove) {
            double b = tenths(-60, 60), x = tenths(-50, 850), y = tenths(-50, 650);
            if (is_deep_) {
                text += along_tool(place("G1", x, y, depth(), b));
            } else {
                text += place("G0", x, y, 30.0, b) + place("G1", x, y, depth(), b);
            }
            for (int move = pick(1, 5); move > 0; --move) {
                b = std::clamp(b + tenths(-30, 30), -8.0, 8.0);
                x += tenths(-200, 200), y += tenths(-200, 200);
                text += place("G1", x, y, depth(), b);
            }
            text += is_deep_ ? "G0 Z60\n" : place("G0", x, y, 30.0, b);
        }
        return text + "M30\n";
    }

private:
    int pick(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
    }
    double tenths(int low, int high) { return 0.1 * pick(low, high); }
    // Returns a rapid to the place of `to` at Z60, then `to`.
    static std::string along_tool(const std::string& to) {
        const std::size_t z = to.find(" Z"), b = to.find(" B");
        return "G0" + to.substr(2, z - 2) + " Z60" + to.substr(b) + to;
    }
    double depth() { return is_deep_ ? -tenths(50, 100) : -tenths(5, 30); }
    std::string tool_at_random() {
        const int which = pick(0, 3);
        if (which == 0) return "(T1 D=8. CR=0. - flat end mill)\n";
        return which == 1 ? "(T1 D=10. CR=2. - bull nose end mill)\n"
                          : "(T1 D=6. CR=3. - ball end mill)\n";
    }
    // Returns a block that moves the tip to (`x`, `y`, `z`) on the part at the angle `b` (degrees).
    static std::string place(const char* word, double x, double y, double z, double b) {
        const double angle = b * std::acos(-1.0) / 180.0;
        return fmt::format("{} X{:.3f} Y{:.3f} Z{:.3f} B{:.3f} F600\n", word,
                           x * std::cos(angle) - z * std::sin(angle), y,
                           x * std::sin(angle) + z * std::cos(angle), b);
    }

    std::mt19937_64 random_;
    bool is_deep_;
};

}  // namespace

std::string random_part(std::uint64_t seed) {
    if (seed >= kTurning) return TurningTool(seed).write();
    return seed >= kRasters && seed < kWithSlopes ? Raster(seed).write() : Writer(seed).write();
}

}  // namespace ncsim::brep::test
