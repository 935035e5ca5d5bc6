// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machine files of FreeCAD: JSON with line numbers for messages.
#include "machines/freecad_machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

namespace {

using nlohmann::json;

constexpr double kLargest = 1e6;

// Iterator that counts lines; each character is read once.
class LineCount {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    LineCount(const char* at, std::size_t* line) : at_(at), line_(line) {}
    reference operator*() const { return *at_; }
    LineCount& operator++() {
        if (*at_++ == '\n') ++*line_;
        return *this;
    }
    LineCount operator++(int) {
        const LineCount old = *this;
        ++*this;
        return old;
    }
    bool operator==(const LineCount& other) const { return at_ == other.at_; }

private:
    const char* at_;
    std::size_t* line_;
};

// Line of each key of an object, by "machine: axes: X". Keys within lists belong to the list, and
// the first of equal keys counts. Long or deep keys are not recorded, because no reader needs them
// and they could make the memory grow.
class KeyLines : public nlohmann::json_sax<json> {
public:
    explicit KeyLines(const std::string& text) {
        json::sax_parse(LineCount(text.data(), &line_),
                        LineCount(text.data() + text.size(), &line_), this);
    }
    // Returns the line of `path`, or of the nearest key above.
    std::size_t line_of(std::string path) const {
        while (!path.empty()) {
            const auto found = lines_.find(path);
            if (found != lines_.end()) return found->second;
            const std::size_t end = path.rfind(": ");
            path.resize(end == std::string::npos ? 0 : end);
        }
        return 1;
    }
    // Returns the parse error; empty if there is none.
    const std::string& fault() const { return fault_; }
    std::size_t last_line() const { return line_; }

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override {
        open_.push_back(open_.size() < kDeepest ? key_ : std::string());
        return true;
    }
    bool key(string_t& name) override {
        const std::string& above = open_.back();
        key_ = above;
        if (open_.size() > kDeepest || above.size() + name.size() > kLongest) return true;
        if (!above.empty()) key_ += ": ";
        key_ += name;
        lines_.try_emplace(key_, line_);
        return true;
    }
    bool end_object() override {
        key_ = std::move(open_.back());
        open_.pop_back();
        return true;
    }
    bool start_array(std::size_t size) override { return start_object(size); }
    bool end_array() override { return end_object(); }
    bool parse_error(std::size_t, const std::string&, const json::exception& e) override {
        fault_ = e.what();
        return false;
    }

private:
    static constexpr std::size_t kDeepest = 8, kLongest = 200;

    std::size_t line_ = 1;
    std::map<std::string, std::size_t> lines_;
    std::vector<std::string> open_;  // paths of the open objects and lists
    std::string key_;
    std::string fault_;
};

// Name and lines of the file, for messages.
struct Source {
    std::string name;
    KeyLines lines;
};

// A value and its path, for messages.
class Node {
public:
    Node(const json& value, std::string path, const Source& source)
        : value_(value), path_(std::move(path)), source_(source) {}

