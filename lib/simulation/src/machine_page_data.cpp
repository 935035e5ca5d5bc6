// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies and joint positions of a machine for the page of a program.
#include "machine_page_data.h"

#include "ncsim/machine/relative.h"
#include "ncsim/simulation/joint_course.h"

#include "tool_pieces.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace ncsim::simulation {

namespace {

std::vector<MachinePageData::Joint> joints_of(const machine::Chain& chain) {
    std::vector<MachinePageData::Joint> joints;
    for (const machine::Joint& joint : chain.joints) {
        joints.push_back(
            {*machine::index_of(joint.letter), joint.turns, joint.direction, joint.through});
    }
    return joints;
}

machine::Values values_at(const JointCourse& course, double seconds) {
    const auto after = std::ranges::upper_bound(course.keys, seconds, {}, &JointKey::seconds);
    if (after == course.keys.begin()) return course.keys.front().values;
    const JointKey& from = *(after - 1);
    if (after == course.keys.end() || from.seconds == seconds) return from.values;
    const double t = (seconds - from.seconds) / (after->seconds - from.seconds);
    machine::Values values{};
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = (1 - t) * from.values[i] + t * after->values[i];
    return values;
}

// Adds the pieces of a tool, with the tip `length` below the spindle nose.
void add_tool(const toolpath::Tool& tool, double length, std::int32_t number,
              const machine::Chain& moved_by, MachinePageData& look) {
    for (ColouredMesh& piece : tool_pieces(tool)) {
        MachinePageData::Body body;
        body.name = "tool";
        body.colour = piece.colour;
        body.mesh = std::move(piece.mesh);
        for (Vec3& p : body.mesh.vertices)
            p.z -= length;
        body.moved_by = joints_of(moved_by);
        body.tool = number;
        look.bodies.push_back(std::move(body));
    }
}

// Poses of the machine and its tool at times of the program.
class Poses {
public:
    // `tool_of`: number of the tool of each ToolTime.
    Poses(const setup::MachineFile& machine, Vec3 zero, const JointCourse& course,
          std::vector<std::int32_t> tool_of)
        : machine_(machine), zero_(zero), course_(course), tool_of_(std::move(tool_of)) {}

    MachinePageData::LinePose after(std::size_t line) const {
        return {values_at(course_, end_of(line)), tool_of(line)};
    }

    // Returns the pose in which the tip is nearest to the place of a finding; empty if the finding
    // has no place or no motion.
    std::optional<MachinePageData::LinePose> at(const verify::Finding& finding) const {
        const std::optional<Vec3> point = verify::point_of(finding);
        std::optional<MachinePageData::LinePose> best;
        if (!point) return best;
        double nearest = std::numeric_limits<double>::infinity();
        // The place is that of the first contact: later turns of a loop do not count.
        constexpr int kMostTurns = 20;
        int turns = 0;
        for (std::size_t i = 0; i < course_.lines.size() && turns < kMostTurns; ++i) {
            const LineTime& line = course_.lines[i];
            if (line.file != finding.place.file || line.line != finding.place.span.line) continue;
            ++turns;
            constexpr int kSteps = 400;
            for (int step = 0; step <= kSteps; ++step) {
                const double share = static_cast<double>(step) / kSteps;
                const machine::Values values =
                    values_at(course_, (1.0 - share) * line.seconds + share * end_of(i));
                const double away = norm(tip(i, values) - *point);
                if (away >= nearest) continue;
                nearest = away;
                best = MachinePageData::LinePose{finding.joints.value_or(values), tool_of(i)};
            }
        }
        return best;
    }

private:
    double end_of(std::size_t line) const {
        return line + 1 < course_.lines.size() ? course_.lines[line + 1].seconds : course_.seconds;
    }
    // Returns the index of the tool with which a line is run; a change takes effect after the line.
    std::optional<std::size_t> tool_time(std::size_t line) const {
        const auto next = std::ranges::upper_bound(course_.tools, course_.lines[line].seconds, {},
                                                   &ToolTime::from_seconds);
        if (next == course_.tools.begin()) return std::nullopt;
        return static_cast<std::size_t>(next - course_.tools.begin()) - 1;
    }
    std::int32_t tool_of(std::size_t line) const {
        const auto index = tool_time(line);
        return index ? tool_of_[*index] : -1;
    }
    // Returns the tip of the tool in W.
    Vec3 tip(std::size_t line, const machine::Values& values) const {
        const auto index = tool_time(line);
        const double length = index ? course_.tools[*index].length_mm : 0.0;
        const machine::Pose X_MN = machine::pose_of(machine_.tool_moved_by, values);
        return setup::on_part(machine_.part_moved_by, values, X_MN * Vec3{0, 0, -length}) - zero_;
    }

    const setup::MachineFile& machine_;
    Vec3 zero_;
    const JointCourse& course_;
    std::vector<std::int32_t> tool_of_;
};

}  // namespace

std::optional<MachinePageData> machine_page_data(const Plan& plan, const Survey& survey,
                                                 const setup::MachineFile& machine,
                                                 std::span<const verify::Finding> findings) {
    if (!plan.placed || machine.bodies.empty()) return std::nullopt;
    const JointCourse course = joint_course(plan);
    if (course.keys.empty()) return std::nullopt;
    MachinePageData look;
    look.part_moved_by = joints_of(machine.part_moved_by);
    look.zero = plan.placed->zero;
    for (const setup::MachineBody& link : machine.bodies)
        look.bodies.push_back({link.link, link.colour, link.mesh, joints_of(link.moved_by), -1});
    std::map<std::pair<int, double>, std::int32_t> tools;
    std::vector<std::int32_t> tool_of;
    for (const ToolTime& time : course.tools) {
        const auto next = static_cast<std::int32_t>(tools.size());
        const auto [known, is_new] = tools.try_emplace({time.number, time.length_mm}, next);
        tool_of.push_back(known->second);
        const auto used = survey.tools.find(time.number);
        if (is_new && used != survey.tools.end())
            add_tool(used->second.tool, time.length_mm, next, machine.tool_moved_by, look);
    }
    const Poses poses(machine, look.zero, course, std::move(tool_of));
    for (std::size_t i = 0; i < course.lines.size(); ++i) {
        if (course.lines[i].file == 0) look.line_poses[course.lines[i].line] = poses.after(i);
    }
    for (std::size_t f = 0; f < findings.size(); ++f) {
        if (findings[f].category != verify::Category::Collision) continue;
        if (const auto pose = poses.at(findings[f])) look.finding_poses[f] = *pose;
    }
    return look;
}

}  // namespace ncsim::simulation
