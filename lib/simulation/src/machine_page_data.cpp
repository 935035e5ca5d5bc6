// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies and joint positions of a machine for the page of a program.
#include "machine_page_data.h"

#include "ncsim/simulation/joint_course.h"

#include "tool_pieces.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace ncsim::simulation {

namespace {

using report::MachinePageData;

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
    for (report::ColouredMesh& piece : tool_pieces(tool)) {
        MachinePageData::Body body;
        body.name = "tool";
        body.colour = piece.colour;
        body.mesh = std::move(piece.mesh);
        for (cda::Vec3& p : body.mesh.vertices)
            p.z -= length;
        body.moved_by = joints_of(moved_by);
        body.tool = number;
        look.bodies.push_back(std::move(body));
    }
}

}  // namespace

std::optional<MachinePageData> machine_page_data(const Plan& plan, const Survey& survey,
                                                 const setup::MachineFile& machine) {
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
    for (std::size_t i = 0; i < course.lines.size(); ++i) {
        if (course.lines[i].file != 0) continue;
        const double end =
            i + 1 < course.lines.size() ? course.lines[i + 1].seconds : course.seconds;
        MachinePageData::LinePose stand;
        stand.values = values_at(course, end);
        // The tool with which the line was run; a change takes effect after the line.
        for (std::size_t k = 0; k < course.tools.size(); ++k) {
            const ToolTime& time = course.tools[k];
            if (time.from_seconds <= course.lines[i].seconds) stand.tool = tool_of[k];
        }
        look.line_poses[course.lines[i].line] = stand;
    }
    return look;
}

}  // namespace ncsim::simulation
