// SPDX-License-Identifier: GPL-3.0-or-later
//
// Base of random programs: tools, rounded numbers, lines and arcs.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <random>
#include <string>

namespace ncsim::brep::test {

/// Comments of two flat end mills, a ball, a bull nose, a chamfer mill and, from T6 on, drills.
inline constexpr const char* kRandomTools =
    "(T1 D=10. CR=0. - flat end mill)\n(T2 D=6. CR=0. - flat end mill)\n"
    "(T3 D=8. CR=4. - ball end mill)\n(T4 D=12. CR=2. - bull nose end mill)\n"
    "(T5 D=10. CR=0. TAPER=45deg - chamfer mill)\n"
    "(T6 D=5. CR=0. TAPER=118deg - drill)\n(T7 D=8.5 CR=0. TAPER=140deg - drill)\n";

class RandomProgram {
protected:
    explicit RandomProgram(std::uint64_t seed) : random_(seed) {}

    int pick(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
    }
    // Returns a random length (mm) between `low` and `high` on the grid.
    double length(double low, double high) {
        const int steps = static_cast<int>((high - low) * 1000.0) / grid_;
        return low + pick(0, steps) * grid_ / 1000.0;
    }
    // Selects the grid. Some programs have round numbers, so that many positions coincide.
    void choose_grid() { grid_ = pick(0, 2) == 0 ? 1 : pick(0, 1) == 0 ? 500 : 5000; }
    void line(const std::string& text) { text_ += text + "\n"; }

    void straight(bool is_ramp) {
        const double dx = length(-20, 20), dy = length(-20, 20);
        const int which = pick(0, 2);
        if (which != 0) x_ += dx;
        if (which != 1) y_ += dy;
        if (is_ramp) z_ = -length(0, 9);
        line(fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f}", x_, y_, z_));
    }

    struct Arc {
        const char* word;
        double i, j;  // centre from the start; the end is the program's position
    };
    // Returns an arc of whole quarters, which ends on the grid; empty if the radius is 0.
    std::optional<Arc> next_arc() {
        const double i = length(-12, 12), j = pick(0, 1) == 0 ? 0.0 : length(-12, 12);
        if (i == 0.0 && j == 0.0) return std::nullopt;
        const int quarters = pick(1, 4);
        const bool left = pick(0, 1) == 0;
        double u = -i, v = -j;
        for (int k = 0; k < quarters; ++k) {
            const double w = left ? -v : v;
            v = left ? u : -u;
            u = w;
        }
        x_ = x_ + i + u, y_ = y_ + j + v;
        return Arc{left ? "G3" : "G2", i, j};
    }
    void arc(const Arc& arc, const std::string& down = "") {
        line(fmt::format("{} X{:.3f} Y{:.3f}{} I{:.3f} J{:.3f}", arc.word, x_, y_, down, arc.i,
                         arc.j));
    }

    std::mt19937_64 random_;
    std::string text_;
    int grid_ = 1;  // µm
    double x_ = 0.0, y_ = 0.0, z_ = 0.0;
};

}  // namespace ncsim::brep::test