    [[noreturn]] void fail(std::string_view what) const {
        throw std::runtime_error(fmt::format("{}:{}: {}{}{}", source_.name,
                                             source_.lines.line_of(path_), path_,
                                             path_.empty() ? "" : ": ", what));
    }
    bool has(const char* key) const {
        return value_.is_object() && value_.contains(key) && !value_[key].is_null();
    }
    Node operator[](const char* key) const {
        if (!has(key)) fail(fmt::format("expected '{}'", key));
        return {value_[key], path_.empty() ? key : fmt::format("{}: {}", path_, key), source_};
    }
    double number() const {
        const double value = value_.is_number() ? value_.get<double>() : kLargest * 10;
        if (!(std::abs(value) <= kLargest)) fail("expected a number, at most 1000000");
        return value;
    }
    std::string text() const {
        if (!value_.is_string()) fail("expected a text");
        return value_.get<std::string>();
    }
    Vec3 vector() const {
        if (!value_.is_array() || value_.size() != 3) fail("expected three numbers");
        Vec3 v;
        for (std::size_t i = 0; i < 3; ++i)
            v[static_cast<int>(i)] = Node(value_[i], path_, source_).number();
        return v;
    }
    const json& value() const { return value_; }
    // Returns the first element of a list, with the path of the list.
    Node first() const { return {value_[0], path_, source_}; }

private:
    const json& value_;
    std::string path_;
    const Source& source_;
};

struct Axis {
    char letter = 'X';
    bool of_table = true, turns = false;
    std::string parent;
    std::size_t depth = 0;  // number of axes that carry this axis
    int sequence = 0;
    machine::Joint joint;
    bool is_placed = false;
};

Axis axis_of(const std::string& name, const Node& node, double unit) {
    Axis axis;
    if (name.size() != 1 || std::string_view("XYZABC").find(name[0]) == std::string_view::npos)
        node.fail("expected an axis X, Y, Z, A, B or C");
    axis.letter = name[0];
    axis.turns = axis.letter <= 'C';
    const std::string role = node["role"].text();
    if (role != "table_linear" && role != "head_linear" && role != "table_rotary" &&
        role != "head_rotary")
        node["role"].fail("expected table_linear, head_linear, table_rotary or head_rotary");
    axis.of_table = role.starts_with("table");
    if (role.ends_with("rotary") != axis.turns)
        node["role"].fail("X, Y and Z are linear, A, B and C rotary");
    if (node.has("parent")) axis.parent = node["parent"].text();
    if (node.has("sequence")) axis.sequence = static_cast<int>(node["sequence"].number());
    const Node joint = node["joint"];
    const Vec3 direction = joint["axis"].vector();
    if (norm(direction) < 1e-6) joint["axis"].fail("it has no length");
    const Vec3 origin = joint.has("origin") ? unit * joint["origin"].vector() : Vec3{};
    axis.is_placed = norm(origin) != 0.0;
    Vec3 own;
    if (!axis.turns) own[axis.letter - 'X'] = 1.0;
    if (!axis.turns && norm(normalized(direction) - own) > 1e-9)
        joint["axis"].fail("only an axis along its own letter is simulated");
    const bool by_part = axis.turns && axis.of_table;
    axis.joint = machine::joint_of(axis.letter, axis.turns, direction, axis.turns ? origin : Vec3{},
                                   by_part ? machine::Positive::Part : machine::Positive::Tool);
    return axis;
}

void find_depths(std::vector<Axis>& axes, const Node& node) {
    for (Axis& axis : axes) {
        std::string parent = axis.parent;
        while (!parent.empty()) {
            const auto found = std::ranges::find_if(
                axes, [&](const Axis& a) { return std::string(1, a.letter) == parent; });
            if (found == axes.end()) node.fail(fmt::format("there is no axis '{}'", parent));
            if (++axis.depth > axes.size())
                node.fail(fmt::format("axis {} carries itself", axis.letter));
            parent = found->parent;
        }
    }
}

// Orders joints from the part to the tool: on the table, axes with most carriers come first; on the
// head, last. If carriers are unspecified, rotary axes are nearer to the part or to the tool than
// linear axes.
machine::Chain chain_of(std::vector<Axis> axes) {
    std::ranges::sort(axes, [](const Axis& a, const Axis& b) {
        if (a.of_table != b.of_table) return a.of_table;
        if (a.depth != b.depth) return a.of_table == (a.depth > b.depth);
        if (a.turns != b.turns) return a.of_table == a.turns;
        if (a.sequence != b.sequence) return a.of_table == (a.sequence > b.sequence);
        return a.letter < b.letter;
    });
    machine::Chain chain;
    for (const Axis& axis : axes)
        chain.joints.push_back(axis.joint);
    return chain;
}

}  // namespace

MachineFile read_freecad_machine(const std::string& path, InputSet& inputs) {
    const std::string text = inputs.read(path, kMostSetUpBytes);
    const Source source{name_of_input(path), KeyLines(text)};
    if (!source.lines.fault().empty()) {
        throw std::runtime_error(
            fmt::format("{}:{}: {}", source.name, source.lines.last_line(), source.lines.fault()));
    }
    const json root = json::parse(text);
    const Node machine = Node(root, "", source)["machine"];
    MachineFile file;
    if (machine.has("name")) file.machine.name = machine["name"].text();
    const bool inches = machine.has("units") && machine["units"].text() == "imperial";
    const double unit = inches ? 25.4 : 1.0;
    const Node specified = machine["axes"];
    if (!specified.value().is_object()) specified.fail("expected a table of axes");
    std::vector<Axis> axes;
    SpecifiedKinematics kinematics;
    for (const auto& [letter, value] : specified.value().items()) {
        const Node node(value, fmt::format("machine: axes: {}", letter), source);
        axes.push_back(axis_of(letter, node, unit));
        const Axis& axis = axes.back();
        if (axis.turns && !axis.is_placed) kinematics.unspecified_pivots += axis.letter;
        if (node.has("limits")) {
            const double low = node["limits"]["min"].number();
            const double high = node["limits"]["max"].number();
            if (!(low < high)) node["limits"].fail("max must be above min");
            if (axis.turns) {
                kinematics.travels[axis.letter] = {low, high};
            } else {
                file.machine.travel[static_cast<std::size_t>(axis.letter - 'X')] = {unit * low,
                                                                                    unit * high};
            }
        }
        if (!axis.turns && node.has("max_velocity")) {
            const double rate = unit * node["max_velocity"].number();
            if (rate > 0.0) file.machine.rapid[static_cast<std::size_t>(axis.letter - 'X')] = rate;
        }
        if (axis.turns && axis.of_table)
            kinematics.guess = "tables turn the part by the right hand about their axes";
    }
    for (const char letter : std::string_view("XYZ")) {
        if (std::ranges::find(axes, letter, &Axis::letter) == axes.end())
            specified.fail(fmt::format("no axis {}", letter));
    }
    find_depths(axes, specified);
    kinematics.chain = chain_of(std::move(axes));
    file.kinematics = std::move(kinematics);
    if (!machine.has("toolheads")) return file;
    const Node heads = machine["toolheads"];
    if (!heads.value().is_array() || heads.value().empty()) return file;
    const Node head = heads.first();
    const auto speed = [&head](const char* key) -> std::optional<double> {
        if (!head.has(key)) return std::nullopt;
        const double rpm = head[key].number();
        return rpm > 0.0 ? std::optional(rpm) : std::nullopt;
    };
    file.machine.min_rpm = speed("min_rpm");
    file.machine.max_rpm = speed("max_rpm");
    return file;
}

}  // namespace ncsim::setup
