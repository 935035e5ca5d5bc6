// SPDX-License-Identifier: GPL-3.0-or-later
//
// Configurations of LinuxCNC: INI file, HAL files, and subroutines of REMAPs.
#include "machines/linuxcnc_machine.h"

#include "ncsim/base/ascii.h"
#include "ncsim/base/number_text.h"
#include "ncsim/machine/presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace ncsim::setup {

namespace {

using gcode::Coordinates;
using machine::joint_of;
using machine::Positive;

constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};
constexpr double kSecondsPerMinute = 60.0;
constexpr std::size_t kMostEntries = 100'000;

// A value with its place in a file.
struct Entry {
    std::string section, key, value;
    std::string file;
    std::size_t line = 0;
};

[[noreturn]] void fail(const Entry& at, const std::string& what) {
    throw std::runtime_error(fmt::format("{}:{}: {}", at.file, at.line, what));
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    for (text = trimmed(text); !text.empty();) {
        const std::size_t end = std::min(text.find_first_of(" \t\r"), text.size());
        words.emplace_back(text.substr(0, end));
        text = trimmed(text.substr(end));
    }
    return words;
}

std::optional<double> number_of(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto value = number_in<double>(text);
    constexpr double kLargestValue = 1e9;
    return value && std::abs(*value) <= kLargestValue ? value : std::nullopt;
}

std::vector<Entry> entries_of(const std::string& name, const std::string& text) {
    std::vector<Entry> entries;
    std::string section;
    std::size_t line = 0;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view whole = trimmed(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        ++line;
        const Entry at{section, {}, {}, name, line};
        if (whole.starts_with("#INCLUDE")) fail(at, "#INCLUDE is not followed");
        if (whole.empty() || whole[0] == '#' || whole[0] == ';') continue;
        if (whole[0] == '[') {
            if (!whole.ends_with(']')) fail(at, "expected ] at the end of the section");
            section = whole.substr(1, whole.size() - 2);
            continue;
        }
        const std::size_t equals = whole.find('=');
        if (equals == std::string_view::npos) fail(at, "expected KEY = VALUE");
        if (entries.size() >= kMostEntries) fail(at, "more lines than a configuration has");
        entries.push_back({section, std::string(trimmed(whole.substr(0, equals))),
                           std::string(trimmed(whole.substr(equals + 1))), name, line});
    }
    return entries;
}

// Values of pins that HAL files set.
class Hal {
public:
    void take(const Entry& at, std::string_view command) {
        const std::vector<std::string> words = words_of(command.substr(0, command.find('#')));
        if (words.size() < 2) return;
        if (words[0] == "net") {
            for (std::size_t i = 2; i < words.size(); ++i) {
                if (words[i].find_first_of("<>") == std::string::npos)
                    signals_[words[i]] = words[1];
            }
        } else if (words.size() == 3 && (words[0] == "setp" || words[0] == "sets")) {
            values_[words[1]] = {words[2], at};
        }
    }

    // Returns the value of a pin, mm or degrees; 0 if it is not set.
    double value(const std::string& pin) const {
        const auto signal = signals_.find(pin);
        auto specified = values_.find(signal == signals_.end() ? pin : signal->second);
        if (specified == values_.end()) specified = values_.find(pin);
        if (specified == values_.end()) return 0.0;
        const auto number = number_of(specified->second.first);
        if (!number) fail(specified->second.second, fmt::format("{}: expected a number", pin));
        return *number;
    }
    bool is_set(const std::string& pin) const {
        const auto signal = signals_.find(pin);
        return values_.contains(pin) ||
               (signal != signals_.end() && values_.contains(signal->second));
    }

private:
    std::map<std::string, std::string> signals_;  // by pin
    std::map<std::string, std::pair<std::string, Entry>> values_;
};

class Configuration {
public:
    Configuration(const std::string& path, InputSet& inputs)
        : inputs_(inputs),
          folder_(std::filesystem::path(path).parent_path().string()),
          entries_(entries_of(name_of_input(path), inputs.read(path, kMostSetUpBytes))) {
        for (const Entry& entry : entries_) {
            if (entry.section != "HAL") continue;
            if (entry.key == "HALCMD") hal_.take(entry, entry.value);
            if (entry.key == "HALFILE" || entry.key == "POSTGUI_HALFILE") read_hal(entry);
        }
    }

    const Entry* find(std::string_view section, std::string_view key) const {
        const auto found = std::ranges::find_if(
            entries_, [&](const Entry& e) { return e.section == section && e.key == key; });
        return found == entries_.end() ? nullptr : &*found;
    }
    std::optional<double> number(std::string_view section, std::string_view key) const {
        const Entry* entry = find(section, key);
        if (!entry) return std::nullopt;
        // A remark may follow the value.
        const std::string_view value = std::string_view(entry->value);
        const auto number = number_of(trimmed(value.substr(0, value.find_first_of("#;"))));
        if (!number) fail(*entry, fmt::format("{}: expected a number", key));
        return number;
    }
    const std::vector<Entry>& entries() const { return entries_; }
    const Hal& hal() const { return hal_; }

