// SPDX-License-Identifier: GPL-3.0-or-later
//
// Generator of random NC programs, and simulation of the programs.
#include "support/random_programs.h"

#include "ncsim/cda/shape.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/toolpath/tool_spec.h"
#include "ncsim/toolpath/walk.h"

#include "support/random_shapes.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <initializer_list>
#include <memory>
#include <stdexcept>

namespace ncsim::test {

namespace {

// Lengths in units of 10 nm, so the result is independent of the printing of numbers.
using Length = std::int64_t;
constexpr Length kMm = 100000;

std::string to_text(Length length) {
    const std::string whole = std::to_string(std::abs(length) / kMm);
    const std::string rest = std::to_string(std::abs(length) % kMm);
    std::string text = length < 0 ? "-" : "";
    text += whole;
    text += '.';
    text.append(5 - rest.size(), '0');
    return text + rest;
}

std::string to_text(const std::array<Length, 3>& p) {
    return to_text(p[0]) + "," + to_text(p[1]) + "," + to_text(p[2]);
}

class Writer {
public:
    Writer(std::uint64_t seed, bool rotary) : random_(seed), rotary_(rotary) {}

    NcProgram run() {
        choose_stock();
        choose_tools();
        // Coarser tolerances for large parts, so the running time does not grow with the size.
        const double coarse = largest_size() > 30 * kMm ? 5.0 : 1.0;
        program_.tolerance_mm = coarse * one_of({0.006, 0.02, 0.05});
        program_.tool_tolerance_mm = coarse * one_of({0.01, 0.05, 0.1});
        line("G21 G90 G17 G94");
        for (std::int64_t visits = random_.between(1, 3); visits > 0; --visits)
            use_a_tool();
        line("M30");
        return std::move(program_);
    }

private:
    enum Axis : std::size_t { X, Y, Z };

    template <typename T>
    T one_of(std::initializer_list<T> choices) {
        return choices.begin()[random_.next() % choices.size()];
    }
    bool happens(int percent) { return random_.between(1, 100) <= percent; }

    void line(const std::string& text) { program_.text += text + "\n"; }

    // Rounds to a random unit, mostly to few decimals.
    Length rounded(Length length) {
        const Length unit = one_of({kMm, kMm / 10, kMm / 100, kMm / 1000, Length{1}});
        return (length + unit / 2) / unit * unit;
    }

    void choose_stock() {
        for (const Axis axis : {X, Y, Z}) {
            const Length base = one_of({1, 5, 10, 20, 40, 100}) * kMm;
            const Length size = rounded(random_.between(base / 2, base + base / 2));
            size_[axis] = std::clamp(size, kMm / 2, axis == Z ? 30 * kMm : 150 * kMm);
        }
        const Length far = one_of(
            {Length{0}, Length{0}, 37 * kMm + 37000, 300 * kMm, 700 * kMm, -450 * kMm - 50000});
        for (const Axis axis : {X, Y, Z}) {
            corner_[axis] = rounded(random_.between(-30 * kMm, 30 * kMm));
            if (happens(70)) corner_[axis] += far;
        }
        std::array<Length, 3> end{};
        for (const Axis axis : {X, Y, Z})
            end[axis] = corner_[axis] + size_[axis];
        program_.stock = to_text(corner_) + ":" + to_text(end);
        unit_ = one_of({kMm, kMm / 10, kMm / 100, kMm / 1000});
        clear_ = end[Z] + 5 * kMm;
    }

    void choose_tools() {
        const Length room = std::min(size_[X], size_[Y]);
        const std::int64_t count = random_.between(1, 3);
        for (std::int64_t number = 1; number <= count; ++number) {
            const Length diameter =
                std::max(kMm / 10, rounded(random_.between(room / 10, 4 * room / 5)));
            const std::string kind =
                one_of({"flat", "flat", "ball", "bull", "v", "taper", "drill"});
            std::string tool = "T";
            tool += std::to_string(number) + "=" + kind + ":D" + to_text(diameter);
            tool += ":L" + to_text(2 * largest_size() + diameter);
            if (kind == "bull") tool += ":R" + to_text(std::max(kMm / 100, diameter / 5));
            if (kind == "v") tool += one_of({":A30", ":A60", ":A86", ":A90", ":A120"});
            if (kind == "taper") tool += one_of({":A1", ":A3", ":A7.5"});
            if (kind == "drill") tool += one_of({":A90", ":A118", ":A140"});
            program_.tools.push_back(tool);
            diameters_.push_back(diameter);
        }
    }
    Length largest_size() const { return std::max({size_[X], size_[Y], size_[Z]}); }

    // Returns a coordinate near the stock: on a face of the stock, at an earlier position of the
    // tool, or close to such a position.
    Length place(Axis axis) {
        const Length low = corner_[axis];
        const Length high = low + size_[axis];
        const std::int64_t kind = random_.between(0, 99);
        if (kind < 15) return one_of({low, high});
        if (kind < 35 && !places_.empty()) {
            const Length there = places_[random_.next() % places_.size()][axis];
            if (kind < 25) return there;
            const Length beside =
                one_of({diameter_, diameter_ / 2, Length{100}, Length{10}, Length{1}});
            return happens(50) ? there + beside : there - beside;
        }
        const Length margin = size_[axis] / 10;
        return random_.between(low - margin, high + margin) / unit_ * unit_;
    }

    // Appends a word. Separate statements fix the order of the random draws; the order of
    // evaluation within an expression depends on the compiler.
    static void add(std::string& block, const char* letter, Length value) {
        block += letter;
        block += to_text(value);
    }

