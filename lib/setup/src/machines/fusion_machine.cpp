// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machine files of Fusion and HSMWorks (XML).
#include "machines/fusion_machine.h"

#include "machines/xml_root.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::setup {

namespace {

using tinyxml2::XMLElement;

// A unit in terms of mm, degrees, revolutions per minute or seconds.
struct FusionUnit {
    std::string_view name;
    double size = 1.0;
};

constexpr FusionUnit kLengths[] = {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}};
constexpr FusionUnit kAngles[] = {{"deg", 1.0}};
constexpr FusionUnit kRates[] = {{"mm/min", 1.0}, {"in/min", 25.4}, {"m/min", 1000.0}};
constexpr FusionUnit kSpeeds[] = {{"rpm", 1.0}};
constexpr FusionUnit kTimes[] = {{"s", 1.0}, {"min", 60.0}};

struct FusionAxis {
    machine::Joint joint;
    bool of_table = false;
};

class FusionReader {
public:
    explicit FusionReader(std::string name) : name_(std::move(name)) {}

    MachineFile read(const std::string& text) {
        tinyxml2::XMLDocument document;
        const XMLElement* root = xml_root(document, text, name_, "machine");
        for (const char* part : {"vendor", "model"}) {
            const XMLElement* e = root->FirstChildElement(part);
            const char* words = e ? e->GetText() : nullptr;
            if (words)
                file_.machine.name += (file_.machine.name.empty() ? "" : " ") + std::string(words);
        }
        for (const XMLElement* e = root->FirstChildElement("axis"); e;
             e = e->NextSiblingElement("axis")) {
            take_axis(e);
        }
        if (const XMLElement* e = root->FirstChildElement("spindle")) {
            file_.machine.min_rpm = positive(e, "minimumSpeed", kSpeeds);
            file_.machine.max_rpm = positive(e, "maximumSpeed", kSpeeds);
        }
        if (const XMLElement* e = root->FirstChildElement("capabilities"))
            file_.machine.max_feed = positive(e, "maximumFeedrate", kRates);
        if (const XMLElement* e = root->FirstChildElement("machiningTime")) {
            if (const auto seconds = positive(e, "toolChangeTime", kTimes))
                file_.machine.tool_change_seconds = *seconds;
        }
        for (const char letter : std::string_view("XYZ")) {
            if (!find(letter)) fail(root, fmt::format("no axis {}", letter));
        }
        finish();
        return std::move(file_);
    }

private:
    [[noreturn]] void fail(const XMLElement* at, const std::string& what) const {
        throw std::runtime_error(fmt::format("{}:{}: {}", name_, at->GetLineNum(), what));
    }

    // Reads exactly as many numbers as `numbers` has elements, each with a unit of `units`: "-800mm
    // 800mm", "0 0 1".
    void take_numbers(const XMLElement* e, const char* key, std::string_view rest,
                      std::span<const FusionUnit> units, std::span<double> numbers) const {
        constexpr double kMost = 1e7;
        for (double& number : numbers) {
            rest.remove_prefix(std::min(rest.find_first_not_of(" +"), rest.size()));
            const std::string_view word = rest.substr(0, rest.find(' '));
            rest.remove_prefix(word.size());
            const auto [end, error] =
                std::from_chars(word.data(), word.data() + word.size(), number);
            const std::string_view unit(end,
                                        word.size() - static_cast<std::size_t>(end - word.data()));
            const auto known = std::ranges::find(units, unit, &FusionUnit::name);
            const bool is_specified = unit.empty() ? units.empty() : known != units.end();
            if (error != std::errc{} || !is_specified || !(std::abs(number) <= kMost))
                fail(e, fmt::format("'{}': expected {} number{}{}", key, numbers.size(),
                                    numbers.size() == 1 ? "" : "s",
                                    units.empty()
                                        ? std::string()
                                        : fmt::format(" with a unit, as 1{}", units.front().name)));
            if (!unit.empty()) number *= known->size;
        }
        if (rest.find_first_not_of(' ') != std::string_view::npos)
            fail(e, fmt::format("'{}': more than {} numbers", key, numbers.size()));
    }

    // Reads a number that is not negative. Empty if it is 0 or missing.
    std::optional<double> positive(const XMLElement* e, const char* key,
                                   std::span<const FusionUnit> units) const {
        const char* specified = e->Attribute(key);
        if (!specified || !*specified) return std::nullopt;
        double value = 0.0;
        take_numbers(e, key, specified, units, {&value, 1});
        if (value < 0.0) fail(e, fmt::format("'{}': less than 0", key));
        return value > 0.0 ? std::optional(value) : std::nullopt;
    }

