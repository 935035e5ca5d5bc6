// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the benchmark programs line by line.
#include "programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>

namespace ncsim::bench {

namespace {

constexpr double kSize = 100.0;  // of the block, mm

class Program {
public:
    Program(std::string_view title, std::string_view tool,
            std::string_view stock = "BLOCK,100.,100.,40.,0.,0.,40.") {
        line("({})", title);
        line("(T1 {})", tool);
        line("(STOCK/{})", stock);
        line("G21 G90 G17 G94 G40");
        line("T1 M6");
        line("S12000 M3");
    }
    template <class... Arguments>
    void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
        text_ += '\n';
    }
    std::string end() && {
        line("G0 Z20.");
        line("M30");
        return std::move(text_);
    }

private:
    std::string text_;
};

}  // namespace

std::string wave_program(std::size_t moves) {
    Program program("crossed sines in a raster", "D=6. CR=3. - ball end mill");
    const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(moves)));
    const std::size_t columns = moves / rows;
    program.line("G0 X0. Y0. Z20.");
    program.line("G1 F1500.");
    for (std::size_t row = 0; row < rows; ++row) {
        const double y = kSize * static_cast<double>(row) /
                         static_cast<double>(std::max<std::size_t>(rows, 2) - 1);
        for (std::size_t k = 0; k <= columns; ++k) {
            const double x = kSize * static_cast<double>(row % 2 == 0 ? k : columns - k) /
                             static_cast<double>(columns);
            const double z = -6.0 + 2.0 * std::sin(0.25 * x) * std::cos(0.25 * y);
            program.line("X{:.3f} Y{:.3f} Z{:.3f}", x, y, z);
        }
    }
    return std::move(program).end();
}

std::string pocket_program(std::size_t moves) {
    Program program("trochoidal clearing", "D=10. CR=0. - flat end mill");
    constexpr double kLoop = 3.0;     // radius
    constexpr double kAdvance = 0.8;  // per loop
    constexpr double kRowWidth = 12.0;
    constexpr std::size_t kSteps = 64;  // per loop, 0.3 mm each
    double x = 10.0;
    double y = 10.0;
    double z = -2.0;
    program.line("G0 X{:.3f} Y{:.3f} Z5.", x + kLoop, y);
    program.line("G1 Z{:.3f} F800.", z);
    program.line("F2500.");
    for (std::size_t i = 1; i <= moves; ++i) {
        const double turn = 2.0 * std::numbers::pi * static_cast<double>(i % kSteps) / kSteps;
        const double along = kAdvance * static_cast<double>(i % kSteps) / kSteps;
        program.line("X{:.3f} Y{:.3f}", x + along + kLoop * std::cos(turn),
                     y + kLoop * std::sin(turn));
        if (i % kSteps != kSteps - 1) continue;
        x += kAdvance;
        if (x <= 90.0) continue;
        x = 10.0;
        y += kRowWidth;
        if (y > 90.0) {
            y = 10.0;
            z -= 2.0;
        }
        program.line("G0 Z5.");
        program.line("X{:.3f} Y{:.3f}", x + kLoop, y);
        program.line("G1 Z{:.3f} F800.", z);
        program.line("F2500.");
    }
    return std::move(program).end();
}

std::string drill_program(std::size_t moves) {
    constexpr std::size_t kPecks = 4;
    const std::size_t holes = std::max<std::size_t>(moves / (2 * kPecks), 1);
    const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(holes))));
    const double pitch = kSize / static_cast<double>(side);
    Program program("a plate with holes in a grid",
                    fmt::format("D={:.3f} TAPER=118deg - drill", 0.6 * pitch));
    program.line("G0 Z5.");
    for (std::size_t hole = 0; hole < holes; ++hole) {
        program.line("G0 X{:.3f} Y{:.3f}", pitch * (0.5 + static_cast<double>(hole % side)),
                     pitch * (0.5 + static_cast<double>(hole / side)));
        for (std::size_t peck = 1; peck <= kPecks; ++peck) {
            program.line("G1 Z{:.3f} F300.", -5.0 * static_cast<double>(peck));
            program.line("G0 Z5.");
        }
    }
    return std::move(program).end();
}

std::string contour_program(std::size_t moves) {
    Program program("a wall followed by a tilted tool", "D=8. CR=0. - flat end mill");
    program.line("G0 X50. Y90. Z20.");
    program.line("G1 F1000.");
    constexpr std::size_t kTurn = 400;
    for (std::size_t i = 0; i <= moves; ++i) {
        const double turn = 2.0 * std::numbers::pi * static_cast<double>(i % kTurn) / kTurn;
        const double down = 20.0 * static_cast<double>(i) / static_cast<double>(moves);
        program.line("X{:.3f} Y{:.3f} Z{:.3f} A{:.3f} B{:.3f}", 50.0 + 40.0 * std::sin(turn),
                     50.0 + 40.0 * std::cos(turn), -1.0 - down, 5.0 * std::cos(turn),
                     5.0 * std::sin(turn));
    }
    return std::move(program).end();
}

