// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random operations of CAM programs, and the rotation of a program.
#include "brep/cam_parts.h"

#include "ncsim/base/angles.h"

#include "brep/random_program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <sstream>
#include <string_view>
#include <tuple>
#include <vector>

namespace ncsim::brep::test {

namespace {

// Centre line of a wall: a rectangle with corner radius `corner`, or 0 for sharp corners.
struct Frame {
    double x, y, half_x, half_y, corner;
};

class Cam : RandomProgram {
public:
    explicit Cam(std::uint64_t seed) : RandomProgram(seed) {}

    std::string write() {
        text_ = std::string(kRandomTools) + "(STOCK/BLOCK,80.,60.,15.,0.,0.,15.)\nG21 G90 G17\n";
        choose_grid();
        for (int left = pick(1, 4); left > 0; --left)
            operation();
        return text_ + "M30\n";
    }

private:
    void operation() {
        const int which = pick(0, 7);
        if (which == 0) face();
        if (which == 1) holes();
        if (which == 2) slot();
        if (which == 3) engrave();
        if (which == 4) chamfer();
        if (which == 5) pocket();
        if (which > 5) profile();
    }

    void call(int tool) { line(fmt::format("T{} M6 S5000 M3", tool)); }
    void rapid(double x, double y) {
        x_ = x, y_ = y;
        line(fmt::format("G0 X{:.3f} Y{:.3f} Z5", x, y));
    }
    void down(double z) {
        z_ = z;
        line(fmt::format("G1 Z{:.3f} F300", z));
    }
    // Moves in one to three collinear pieces.
    void go(double x, double y, double z) {
        const int pieces = pick(1, 3);
        const double from_x = x_, from_y = y_, from_z = z_;
        for (int i = 1; i <= pieces; ++i) {
            const double share = static_cast<double>(i) / pieces;
            x_ = from_x + share * (x - from_x), y_ = from_y + share * (y - from_y);
            z_ = from_z + share * (z - from_z);
            line(fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f}", x_, y_, z_));
        }
    }
    void go(double x, double y) { go(x, y, z_); }
    // Moves on a counter-clockwise arc to (`x`, `y`) about the given centre.
    void turn(double x, double y, double centre_x, double centre_y) {
        const double i = centre_x - x_, j = centre_y - y_;
        x_ = x, y_ = y;
        line(fmt::format("G3 X{:.3f} Y{:.3f} I{:.3f} J{:.3f}", x, y, i, j));
    }

    void face() {
        call(1);
        const double step = length(5, 9);
        rapid(-8, 0);
        down(-length(0.5, 2));
        for (double y = 0.0;; y += step) {
            go(x_ < 40.0 ? 88.0 : -8.0, y_);
            if (y > 60.0) break;
            go(x_, y + step);
        }
        line("G0 Z5");
    }

    void holes() {
        call(pick(6, 7));
        const double depth = length(3, 20), step_x = length(10, 20), step_y = length(10, 20);
        const bool pecks = pick(0, 1) == 0;
        x_ = length(5, 30), y_ = length(5, 30);
        line("G0 Z5");
        line(fmt::format("G99 {} X{:.3f} Y{:.3f} Z{:.3f} R2 {}F200", pecks ? "G83" : "G81", x_, y_,
                         -depth, pecks ? "Q3 " : ""));
        for (int i = pick(1, 3); i > 0; --i) {
            x_ += pick(0, 1) * step_x, y_ += pick(0, 1) * step_y;
            line(fmt::format("X{:.3f} Y{:.3f}", x_, y_));
        }
        line("G80");
        line("G0 Z5");
    }

    // Cuts a slot back and forth, deeper at each pass, by plunges or ramps.
    void slot() {
        const int tool = pick(1, 4);
        call(tool);
        const double x = length(10, 70), y = length(10, 50);
        const double to_x = length(10, 70), to_y = pick(0, 1) == 0 ? y : length(10, 50);
        if (x == to_x && y == to_y) return;
        const double step = length(0.5, 2.5);
        const bool is_ramp = pick(0, 2) == 0;
        rapid(x, y);
        down(is_ramp ? 0.0 : -step);
        for (int i = pick(1, 4); i > 0; --i) {
            const bool is_there = x_ == x && y_ == y;
            go(is_there ? to_x : x, is_there ? to_y : y, is_ramp ? z_ - step : z_);
            if (!is_ramp && i > 1) down(z_ - step);
        }
        if (is_ramp) go(x_ == x ? to_x : x, y_ == y ? to_y : y);
        line("G0 Z5");
    }

    void engrave() {
        call(pick(0, 1) == 0 ? 5 : 3);
        const double depth = length(0.2, 1);
        for (int strokes = pick(1, 4); strokes > 0; --strokes) {
            rapid(length(10, 70), length(10, 50));
            down(-depth);
            for (int i = pick(1, 5); i > 0; --i) {
                if (pick(0, 2) > 0) {
                    go(x_ + length(-8, 8), y_ + length(-8, 8));
                } else if (const auto next = next_arc()) {
                    arc(*next);
                }
            }
            line("G0 Z5");
        }
    }

