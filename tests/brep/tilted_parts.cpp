// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random programs for preset machines with rotary axes.
#include "brep/tilted_parts.h"

#include "ncsim/machine/presets.h"
#include "ncsim/setup/job.h"

#include "brep/random_program.h"

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

class TiltedWriter : RandomProgram {
public:
    explicit TiltedWriter(std::uint64_t seed) : RandomProgram(seed) {}

    TiltedPart write() {
        machine_ = kMachines[static_cast<std::size_t>(pick(0, 5))];
        text_ = std::string(kRandomTools) +
                "(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)\nG21 G90 G17 G54 G40 G49 G80\n";
        choose_grid();
        const int setups = pick(2, 6);
        for (int i = 0; i < setups; ++i)
            setup();
        return {std::string(machine_.preset), text_ + "M30\n"};
    }

private:
    // Returns an angle in degrees: a multiple of 15, a whole number, or any value.
    double angle(int low, int high) {
        const int kind = pick(0, 2);
        if (kind == 0) return 15.0 * pick(low / 15, high / 15);
        return kind == 1 ? pick(low, high) : pick(1000 * low, 1000 * high) / 1000.0;
    }
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
                if (const auto next = next_arc()) arc(*next);
            }
        }
        line("G0 Z60");
    }

    Turning machine_;
    int tool_ = 1;
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