    // Returns the text of the subroutine `name` on the paths of the configuration; empty if there
    // is none.
    std::string subroutine(const std::string& name) const {
        const Entry* paths = find("RS274NGC", "SUBROUTINE_PATH");
        std::string_view rest = paths ? std::string_view(paths->value) : ".";
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(':'), rest.size());
            std::string file(trimmed(rest.substr(0, end)));
            rest.remove_prefix(std::min(end + 1, rest.size()));
            file.append("/").append(name).append(".ngc");
            const std::string path = seen_in(folder_, file);
            if (inputs_.is_there(path)) return inputs_.read(path, kMostSetUpBytes);
        }
        return {};
    }

private:
    void read_hal(const Entry& entry) {
        // HAL files of the installation and Tcl scripts do not describe the machine.
        if (entry.value.starts_with("LIB:") || !entry.value.ends_with(".hal")) return;
        const std::string path = seen_in(folder_, entry.value);
        // A file for the picture of the machine may be missing.
        if (entry.key == "POSTGUI_HALFILE" && !inputs_.is_there(path)) return;
        const std::string text = inputs_.read(path, kMostSetUpBytes);
        std::size_t line = 0;
        for (std::string_view rest = text; !rest.empty();) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            hal_.take({{}, {}, {}, name_of_input(path), ++line}, rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }

    InputSet& inputs_;
    std::string folder_;
    std::vector<Entry> entries_;
    Hal hal_;
};

std::vector<machine::Joint> linear() {
    return {joint_of('X', false, kX), joint_of('Y', false, kY), joint_of('Z', false, kZ)};
}

// Returns the chain of `part` (from the part on), X, Y, Z, and `head` (to the tool).
machine::Chain chain_of(std::vector<machine::Joint> part,
                        const std::vector<machine::Joint>& head = {}) {
    for (const machine::Joint& joint : linear())
        part.push_back(joint);
    part.insert(part.end(), head.begin(), head.end());
    return {std::move(part)};
}

// Returns a position given by three pins, such as x-rot-point.
Vec3 place(const Hal& hal, const std::string& kins, const std::string& what) {
    return {hal.value(kins + ".x-" + what), hal.value(kins + ".y-" + what),
            hal.value(kins + ".z-" + what)};
}

// Returns the chain of a tilting table. LinuxCNC specifies the position of C, and the cradle's axis
// relative to C.
machine::Chain tilting_table(const Hal& hal, const std::string& kins, char cradle) {
    const Positive sign =
        hal.value(kins + ".conventional-directions") != 0.0 ? Positive::Tool : Positive::Part;
    const Vec3 point = place(hal, kins, "rot-point");
    return chain_of(
        {joint_of('C', true, kZ, point, sign), joint_of(cradle, true, cradle == 'A' ? kX : kY,
                                                        point + place(hal, kins, "offset"), sign)});
}

machine::Chain nutating_head(const Hal& hal, const std::string& kins) {
    const std::string angle = kins + ".nut-angle";
    const double degrees = hal.is_set(angle) ? hal.value(angle) : 45.0;
    const gcode::Triple lean = gcode::turn_about(0, -degrees).direction_to_parent({0, 0, 1});
    const double y = hal.value(kins + ".y-pivot"), z = hal.value(kins + ".z-pivot");
    const Vec3 table{0, hal.value(kins + ".y-rot-axis"), hal.value(kins + ".z-rot-axis")};
    const Vec3 fork{hal.value(kins + ".x-offset"), y + hal.value(kins + ".y-offset"), 0};
    return chain_of({joint_of('A', true, kX, table)},
                    {joint_of('C', true, kZ, fork),
                     joint_of('B', true, {lean[0], lean[1], lean[2]}, {0, y, z})});
}

std::optional<machine::Chain> chain_of(const Configuration& c, const Entry& kinematics) {
    const std::vector<std::string> words = words_of(kinematics.value);
    const std::string name = words.empty() ? "" : words[0];
    const Hal& hal = c.hal();
    if (name == "trivkins") return std::nullopt;
    if (name == "xyzac-trt-kins") return tilting_table(hal, name, 'A');
    if (name == "xyzbc-trt-kins") return tilting_table(hal, name, 'B');
    if (name == "xyzab_tdr_kins") {
        const Vec3 point = place(hal, name, "rot-point");
        return chain_of({joint_of('A', true, kX, point + place(hal, name, "offset")),
                         joint_of('B', true, kY, point)});
    }
    if (name == "5axiskins") {
        const std::string pin = name + ".pivot-length";
        const Vec3 pivot{0, 0, hal.is_set(pin) ? hal.value(pin) : 250.0};
        return chain_of(
            {}, {joint_of('C', true, kZ, pivot), joint_of('B', true, kY, pivot, Positive::Part),
                 machine::along_tool('W')});
    }
    if (name == "xyzacb_trsrn") return nutating_head(hal, name + "_kins");
    fail(kinematics,
         fmt::format("KINEMATICS: '{}' is not known; expected trivkins, xyzac-trt-kins, "
                     "xyzbc-trt-kins, xyzab_tdr_kins, 5axiskins or xyzacb_trsrn",
                     name));
}

