// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/tilted_parts.h"

#include "ncsim/machine/presets.h"
#include "ncsim/setup/job.h"

#include <fmt/format.h>

#include <array>
#include <random>
#include <string_view>

namespace ncsim::brep::test {

namespace {

struct Turning {
    std::string_view preset, axes;
};
constexpr std::array<Turning, 6> kMachines{{{"xyzac-trt", "AC"},
                                            {"xyzbc-trt", "BC"},
                                            {"bridge-cb", "BC"},
                                            {"head-b-table-c", "BC"},
                                            {"nutating-cb", "BC"},
                                            {"4axis-a", "A"}}};

class TiltedWriter {
public:
    explicit TiltedWriter(std::uint64_t seed) : random_(seed) {}

    TiltedPart write() {
        machine_ = kMachines[static_cast<std::size_t>(pick(0, 5))];
        text_ =
            "(T1 D=10. CR=0. - flat end mill)\n(T2 D=6. CR=0. - flat end mill)\n"
            "(T3 D=8. CR=4. - ball end mill)\n(T4 D=12. CR=2. - bull nose end mill)\n"
            "(T5 D=10. CR=0. TAPER=45deg - chamfer mill)\n"
            "(T6 D=5. CR=0. TAPER=118deg - drill)\n(T7 D=8.5 CR=0. TAPER=140deg - drill)\n"
            "(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)\nG21 G90 G17 G54 G40 G49 G80\n";
        // Of some programs numbers are round, so that much coincides.
        grid_ = pick(0, 2) == 0 ? 1 : pick(0, 1) == 0 ? 500 : 5000;
        const int setups = pick(2, 6);
        for (int i = 0; i < setups; ++i)
            setup();
        return {std::string(machine_.preset), text_ + "M30\n"};
    }

private:
    int pick(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
    }
    // Between two lengths, as programs write them.
    double length(double low, double high) {
        const int steps = static_cast<int>((high - low) * 1000.0) / grid_;
        return low + pick(0, steps) * grid_ / 1000.0;
    }
    // In degrees: of 15, whole ones, or any.
    double angle(int low, int high) {
        const int kind = pick(0, 2);
        if (kind == 0) return 15.0 * pick(low / 15, high / 15);
        return kind == 1 ? pick(low, high) : pick(1000 * low, 1000 * high) / 1000.0;
    }
    void line(const std::string& text) { text_ += text + "\n"; }

    void setup() {
        tool_ = pick(0, 2) == 0 ? 4 : pick(1, 7);
        line(fmt::format("T{} M6 S5000 M3\nG0 Z100", tool_));
        const bool has_a_plane = machine_.axes.size() > 1 && pick(0, 2) == 0;
        if (has_a_plane) {
            const double x = length(-20, 20), y = length(-15, 15), z = length(-8, 0);
            const double i = angle(-180, 180), j = angle(0, 60), k = angle(-90, 90);
            line(fmt::format("G68.2 X{:.3f} Y{:.3f} Z{:.3f} I{:.3f} J{:.3f} K{:.3f}\nG53.1", x, y,
                             z, i, j, k));
            operations();
            line("G69");
            return;
        }
        const bool has_tip = pick(0, 1) == 0;
        if (has_tip) line("G43.4 H1");
        std::string to, back;
        for (const char axis : machine_.axes) {
            to += fmt::format(" {}{:.3f}", axis, axis == 'C' ? angle(-180, 180) : angle(-60, 60));
            back += fmt::format(" {}0", axis);
        }
        line("G0" + to);
        operations();
        if (has_tip) line("G49");
        line("G0" + back);
    }

    void operations() {
        const int count = pick(1, 3);
        for (int i = 0; i < count; ++i)
            operation();
        line("G0 Z100");
    }

    void operation() {
        x_ = length(-35, 35), y_ = length(-25, 25);
        const bool is_ramp = pick(0, 2) == 0;
        z_ = -(tool_ == 5 ? length(1, 4) : tool_ > 5 ? length(2, 15) : length(1, 8));
        line(fmt::format("G0 X{:.3f} Y{:.3f} Z60\nG1 Z{:.3f} F300", x_, y_, z_));
        const int moves = tool_ > 5 ? 0 : pick(0, 5);
        for (int i = 0; i < moves; ++i) {
            if (pick(0, 1) == 0) {
                straight(is_ramp);
            } else {
                arc();
            }
        }
        line("G0 Z60");
    }

    void straight(bool is_ramp) {
        const double dx = length(-20, 20), dy = length(-20, 20);
        const int which = pick(0, 2);
        if (which != 0) x_ += dx;
        if (which != 1) y_ += dy;
        if (is_ramp) z_ = -length(0, 9);
        line(fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f}", x_, y_, z_));
    }

    // By whole quarters, so that it ends on the grid.
    void arc() {
        const double i = length(-12, 12), j = pick(0, 1) == 0 ? 0.0 : length(-12, 12);
        if (i == 0.0 && j == 0.0) return;
        const int quarters = pick(1, 4);
        const bool left = pick(0, 1) == 0;
        double u = -i, v = -j;
        for (int k = 0; k < quarters; ++k) {
            const double w = left ? -v : v;
            v = left ? u : -u;
            u = w;
        }
        x_ += i + u, y_ += j + v;
        line(fmt::format("{} X{:.3f} Y{:.3f} I{:.3f} J{:.3f}", left ? "G3" : "G2", x_, y_, i, j));
    }

    std::mt19937_64 random_;
    Turning machine_;
    std::string text_;
    int grid_ = 1;  // µm
    int tool_ = 1;
    double x_ = 0.0, y_ = 0.0, z_ = 0.0;
};

}  // namespace

TiltedPart tilted_part(std::uint64_t seed) {
    return TiltedWriter(seed).write();
}

simulation::Plan plan_of(const TiltedPart& part, const std::string& name) {
    simulation::Plan plan;
    plan.job = setup::job_of({name, part.program});
    plan.keep_boundary = true;
    plan.kinematics.emplace();
    plan.kinematics->chain = *machine::preset(part.machine);
    plan.job.interpreter.tip_control.by_length_word = true;
    plan.job.interpreter.tip_control.frame_at_zero = true;
    return plan;
}

}  // namespace ncsim::brep::test
