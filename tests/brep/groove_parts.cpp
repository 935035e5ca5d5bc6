// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes random grooves.
#include "brep/groove_parts.h"

#include "brep/random_program.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string_view>

namespace ncsim::brep::test {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

class GrooveProgram : RandomProgram {
public:
    explicit GrooveProgram(std::uint64_t seed) : RandomProgram(seed) {}

    std::string write() {
        decimals_ = pick(3, 6);
        diameter_ = 0.5 * pick(4, 24);
        switch (pick(0, 5)) {
            case 0: lead_ins(); break;
            case 1: around_bar(); break;
            case 2: rings(); break;
            case 3: helix(); break;
            case 4: engraving(); break;
            default: crossing();
        }
        return text_ + "M30\n";
    }

private:
    // Cuts passes along Y that begin and end with vertical arcs, side by side.
    void lead_ins() {
        begin(pick(0, 2), 20.0 * diameter_, 20.0 * diameter_, 4.0 * diameter_, 0.0);
        const double step = diameter_ * from(0.2, 1.1), radius = diameter_ * from(0.1, 1.0);
        double depth = diameter_ * from(0.1, 0.8);
        const double half = diameter_ * from(0.5, 6.0);
        const bool is_level = pick(0, 1) == 0;
        const int passes = pick(1, 6);
        for (int i = 0; i < passes; ++i) {
            if (!is_level) depth = diameter_ * from(0.1, 0.8);
            line("G0" + word('X', step * (i - 0.5 * passes)) + word('Y', half + radius) +
                 word('Z', diameter_));
            line("G1" + word('Z', radius - depth) + " F300");
            line("G19 G2" + word('Y', half) + word('Z', -depth) + word('J', -radius) + " K0");
            line("G1" + word('Y', -half));
            line("G2" + word('Y', -half - radius) + word('Z', radius - depth) + " J0" +
                 word('K', radius));
            line("G17 G0" + word('Z', diameter_));
        }
    }

    // Cuts grooves that wind around a bar, along it or off its axis.
    void around_bar() {
        const double radius = diameter_ * from(0.8, 4.0), length = diameter_ * from(1.0, 8.0);
        begin_bar(radius, length);
        const double off = pick(0, 2) == 0 ? diameter_ * from(-0.4, 0.4) : 0.0;
        for (int grooves = pick(1, 2); grooves > 0; --grooves) {
            const double turns = from(0.1, 8.0) * (pick(0, 1) == 0 ? 1.0 : -1.0);
            const double depth = std::min(radius, diameter_) * from(0.02, 0.4);
            const double at = from(-0.2, 0.5) * length;
            line("G0" + word('X', at) + word('Y', off) + word('Z', 2.0 * radius) +
                 angle(from(0.0, 360.0)));
            line("G1" + word('Z', radius - depth) + " F300");
            line("G1" + word('X', at + from(0.1, 0.7) * length) + angle(angle_ + 360.0 * turns) +
                 " F3000");
            line("G0" + word('Z', 2.0 * radius));
        }
    }

    // Cuts rings and arcs around a bar, at several places and depths.
    void rings() {
        const double radius = diameter_ * from(0.8, 4.0), length = diameter_ * from(2.0, 8.0);
        begin_bar(radius, length);
        for (int i = pick(1, 4); i > 0; --i) {
            line("G0" + word('X', from(0.0, 1.0) * length) + " Y0" + word('Z', 2.0 * radius) +
                 angle(from(0.0, 360.0)));
            const double depth = std::min(radius, diameter_) * from(0.02, 0.4);
            line("G1" + word('Z', radius - depth) + " F300");
            const double turn = pick(0, 1) == 0 ? 360.0 : from(5.0, 350.0);
            line("G1" + angle(angle_ + turn) + " F3000");
            if (pick(0, 1) == 0) line("G1" + word('X', from(0.0, 1.0) * length));
            line("G0" + word('Z', 2.0 * radius));
        }
    }

    // Enters a block by a helix of 1 to 8 turns, and cuts a circle at its floor.
    void helix() {
        begin(pick(0, 2), 20.0 * diameter_, 20.0 * diameter_, 6.0 * diameter_, 0.0);
        const double radius = diameter_ * from(0.1, 2.0), start = from(0.0, kTurn);
        const double x = diameter_ * from(-2.0, 2.0), y = diameter_ * from(-2.0, 2.0);
        const double i = rounded(radius * std::cos(start)), j = rounded(radius * std::sin(start));
        const std::string_view way = pick(0, 1) == 0 ? "G2" : "G3";
        line("G0" + word('X', x) + word('Y', y) + word('Z', diameter_));
        line("G1 Z0 F300");
        const double pitch = diameter_ * from(0.05, 0.5);
        const int turns = pick(1, 8);
        for (int turn = 1; turn <= turns; ++turn)
            line(fmt::format("{}{}{}{}{}{}", way, word('X', x), word('Y', y),
                             word('Z', -pitch * turn), word('I', i), word('J', j)));
        if (pick(0, 2) != 0)
            line(fmt::format("{}{}{}{}{}", way, word('X', x), word('Y', y), word('I', i),
                             word('J', j)));
        if (pick(0, 1) == 0) line("G1" + word('X', x + i) + word('Y', y + j));
        line("G0" + word('Z', diameter_));
    }

