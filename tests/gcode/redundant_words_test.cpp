// SPDX-License-Identifier: GPL-3.0-or-later
//
// Changes to a program that do not change a motion: words of active modes, block numbers, comments,
// blank lines, and blocks split where both forms mean the same. Programs are random, each
// determined by its number. NCSIM_REDUNDANT_PROGRAMS=100000 in the environment runs 100,000
// programs.
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

struct Mode {
    Dialect dialect;
    bool strict;
};
constexpr std::array kModes{Mode{Dialect::Auto, false}, Mode{Dialect::Rs274, false},
                            Mode{Dialect::Rs274, true}, Mode{Dialect::Fanuc, false},
                            Mode{Dialect::Haas, false}, Mode{Dialect::Mach3, false}};

/// Returns the motions of `text`, one per line, without line numbers; diagnostics follow.
std::string motions_of(const std::string& text, const Mode& mode) {
    InterpreterOptions options;
    options.dialect = mode.dialect;
    options.strict = mode.strict;
    options.work_offsets_specified.fill(true);
    options.tools = {
        {.number = 1, .offset = {}, .length_specified = true, .diameter = Length::from_mm(6.0)},
        {.number = 2, .offset = {}, .length_specified = true, .diameter = Length::from_mm(1.0)}};
    std::string out;
    const Interpretation result = interpret({"p.nc", text}, options, [&](const Motion& motion) {
        std::string line;
        print(line, motion);
        out += line.substr(line.find(' ')) + '\n';
    });
    for (const Diagnostic& d : result.diagnostics) {
        if (d.severity == Severity::Error) out += "error " + std::string(d.code) + '\n';
    }
    return out;
}

/// Block: words of its modes, and words of its motion.
struct Written {
    std::vector<std::string> modes;
    std::string motion;
};

/// Random program and, for each block, the modal words in force before the block.
class Writer {
public:
    explicit Writer(unsigned seed) : random_(seed) {}

    void write() {
        add({"G21", "G90", "G17", "G94", "G54", "G49", "G80", "G40"}, "");
        in_force_ = {"G21", "G90", "G17", "G54", "G49", "G98"};
        add({"G98"}, "T1 M6");
        add({}, "M3 S1000 F200");
        add({}, "G0 X0 Y0 Z5");
        if (one_of(2) == 0) {
            contour();
        } else {
            holes();
        }
        add({}, "M30");
    }

    /// Returns the program; if `changed`, after changes that do not change a motion.
    std::string text(bool changed) {
        std::string out;
        int number = 10;
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            const Written& block = blocks_[i];
            if (!changed) {
                for (const std::string& mode : block.modes)
                    out += mode + ' ';
                out += block.motion + '\n';
                continue;
            }
            if (one_of(6) == 0) out += "(G1 X500)\n";
            if (one_of(8) == 0) out += '\n';
            if (one_of(3) == 0) out += "N" + std::to_string(number += 10) + ' ';
            const bool splits = one_of(3) == 0;
            for (const std::string& mode : block.modes)
                out += mode + (splits ? "\n" : " ");
            for (const std::string& mode : before_[i]) {
                if (one_of(3) != 0) continue;
                if (compensated_[i] && (mode == "G54" || mode == "G49" || mode == "G98")) continue;
                out += mode + (one_of(4) == 0 ? "\n" : " ");
            }
            out += block.motion;
            if (one_of(6) == 0) out += " (X1)";
            out += '\n';
        }
        return out;
    }