    Vec3 vector(const XMLElement* e, const char* key, std::span<const FusionUnit> units,
                Vec3 otherwise) const {
        const char* specified = e->Attribute(key);
        if (!specified || !*specified) return otherwise;
        double numbers[3] = {};
        take_numbers(e, key, specified, units, numbers);
        return {numbers[0], numbers[1], numbers[2]};
    }

    const FusionAxis* find(char letter) const {
        const auto found = std::ranges::find_if(
            axes_, [letter](const FusionAxis& axis) { return axis.joint.letter == letter; });
        return found == axes_.end() ? nullptr : &*found;
    }

    std::string word(const XMLElement* e, const char* key) const {
        const char* specified = e->Attribute(key);
        return specified ? specified : "";
    }

    void take_axis(const XMLElement* e) {
        const std::string name = word(e, "coordinate"), actuator = word(e, "actuator"),
                          link = word(e, "link");
        if (name.size() != 1 || std::string_view("XYZABC").find(name[0]) == std::string_view::npos)
            fail(e, "'coordinate': expected X, Y, Z, A, B or C");
        const char letter = name[0];
        const bool turns = letter <= 'C';
        if (actuator != (turns ? "rotational" : "linear"))
            fail(e, "'actuator': X, Y and Z are linear, A, B and C rotational");
        if (link != "head" && link != "table") fail(e, "'link': expected head or table");
        if (find(letter)) fail(e, fmt::format("axis {} is specified twice", letter));
        Vec3 own;
        own[letter - (turns ? 'A' : 'X')] = 1.0;
        const Vec3 direction = vector(e, "axis", {}, own);
        constexpr double kNothing = 1e-6;
        if (norm(direction) < kNothing) fail(e, "'axis': it has no length");
        if (!turns && norm(normalized(direction) - own) > 1e-9)
            fail(e, fmt::format("axis {}: only {} along itself is simulated", letter, letter));
        const Vec3 through = vector(e, "offset", kLengths, {});
        FusionAxis axis;
        axis.of_table = link == "table";
        axis.joint = machine::joint_of(
            letter, turns, direction, turns ? through : Vec3{},
            turns && axis.of_table ? machine::Positive::Part : machine::Positive::Tool);
        if (turns && norm(through) == 0.0) specified_.unspecified_pivots += letter;
        if (const std::string range = word(e, "range"); !range.empty()) {
            double ends[2] = {};
            take_numbers(e, "range", range,
                         turns ? std::span<const FusionUnit>(kAngles)
                               : std::span<const FusionUnit>(kLengths),
                         ends);
            if (ends[0] > ends[1]) fail(e, "'range': the first end must be below the second");
            if (ends[0] < ends[1] && turns) specified_.travels[letter] = {ends[0], ends[1]};
            if (ends[0] < ends[1] && !turns)
                file_.machine.travel[static_cast<std::size_t>(letter - 'X')] =
                    verify::AxisRange{ends[0], ends[1]};
        }
        if (!turns) {
            if (const auto rate = positive(e, "rapidFeed", kRates))
                file_.machine.rapid[static_cast<std::size_t>(letter - 'X')] = *rate;
        }
        axes_.push_back(axis);
    }

    // Orders joints from the part to the tool: axes of the table in reverse order, axes of the head
    // in the order of the file; linear axes are next to the bed.
    void finish() {
        std::vector<machine::Joint> joints;
        const auto add = [&joints](const FusionAxis& axis) { joints.push_back(axis.joint); };
        std::vector<FusionAxis> table, head;
        for (const bool turns : {false, true}) {
            for (const FusionAxis& axis : axes_) {
                if (axis.joint.turns == turns) (axis.of_table ? table : head).push_back(axis);
            }
        }
        std::ranges::reverse(table);
        std::ranges::for_each(table, add);
        std::ranges::for_each(head, add);
        specified_.chain.joints = std::move(joints);
        const bool turns =
            std::ranges::any_of(axes_, [](const FusionAxis& axis) { return axis.joint.turns; });
        if (turns) {
            specified_.guess =
                "tables turn the part, and heads the tool, by the right hand about their axes, and "
                "carry each other in the order of the file";
        }
        file_.kinematics = std::move(specified_);
    }

    std::string name_;
    MachineFile file_;
    SpecifiedKinematics specified_;
    std::vector<FusionAxis> axes_;
};

}  // namespace

MachineFile read_fusion_machine(const std::string& path, InputSet& inputs) {
    return FusionReader(name_of_input(path)).read(inputs.read(path, kMostSetUpBytes));
}

}  // namespace ncsim::setup