std::string finish_program(std::size_t moves) {
    Program program("finishing over steps", "D=2. CR=1. - ball end mill");
    const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(moves)));
    const std::size_t columns = moves / rows;
    constexpr double kPatch = 30.0;  // mm, so that rows are close
    program.line("G0 X20. Y20. Z20.");
    program.line("G1 F1500.");
    for (std::size_t row = 0; row < rows; ++row) {
        const double y = kPatch * static_cast<double>(row) / static_cast<double>(rows);
        for (std::size_t k = 0; k <= columns; ++k) {
            const std::size_t at = row % 2 == 0 ? k : columns - k;
            const double x = kPatch * static_cast<double>(at) / static_cast<double>(columns);
            // The path steps up and down by 1 mm every 5 mm.
            const bool is_high = static_cast<int>(x / 5.0) % 2 == 1;
            program.line("X{:.3f} Y{:.3f} Z{:.3f}", 20.0 + x, 20.0 + y, is_high ? -1.0 : -2.0);
        }
    }
    return std::move(program).end();
}

std::string passes_program(std::size_t passes) {
    Program program("a contour in many passes", "D=8. CR=0. - flat end mill");
    constexpr std::size_t kTurn = 80;
    program.line("G0 X90. Y50. Z5.");
    for (std::size_t pass = 1; pass <= passes; ++pass) {
        const double z = -20.0 * static_cast<double>(pass) / static_cast<double>(passes);
        program.line("G1 Z{:.3f} F300.", z);
        program.line("F1500.");
        for (std::size_t i = 1; i <= kTurn; ++i) {
            const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / kTurn;
            const double radius = 40.0 + 3.0 * std::sin(5.0 * turn);
            program.line("X{:.3f} Y{:.3f}", 50.0 + radius * std::cos(turn),
                         50.0 + radius * std::sin(turn));
        }
    }
    return std::move(program).end();
}

std::string bores_program(std::size_t bores) {
    Program program("helical bores", "D=6. CR=0. - flat end mill");
    const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(bores))));
    const double pitch = kSize / static_cast<double>(side);
    const double radius = 0.2 * pitch;
    for (std::size_t bore = 0; bore < bores; ++bore) {
        const double x = pitch * (0.5 + static_cast<double>(bore % side));
        const double y = pitch * (0.5 + static_cast<double>(bore / side));
        program.line("G0 X{:.3f} Y{:.3f} Z1.", x + radius, y);
        for (std::size_t turn = 1; turn <= 3; ++turn)
            program.line("G3 X{:.3f} Y{:.3f} Z{:.3f} I{:.3f} J0. F400.", x + radius, y,
                         -2.0 * static_cast<double>(turn), -radius);
        program.line("G3 X{:.3f} Y{:.3f} I{:.3f} J0.", x + radius, y, -radius);
        program.line("G0 Z5.");
    }
    return std::move(program).end();
}

std::string rotary_program(std::size_t moves) {
    Program program("a raster around a bar", "D=6. CR=3. - ball end mill",
                    "BLOCK,100.,60.,60.,0.,30.,30.");
    const auto columns = static_cast<std::size_t>(std::sqrt(static_cast<double>(moves)));
    const std::size_t turns = moves / columns;
    program.line("G0 X0. Y0. Z60. A0.");
    program.line("G1 F1500.");
    for (std::size_t k = 0; k < columns; ++k) {
        const double x = kSize * static_cast<double>(k) / static_cast<double>(columns);
        for (std::size_t i = 0; i < turns; ++i) {
            const double a = 360.0 * static_cast<double>(i) / static_cast<double>(turns);
            const double turn = a * std::numbers::pi / 180.0;
            program.line("X{:.3f} A{:.3f} Z{:.3f}", x, a, 25.0 + 3.0 * std::sin(4.0 * turn));
        }
        program.line("A0.");
    }
    return std::move(program).end();
}

std::string program_named(std::string_view name) {
    const std::size_t dash = name.rfind('-');
    std::size_t moves = 0;
    if (dash != std::string_view::npos) {
        const char* end = name.data() + name.size();
        const auto parsed = std::from_chars(name.data() + dash + 1, end, moves);
        if (parsed.ptr != end || moves == 0) moves = 0;
    }
    const std::string_view kind = name.substr(0, dash);
    if (moves > 0 && kind == "wave") return wave_program(moves);
    if (moves > 0 && kind == "pocket") return pocket_program(moves);
    if (moves > 0 && kind == "drill") return drill_program(moves);
    if (moves > 0 && kind == "contour") return contour_program(moves);
    if (moves > 0 && kind == "finish") return finish_program(moves);
    if (moves > 0 && kind == "passes") return passes_program(moves);
    if (moves > 0 && kind == "bores") return bores_program(moves);
    if (moves > 0 && kind == "rotary") return rotary_program(moves);
    throw std::invalid_argument(
        fmt::format("no such program: '{}' (wave-N, pocket-N, drill-N, contour-N, finish-N, "
                    "passes-N, bores-N, rotary-N)",
                    name));
}

}  // namespace ncsim::bench
