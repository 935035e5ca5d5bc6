// SPDX-License-Identifier: GPL-3.0-or-later
//
// A refused block leaves the control unchanged: each code of the table, in each situation below,
// followed by words that are refused after all further words have been executed.
#include "ncsim/gcode/parser.h"

#include "control/codes.h"
#include "control/controller.h"
#include "program/block_resolver.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

InterpreterOptions options_of(const Rules& rules) {
    InterpreterOptions options;
    options.strict = rules.strict;
    options.work_offsets[1].x = Length::from_mm(100);
    options.homes[0].z = Length::from_mm(300);
    options.tools = {{.number = 1,
                      .offset = {Length(), Length(), Length::from_mm(50)},
                      .length_specified = true,
                      .diameter = Length::from_mm(4)}};
    return options;
}

// Control without a runner: executes lines one by one.
class Bench {
public:
    explicit Bench(const Rules& rules)
        : rules_(rules),
          options_(options_of(rules)),
          path_(options_, sink_, log_, result_),
          machine_(options_, rules_, centres_, log_, path_, parameters_),
          resolver_(rules_, parameters_, log_, options_) {
        parameters_.set_rules(rules);
    }

    // Executes lines up to the first refused line; returns false if a line is refused.
    bool run(const std::string& lines) {
        const SourceFile file{"", lines};
        BlockReader reader(file, {.strict = rules_.strict});
        Block block;
        Command command;
        while (reader.next(block, log_)) {
            if (block.words.empty()) continue;
            if (!resolver_.resolve(block, command)) return false;
            if (!machine_.execute(command)) return false;
        }
        return true;
    }

    Controller& machine() { return machine_; }
    std::uint64_t motions() const { return path_.count(); }

private:
    Rules rules_;
    InterpreterOptions options_;
    ArcCentres centres_;
    MotionSink sink_;
    DiagnosticLog log_;
    Interpretation result_;
    Path path_;
    Parameters parameters_;
    Controller machine_;
    Resolver resolver_;
};

struct Situation {
    const char* program;
    bool flush;  // true: moves that wait for the next move are flushed before the block
};

// Situations in which a control can meet the block.
constexpr Situation kSituations[] = {
    {"G0 X0 Y0 Z0", false},
    {"G55 G43 H1 G92 X5 Y6\nG38.2 Z-2", false},
    {"G81 X1 Y1 Z-1 R1", false},
    {"G41 D1 G1 X20\nX40", false},
    {"G41 D1 G1 X20\nX40\nZ1", true},
    {"G1 X10 ,R2", false},
    {"G1 ,A30", true},
    {"G5.2 X1 Y1 P1 L3\nG5.2 X2 Y2 P1", false},
    {"G6.2 P3 X1 Y1 K0 R1\nG6.2 X2 Y1 K0", false},
    {"G68 X1 Y1 R30\nG16", false},
    {"G5 I1 J2 P1 Q-1 X5 Y5", false},
    {"G20 G91 G95 G18 G99 M3 S100", false},
};

// Words that a code may need.
constexpr const char* kWords[] = {"", " X1 Y2 Z-3 R4", " X2 I1 J2 K3 P2 Q1 L2 D1 H1 F5 S9 T2"};

// Words that are refused late: an arc, a pocket, a curve, a probing move, a cycle; a pattern of
// holes.
constexpr const char* kTails[] = {" G2 X5",  " G13",    " G5.3",   " G38.2", " G81",
                                  " G53 G3", " G70 I5", " G1 F-1", " R-1",   ""};

std::vector<Rules> controls() {
    return {Rules::of(Dialect::Rs274, true), Rules::of(Dialect::Rs274, false),
            Rules::of(Dialect::Fanuc, false), Rules::of(Dialect::Haas, false)};
}

// True if the line was refused without a motion; then the control must be unchanged.
bool is_refused_without_a_trace(const Rules& rules, const Situation& situation,
                                const std::string& line) {
    Bench bench(rules);
    bench.run("G21 G90 G17 F100\nG0 X0 Y0 Z0\n");
    bench.run(situation.program);
    if (situation.flush) bench.machine().flush();
    const ControlState before = bench.machine().control();
    const std::uint64_t motions = bench.motions();
    if (bench.run(line) || bench.motions() != motions) return false;
    ControlState without_curve = before;
    without_curve.curve = {};
    const ControlState& after = bench.machine().control();
    EXPECT_TRUE(after == before || after == without_curve)
        << situation.program << "\n"
        << line << "\nby " << name_of(rules.dialect) << (rules.strict ? ", strict" : "");
    return true;
}

TEST(RefusedBlock, LeavesTheControlAsItWasWhateverItsCodes) {
    const std::vector<Code> codes = {
#define NCSIM_G(name, group, takes_axes, letters, availability) Code::name,
#include "control/codes.def"
#undef NCSIM_G
    };
    std::map<Code, int> refused;
    for (const Rules& rules : controls()) {
        for (const Situation& situation : kSituations) {
            for (const Code code : codes) {
                for (const char* words : kWords) {
                    for (const char* tail : kTails) {
                        const std::string line = std::string(name_of(code)) + words + tail;
                        refused[code] += is_refused_without_a_trace(rules, situation, line);
                    }
                }
            }
        }
    }
    // Each code was refused often enough, so no code passes because it was never refused.
    for (const Code code : codes)
        EXPECT_GE(refused[code], 20) << name_of(code);
}

// Many codes in a block: at most one per group, chosen by a generator with a fixed seed.
TEST(RefusedBlock, LeavesTheControlAsItWasWhateverItIsComposedOf) {
    struct Entry {
        Code code;
        Group group;
    };
    const std::vector<Entry> codes = {
#define NCSIM_G(name, group, takes_axes, letters, availability) {Code::name, Group::group},
#include "control/codes.def"
#undef NCSIM_G
    };
    std::uint32_t seed = 20261122;
    const auto below = [&](std::size_t n) {
        seed = seed * 1664525U + 1013904223U;
        return static_cast<std::size_t>(seed >> 8) % n;
    };
    constexpr const char* kOthers[] = {" M3", " M5",  " T2 M6", " T3", " S500",    " F7",
                                       " X1", " Y-2", " Z3",    " A5", " I1 J0.5", " R2",
                                       " K1", " P1",  " L2",    " H1", " D1",      " M0"};
    int refused = 0;
    for (int round = 0; round < 20'000; ++round) {
        std::string line;
        std::set<Group> groups;
        for (std::size_t i = 0, n = 1 + below(4); i < n; ++i) {
            const Entry& entry = codes[below(codes.size())];
            if (entry.group == Group::Ignored || !groups.insert(entry.group).second) continue;
            line += " " + std::string(name_of(entry.code));
        }
        for (std::size_t i = 0, n = below(5); i < n; ++i)
            line += kOthers[below(std::size(kOthers))];
        if (below(2) == 0) line += kTails[below(std::size(kTails))];
        const std::vector<Rules> all = controls();
        refused += is_refused_without_a_trace(all[below(all.size())],
                                              kSituations[below(std::size(kSituations))], line);
    }
    EXPECT_GE(refused, 5000);
}

}  // namespace
}  // namespace ncsim::gcode
