// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes random slots in the units and decimals of the program.
#include "brep/slot_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

namespace ncsim::brep::test {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

class SlotProgram {
public:
    explicit SlotProgram(std::uint64_t seed) : random_(seed) {}

    std::string write() {
        is_inch_ = pick(0, 2) == 0;
        decimals_ = is_inch_ ? pick(4, 6) : pick(3, 6);
        // Three in four tools are of a usual size.
        diameter_ = pick(0, 3) == 0 ? 0.1 * pick(1, 9) : 0.5 * pick(2, 40);
        const double half = 10.0 * diameter_, height = 4.0 * diameter_;
        text_ = fmt::format(
            "(T1 D={:.3f} CR=0. - flat end mill)\n(STOCK/BLOCK,{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},"
            "{:.3f})\n{} G90 G17\nT1 M6 S5000 M3\n",
            size(diameter_), size(2.0 * half), size(2.0 * half), size(height), size(half),
            size(half), size(height), is_inch_ ? "G20" : "G21");
        for (int slots = pick(1, 3); slots > 0; --slots)
            slot();
        return text_ + "M30\n";
    }

private:
    void slot() {
        const int kind = pick(0, 4);
        if (kind < 2) arc_slot();
        if (kind == 2) lead_in();
        if (kind == 3) crossing();
        if (kind == 4) passes();
    }

    // Cuts an arc of any angle. A deeper plunge may be at the start, at the end, or at both.
    void arc_slot() {
        const double radius = diameter_ * from(0.6, 4.0), start = from(0.0, kTurn);
        const bool is_left = pick(0, 1) == 0;
        const double sweep = (is_left ? 1.0 : -1.0) * from(0.2, 0.95 * kTurn);
        const double x = diameter_ * from(-4.0, 4.0), y = diameter_ * from(-4.0, 4.0);
        const double depth = diameter_ * from(0.1, 1.5);
        approach(x + radius * std::cos(start), y + radius * std::sin(start));
        if (pick(0, 1) == 0) {
            down(depth + diameter_ * from(0.1, 1.0));
            up(depth);
        } else {
            down(depth);
        }
        arc(x, y, radius, start, sweep);
        if (pick(0, 3) != 0) down(depth + diameter_ * from(0.1, 1.0));
        retract();
    }

    // Cuts an arc, the line tangent to the arc, and a second arc.
    void lead_in() {
        const double radius = diameter_ * from(0.6, 2.0), direction = from(0.0, kTurn);
        const double sweep = from(0.1, 0.6) * kTurn, length = diameter_ * from(0.5, 5.0);
        const double x = diameter_ * from(-4.0, 4.0), y = diameter_ * from(-4.0, 4.0);
        // The centre is to the left of the line.
        const double normal = direction + 0.25 * kTurn;
        const double cx = x + radius * std::cos(normal), cy = y + radius * std::sin(normal);
        const double start = normal + 0.5 * kTurn - sweep;
        approach(cx + radius * std::cos(start), cy + radius * std::sin(start));
        down(diameter_ * from(0.1, 1.5));
        arc(cx, cy, radius, start, sweep);
        go(x + length * std::cos(direction), y + length * std::sin(direction));
        arc(cx + length * std::cos(direction), cy + length * std::sin(direction), radius,
            normal + 0.5 * kTurn, sweep);
        retract();
    }

    // Cuts two straight slots of equal or different depth.
    void crossing() {
        const double depth = diameter_ * from(0.1, 1.5);
        const double x = diameter_ * from(-3.0, 3.0), y = diameter_ * from(-3.0, 3.0);
        for (int i = 0; i < 2; ++i) {
            const double angle = from(0.0, kTurn), half = diameter_ * from(1.0, 4.0);
            approach(x - half * std::cos(angle), y - half * std::sin(angle));
            down(pick(0, 1) == 0 ? depth : diameter_ * from(0.1, 1.5));
            go(x + half * std::cos(angle), y + half * std::sin(angle));
            retract();
        }
    }

    void passes() {
        const double angle = from(0.0, kTurn), step = diameter_ * from(0.3, 0.95);
        const double depth = diameter_ * from(0.1, 1.5);
        const double x = diameter_ * from(-4.0, 2.0), y = diameter_ * from(-4.0, 2.0);
        for (int i = pick(2, 4); i > 0; --i) {
            const double u = diameter_ * from(-2.0, 2.0), v = u + diameter_ * from(1.0, 5.0);
            const double px = x - i * step * std::sin(angle), py = y + i * step * std::cos(angle);
            approach(px + u * std::cos(angle), py + u * std::sin(angle));
            down(depth);
            go(px + v * std::cos(angle), py + v * std::sin(angle));
            retract();
        }
    }

    int pick(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
    }
    // Returns a number from the bits of the random engine, because distributions differ between
    // libraries.
    double from(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_() >> 11U) * 0x1p-53);
    }
    double size(double mm) const { return is_inch_ ? mm / 25.4 : mm; }
    // Returns the number as the program has it, in mm.
    double rounded(double mm) const {
        const double scale = std::pow(10.0, decimals_);
        return std::round(size(mm) * scale) / scale * (is_inch_ ? 25.4 : 1.0);
    }
    std::string word(char letter, double mm) const {
        return fmt::format(" {}{:.{}f}", letter, size(mm), decimals_);
    }
    void approach(double x, double y) {
        x_ = rounded(x), y_ = rounded(y);
        text_ += "G0" + word('X', x) + word('Y', y) + word('Z', diameter_) + "\n";
    }
    void down(double depth) { text_ += "G1" + word('Z', -depth) + " F100\n"; }
    void up(double depth) { text_ += "G0" + word('Z', -depth) + "\n"; }
    void retract() { text_ += "G0" + word('Z', diameter_) + "\n"; }
    void go(double x, double y) {
        x_ = rounded(x), y_ = rounded(y);
        text_ += "G1" + word('X', x) + word('Y', y) + " F100\n";
    }
    void arc(double cx, double cy, double radius, double start, double sweep) {
        const double x = cx + radius * std::cos(start + sweep);
        const double y = cy + radius * std::sin(start + sweep);
        text_ += (sweep > 0.0 ? "G3" : "G2") + word('X', x) + word('Y', y) + word('I', cx - x_) +
                 word('J', cy - y_) + " F100\n";
        x_ = rounded(x), y_ = rounded(y);
    }

    std::mt19937_64 random_;
    std::string text_;
    bool is_inch_ = false;
    int decimals_ = 3;
    double diameter_ = 1.0;
    double x_ = 0.0, y_ = 0.0;  // as programmed, mm
};

}  // namespace

std::string slot_part(std::uint64_t seed) {
    return SlotProgram(seed).write();
}

}  // namespace ncsim::brep::test