// Returns the number of the kinematics that a subroutine of a REMAP chooses: the digit after the
// words that choose it.
std::optional<std::size_t> choice_in(const std::string& text) {
    std::string dense;
    for (const char c : text) {
        if (!is_blank(c)) dense += lower(c);
    }
    for (const std::string_view words : {"#<kinstype>=", "g12.1p", "m68e3q"}) {
        const std::size_t at = dense.find(words);
        if (at == std::string::npos || at + words.size() >= dense.size()) continue;
        const char digit = dense[at + words.size()];
        if (digit >= '0' && digit <= '9') return static_cast<std::size_t>(digit - '0');
    }
    return std::nullopt;
}

// Reads a REMAP: "M428 modalgroup=10 ngc=428remap".
void take_remap(const Configuration& c, const Entry& entry, gcode::TipControl& control) {
    const std::vector<std::string> words = words_of(entry.value);
    if (words.empty() || words[0].size() < 2 || words[0][0] != 'M') return;
    const auto code = number_of(std::string_view(words[0]).substr(1));
    constexpr double kFirst = 100, kLast = 9999;
    if (!code || *code < kFirst || *code > kLast || *code != std::floor(*code)) return;
    for (const std::string& word : words) {
        if (!word.starts_with("ngc=")) continue;
        const auto choice = choice_in(c.subroutine(word.substr(4)));
        if (choice && *choice < control.kinematics.size())
            control.m_codes[static_cast<int>(*code)] = control.kinematics[*choice];
    }
}

}  // namespace

MachineFile read_linuxcnc_machine(const std::string& path, InputSet& inputs) {
    const Configuration c(path, inputs);
    MachineFile file;
    const Entry* kinematics = c.find("KINS", "KINEMATICS");
    if (!kinematics)
        throw std::runtime_error(name_of_input(path) + ": [KINS] KINEMATICS is not there");
    if (const Entry* name = c.find("EMC", "MACHINE")) file.machine.name = name->value;
    const Entry* units = c.find("TRAJ", "LINEAR_UNITS");
    const bool inches =
        units && (units->value == "inch" || units->value == "in" || units->value == "imperial");
    const double unit = inches ? 25.4 : 1.0;
    auto chain = chain_of(c, *kinematics);
    if (chain) {
        for (machine::Joint& joint : chain->joints)
            joint.through = unit * joint.through;
        file.kinematics.emplace();
        file.kinematics->chain = std::move(*chain);
        // Kinematics 0 are active at the start.
        const std::string& words = kinematics->value;
        const bool first_is_tip = words.find("identityfirst") == std::string::npos &&
                                  (words.find("trt") != std::string::npos ||
                                   words.find("5axiskins") != std::string::npos);
        file.tip_control.kinematics = {Coordinates::Axes, Coordinates::Tip};
        if (first_is_tip) std::ranges::reverse(file.tip_control.kinematics);
        file.tip_control.at_start = file.tip_control.kinematics.front();
    }
    for (const char letter : std::string_view("XYZABC")) {
        const std::string section = std::string("AXIS_") + letter;
        const auto low = c.number(section, "MIN_LIMIT"), high = c.number(section, "MAX_LIMIT");
        const auto speed = c.number(section, "MAX_VELOCITY");
        const auto acceleration = c.number(section, "MAX_ACCELERATION");
        if (low && high && !(*low < *high))
            fail(*c.find(section, "MAX_LIMIT"), "MAX_LIMIT must be above MIN_LIMIT");
        if (letter >= 'X') {
            const auto i = static_cast<std::size_t>(letter - 'X');
            if (low && high) file.machine.travel[i] = verify::AxisRange{unit * *low, unit * *high};
            if (speed && *speed > 0.0) file.machine.rapid[i] = unit * *speed * kSecondsPerMinute;
            if (acceleration && *acceleration > 0.0)
                file.machine.acceleration[i] = unit * *acceleration;
            continue;
        }
        const auto i = static_cast<std::size_t>(letter - 'A');
        if (low && high && file.kinematics && file.kinematics->chain.find(letter))
            file.kinematics->travels[letter] = {*low, *high};
        if (c.number(section, "WRAPPED_ROTARY").value_or(0.0) != 0.0)
            file.rotary_ways[i] = gcode::RotaryWay::Sign;
    }
    for (const Entry& entry : c.entries()) {
        if (entry.section == "RS274NGC" && entry.key == "REMAP")
            take_remap(c, entry, file.tip_control);
    }
    return file;
}

}  // namespace ncsim::setup