    Frame frame_at_random(double least) {
        Frame frame{length(25, 55), length(22, 38), length(least, 22), length(least, 18), 0.0};
        if (pick(0, 1) == 0) frame.corner = length(0.5, 0.8 * std::min(frame.half_x, frame.half_y));
        return frame;
    }

    // Moves once around the frame, counter-clockwise from the middle of the lower side.
    void around(const Frame& f) {
        const double c = f.corner, x = f.half_x, y = f.half_y;
        go(f.x + x - c, f.y - y);
        if (c > 0.0) turn(f.x + x, f.y - y + c, f.x + x - c, f.y - y + c);
        go(f.x + x, f.y + y - c);
        if (c > 0.0) turn(f.x + x - c, f.y + y, f.x + x - c, f.y + y - c);
        go(f.x - x + c, f.y + y);
        if (c > 0.0) turn(f.x - x, f.y + y - c, f.x - x + c, f.y + y - c);
        go(f.x - x, f.y - y + c);
        if (c > 0.0) turn(f.x - x + c, f.y - y, f.x - x + c, f.y - y + c);
        go(f.x, f.y - y);
    }

    // Cuts a wall in passes. Each pass has a lead-in and a lead-out, quarter arcs from inside, or
    // neither.
    void wall(const Frame& f, double depth) {
        const int passes = pick(1, 3);
        const double lead = pick(0, 1) == 0 ? length(0.5, 2) : 0.0;
        const double start = f.y - f.half_y;
        for (int pass = 1; pass <= passes; ++pass) {
            rapid(f.x - lead, start + lead);
            down(-depth * pass / passes);
            if (lead > 0.0) turn(f.x, start, f.x, start + lead);
            around(f);
            if (lead > 0.0) turn(f.x + lead, start + lead, f.x, start + lead);
        }
        line("G0 Z5");
    }

    void profile() {
        const int tool = pick(1, 4);
        call(tool);
        wall(frame_at_random(6), length(1, 8));
    }

    void chamfer() {
        call(5);
        wall(frame_at_random(6), length(0.5, 2));
    }

    // Cuts a pocket: entry by a helix, a ramp or a plunge, then rows, then the wall.
    void pocket() {
        const int tool = pick(0, 1) == 0 ? 2 : 4;
        const double radius = tool == 2 ? 3.0 : 6.0;
        call(tool);
        const Frame f = frame_at_random(radius + 2.0);
        const double depth = length(1, 6), reach = 0.5 * radius;
        const int entry = pick(0, 2);
        rapid(f.x + (entry == 0 ? reach : 0.0), f.y);
        down(entry == 2 ? -depth : 0.0);
        if (entry == 0) {
            for (int turns = pick(1, 3), i = 1; i <= turns; ++i)
                line(fmt::format("G3 X{:.3f} Y{:.3f} Z{:.3f} I{:.3f} J0", x_, y_,
                                 -depth * i / turns, -reach));
            z_ = -depth;
            turn(x_, y_, f.x, f.y);
        } else if (entry == 1) {
            go(f.x + radius, f.y, -0.5 * depth);
            go(f.x, f.y, -depth);
        }
        const double step = 0.8 * radius;
        for (double y = f.y - f.half_y; y < f.y + f.half_y; y += step) {
            go(x_, y);
            go(x_ < f.x ? f.x + f.half_x : f.x - f.half_x, y);
        }
        line("G0 Z5");
        wall(f, depth);
    }
};

// Rotates `program` in the XY plane about the middle of the block.
// Requires: each block has X with Y and I with J, or neither.
std::string turned(const std::string& program, double degrees) {
    const auto t = sin_cos(degrees);
    std::string text;
    std::istringstream lines(program);
    for (std::string line; std::getline(lines, line);) {
        std::map<char, double> words;
        std::vector<std::string> kept;
        std::istringstream in(line);
        for (std::string word; in >> word;) {
            if (std::string_view("XYIJ").find(word.front()) != std::string_view::npos) {
                words[word.front()] = std::stod(word.substr(1));
            } else {
                kept.push_back(word);
            }
        }
        for (const auto& [first, second, x0, y0] :
             {std::tuple('X', 'Y', 40.0, 30.0), std::tuple('I', 'J', 0.0, 0.0)}) {
            if (!words.contains(first) || !words.contains(second)) continue;
            const double x = words[first] - x0, y = words[second] - y0;
            kept.push_back(fmt::format("{}{:.3f}", first, x0 + t.cos * x - t.sin * y));
            kept.push_back(fmt::format("{}{:.3f}", second, y0 + t.sin * x + t.cos * y));
        }
        text += fmt::format("{}\n", fmt::join(kept, " "));
    }
    return text;
}

}  // namespace

std::string cam_part(std::uint64_t seed) {
    if (seed < kTurnedCam) return Cam(seed).write();
    std::mt19937_64 random(seed);
    const double degrees = static_cast<double>(random() % 36'000) / 100.0;
    return turned(Cam(seed - kTurnedCam + kCam).write(), degrees);
}

}  // namespace ncsim::brep::test