private:
    int one_of(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    std::string step(const char* letter) { return letter + std::to_string(one_of(61) - 30); }

    void add(std::vector<std::string> modes, std::string motion) {
        before_.push_back(modes.empty() ? in_force_ : std::vector<std::string>{});
        compensated_.push_back(is_compensated_);
        blocks_.push_back({std::move(modes), std::move(motion)});
    }

    void contour() {
        is_compensated_ = true;
        add({}, one_of(2) == 0 ? "G41 D1" : "G42 D1");
        int x = 0;
        int y = 0;
        const int moves = 3 + one_of(6);
        for (int i = 0; i < moves; ++i) {
            const int dx = (one_of(2) == 0 ? -1 : 1) * (10 + one_of(20));
            const int dy = (one_of(3) - 1) * (10 + one_of(20));
            x += dx;
            y += dy;
            std::string words = "X" + std::to_string(x) + " Y" + std::to_string(y);
            if (i > 0 && one_of(3) == 0) {
                words = (one_of(2) == 0 ? "G2 " : "G3 ") + words + " R60";
            } else {
                words = (one_of(5) == 0 && i > 0 ? "G0 " : "G1 ") + words;
            }
            add({}, words);
            if (one_of(6) == 0) add({}, "G1 Z-" + std::to_string(one_of(4)));
            if (one_of(8) == 0) add({}, "G4 P1");
        }
        add({}, "G40");
        is_compensated_ = false;
        add({}, "G0 X-50 Y-50");
        add({}, "G0 Z9");
    }

    void holes() {
        constexpr std::array kCycles{"G81", "G83", "G73", "G85"};
        const std::string cycle = kCycles[static_cast<std::size_t>(one_of(4))];
        add({}, cycle + " X1 Y2 Z-4 R2" + (cycle == "G83" || cycle == "G73" ? " Q1.5" : ""));
        in_force_ = {"G21", "G90", "G17", "G54", "G98"};
        const int holes = 1 + one_of(4);
        for (int i = 0; i < holes; ++i) {
            const std::string words =
                step("X") + (one_of(3) == 0 ? " R" + std::to_string(1 + one_of(4)) : "");
            add({}, words);
        }
        add({}, "G80");
        add({}, "G0 " + step("X") + " Z9");
    }

    std::mt19937 random_;
    std::vector<Written> blocks_;
    std::vector<std::vector<std::string>> before_;
    std::vector<bool> compensated_;
    std::vector<std::string> in_force_;
    bool is_compensated_ = false;
};

TEST(RedundantWords, ChangeNoMotion) {
    const char* wanted = std::getenv("NCSIM_REDUNDANT_PROGRAMS");
    const unsigned programs = wanted ? static_cast<unsigned>(std::atoi(wanted)) : 2000;
    int failures = 0;
    for (unsigned seed = 0; seed < programs && failures < 3; ++seed) {
        Writer writer(seed);
        writer.write();
        const std::string plain = writer.text(false);
        const std::string changed = writer.text(true);
        for (const Mode& mode : kModes) {
            const std::string before = motions_of(plain, mode);
            const std::string after = motions_of(changed, mode);
            if (before == after) continue;
            ++failures;
            ADD_FAILURE() << "program " << seed << " as " << name_of(mode.dialect)
                          << (mode.strict ? ", strict" : "") << '\n'
                          << plain << "--\n"
                          << changed << "--\n"
                          << before << "--\n"
                          << after;
            break;
        }
    }
}

// G17 must not restart the compensation, which would overcut walls by 3 mm.
TEST(RedundantWords, LeaveCompensationAsItIs) {
    const std::string head = "G21 G90 G17\nT1 M6\nF200\nG0 X-20 Y-20 Z5\nG41 D1\nG1 X0 Y-10\nY30\n";
    const std::string tail = "X30\nY0\nX-10\nG40\nM30\n";
    for (const Mode& mode : kModes) {
        const std::string plain = motions_of(head + tail, mode);
        for (const char* word : {"G17", "G21", "G90", "G17 G21", "G94 F200"})
            EXPECT_EQ(motions_of(head + word + ' ' + tail, mode), plain) << word;
        if (mode.strict) continue;
        for (const char* word : {"G54", "G49"})
            EXPECT_EQ(motions_of(head + word + ' ' + tail, mode), plain) << word;
    }
}

}  // namespace
}  // namespace ncsim::gcode