    void move_to(std::string block, std::initializer_list<Axis> axes) {
        constexpr std::array<const char*, 3> kLetters{" X", " Y", " Z"};
        for (const Axis axis : axes)
            add(block, kLetters[axis], at_[axis]);
        line(block);
    }
    void rise() {
        at_[Z] = clear_;
        move_to("G0", {Z});
    }
    void plunge() {
        at_[Z] = place(Z);
        move_to("G1", {Z});
    }

    void use_a_tool() {
        const std::size_t tool = random_.next() % diameters_.size();
        diameter_ = diameters_[tool];
        std::string change = "T";
        change += std::to_string(tool + 1);
        line(change + " M6");
        line("S1000 M3 F500");
        at_ = {place(X), place(Y), clear_};
        move_to(rotary_ ? "G0 A0 B0 C0" : "G0", {X, Y, Z});
        for (std::int64_t moves = random_.between(1, 6); moves > 0; --moves) {
            const std::int64_t kind = random_.between(0, 99);
            if (kind < 15) {
                drill();
            } else if (kind < 35) {
                arc();
            } else if (kind < 45) {
                raster();
            } else {
                straight();
            }
        }
        rise();
    }

    void drill() {
        at_ = {place(X), place(Y), place(Z)};
        std::string block = one_of({"G81", "G83", "G73"});
        add(block, " R", clear_ - 4 * kMm);
        add(block, " Q", std::max(kMm / 2, size_[Z] / 3));
        move_to(block, {X, Y, Z});
        if (happens(50)) {
            std::string next;
            add(next, "X", place(X));
            line(next);
        }
        line("G80");
        rise();
        move_to("G0", {X, Y});
    }

    // Writes a full circle or a turn of a helix.
    void arc() {
        plunge();
        std::string block = one_of({"G2", "G3"});
        const Length radius = random_.between(1, 5) * std::min(size_[X], size_[Y]) / 5;
        add(block, " I", std::max(kMm / 10, rounded(radius)));
        add(block, " J", 0);
        if (happens(30)) at_[Z] = place(Z);
        move_to(block, {X, Y, Z});
    }

    // Writes parallel passes that overlap, touch, or leave a wall of 10 nm or 1 µm.
    void raster() {
        plunge();
        const Length step =
            one_of({diameter_, diameter_ / 2, 9 * diameter_ / 10, diameter_ + 100, diameter_ + 1});
        for (std::int64_t pass = random_.between(2, 4); pass > 0; --pass) {
            at_[X] = corner_[X] + (pass % 2 == 0 ? size_[X] : 0);
            move_to("G1", {X});
            at_[Y] += step;
            move_to("G1", {Y});
        }
        rise();
    }

    void straight() {
        std::string block = "G1";
        if (rotary_) {
            for (const char* axis : {" A", " B", " C"}) {
                if (!happens(25)) continue;
                block += axis;
                block += one_of({"5", "10", "15", "30", "45", "90", "-20", "-90", "180", "33.3"});
            }
        }
        if (happens(80)) at_[X] = place(X);
        if (happens(80)) at_[Y] = place(Y);
        if (happens(60)) at_[Z] = place(Z);
        move_to(block, {X, Y, Z});
        places_.push_back(at_);
    }

    Random random_;
    bool rotary_;
    NcProgram program_;
    std::array<Length, 3> corner_{}, size_{}, at_{};
    Length clear_ = 0;     // height above the stock
    Length unit_ = 1;      // unit of most coordinates
    Length diameter_ = 0;  // diameter of the current tool
    std::vector<Length> diameters_;
    std::vector<std::array<Length, 3>> places_;  // earlier positions of the tool
};

}  // namespace

NcProgram random_program(std::uint64_t seed, bool rotary) {
    return Writer(seed, rotary).run();
}

MilledPart mill(const NcProgram& program, const cda::WorkpieceModel& prototype) {
    std::string message;
    const auto stock = toolpath::parse_stock_option(program.stock, message);
    if (!stock) throw std::runtime_error(message);
    const cda::Shape shape = toolpath::stock_shape(*stock, program.tool_tolerance_mm);
    const std::unique_ptr<cda::WorkpieceModel> part = cda::create(prototype, shape);
    toolpath::SamplingOptions sampling;
    sampling.chord_tolerance_mm = program.tolerance_mm;
    sampling.rotation_miss_mm = program.tolerance_mm;
    sampling.rotation_gain_mm = 10 * program.tolerance_mm;
    toolpath::Walk walk(shape.lattice, stock->box, {{program.tool_tolerance_mm}, sampling});
    for (const std::string& text : program.tools) {
        const auto spec = toolpath::parse_tool_option(text, message);
        if (!spec) throw std::runtime_error(message);
        walk.add_tool(spec->number, toolpath::make_tool(*spec, 100.0));
    }
    MilledPart result;
    result.provenance.program = "random.nc";
    result.provenance.entries.push_back({});
    const auto read =
        gcode::interpret({"random.nc", program.text}, {}, [&](const gcode::Motion& motion) {
            const cda::Origin origin{static_cast<std::uint32_t>(result.provenance.entries.size())};
            walk.take(motion, origin,
                      [&](const toolpath::Step& step) { part->subtract_unmeasured(step.cells); });
            result.provenance.entries.push_back(
                {motion.span.line, static_cast<std::uint32_t>(std::max(0, motion.tool))});
        });
    if (gcode::has_errors(read.diagnostics)) throw std::runtime_error("the program has errors");
    result.boundary = part->boundary();
    result.volume = part->volume();
    return result;
}

}  // namespace ncsim::test