    // Cuts straight strokes, arcs and circles that cross each other, at one depth or at several.
    void engraving() {
        begin(pick(0, 4) == 0 ? pick(0, 2) : 1, 16.0 * diameter_, 16.0 * diameter_, 3.0 * diameter_,
              0.0);
        double depth = diameter_ * from(0.05, 0.7);
        const bool is_level = pick(0, 3) != 0;
        for (int i = pick(2, 4); i > 0; --i) {
            if (!is_level) depth = diameter_ * from(0.05, 0.7);
            const double x = diameter_ * from(-2.0, 2.0), y = diameter_ * from(-2.0, 2.0);
            const double start = from(0.0, kTurn), reach = diameter_ * from(0.6, 4.0);
            line("G0" + word('X', x + reach * std::cos(start)) +
                 word('Y', y + reach * std::sin(start)) + word('Z', diameter_));
            line("G1" + word('Z', -depth) + " F300");
            const double end = pick(0, 2) == 0 ? start : from(0.0, kTurn);
            const std::string to =
                word('X', x + reach * std::cos(end)) + word('Y', y + reach * std::sin(end));
            if (pick(0, 2) == 0) {
                line("G1" + to);
            } else {
                line((pick(0, 1) == 0 ? "G2" : "G3") + to + word('I', -reach * std::cos(start)) +
                     word('J', -reach * std::sin(start)));
            }
            line("G0" + word('Z', diameter_));
        }
    }

    // Cuts straight grooves through one place, at one depth or at several.
    void crossing() {
        begin(pick(0, 3) == 0 ? pick(0, 2) : 1, 16.0 * diameter_, 16.0 * diameter_, 3.0 * diameter_,
              0.0);
        double depth = diameter_ * from(0.05, 0.9);
        const bool is_level = pick(0, 2) != 0;
        for (int i = pick(2, 4); i > 0; --i) {
            if (!is_level) depth = diameter_ * from(0.05, 0.9);
            const double across = from(0.0, kTurn), half = diameter_ * from(1.0, 6.0);
            line("G0" + word('X', -half * std::cos(across)) + word('Y', -half * std::sin(across)) +
                 word('Z', diameter_));
            line("G1" + word('Z', -depth) + " F300");
            line("G1" + word('X', half * std::cos(across)) + word('Y', half * std::sin(across)));
            line("G0" + word('Z', diameter_));
        }
    }

    // Begins with a flat end mill, a ball or a bull nose, and a block whose middle is X0 Y0.
    void begin(int tool, double length, double width, double height, double below) {
        const double corner = tool == 0 ? 0.0 : (tool == 1 ? 0.5 : 0.01 * pick(5, 48)) * diameter_;
        constexpr const char* kKinds[] = {"flat end mill", "ball end mill", "bull nose end mill"};
        line(fmt::format("(T1 D={:.3f} CR={:.4f} - {})", diameter_, corner, kKinds[tool]));
        line(fmt::format("(STOCK/BLOCK,{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f})", length, width,
                         height, 0.5 * length, 0.5 * width, height - below));
        line("G21 G90 G17 G94 G54\nT1 M6\nS5000 M3");
    }
    // Begins with a bar around X, which is square.
    void begin_bar(double radius, double length) {
        begin(pick(0, 2), 2.0 * length, 2.0 * radius, 2.0 * radius, radius);
    }

    // Returns a number from the bits of the random engine, because distributions differ between
    // libraries.
    double from(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_() >> 11U) * 0x1p-53);
    }
    double rounded(double mm) const {
        const double scale = std::pow(10.0, decimals_);
        return std::round(mm * scale) / scale;
    }
    std::string word(char letter, double mm) const {
        return fmt::format(" {}{:.{}f}", letter, mm, decimals_);
    }
    std::string angle(double degrees) {
        angle_ = std::round(degrees * 1000.0) / 1000.0;
        return fmt::format(" A{:.3f}", angle_);
    }

    int decimals_ = 3;
    double diameter_ = 1.0;
    double angle_ = 0.0;
};

}  // namespace

std::string groove_part(std::uint64_t seed) {
    return GrooveProgram(seed).write();
}

}  // namespace ncsim::brep::test
