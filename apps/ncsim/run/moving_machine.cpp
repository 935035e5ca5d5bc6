// SPDX-License-Identifier: GPL-3.0-or-later
//
// Builds the scene of an animated machine.
#include "run/moving_machine.h"

#include "ncsim/simulation/joint_course.h"

#include "run/machine_picture.h"
#include "run/tool_body.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

namespace ncsim::app {

namespace {

using exporter::MovingScene;
using exporter::SceneNode;

// Returns the keys of a joint. A run of equal values keeps only its first and last key.
std::vector<exporter::JointKey> keys_of(const simulation::JointCourse& course, char letter) {
    const std::size_t axis = *machine::index_of(letter);
    std::vector<exporter::JointKey> keys;
    for (const simulation::JointKey& key : course.keys) {
        const double value = key.values[axis];
        const bool stays =
            keys.size() >= 2 && keys.back().value == value && keys[keys.size() - 2].value == value;
        if (stays) keys.pop_back();
        keys.push_back({key.seconds, value});
    }
    return keys;
}

class SceneBuilder {
public:
    explicit SceneBuilder(const Outcome& outcome)
        : outcome_(outcome), course_(simulation::joint_course(outcome.plan)) {}

    MovingScene build() {
        const setup::MachineFile& machine = *outcome_.machine;
        for (const auto* links : {&machine.bodies, &machine.other_links}) {
            for (const setup::MachineBody& link : *links)
                links_.emplace(link.link, &link);
        }
        // Keeps the order of the file as far as possible: links with a shape first.
        for (const auto* links : {&machine.bodies, &machine.other_links}) {
            for (const setup::MachineBody& link : *links)
                add_link(link);
        }
        const auto part_on = numbers_.find(machine.part_link);
        if (part_on != numbers_.end()) scene_.part_on = part_on->second;
        scene_.zero = outcome_.plan.placed->zero;
        scene_.seconds = course_.seconds;
        scene_.missed_mm = course_.missed_mm;
        // Only lines of the program itself; scenes do not show called files.
        for (const simulation::LineTime& line : course_.lines) {
            if (line.file == 0) scene_.lines.push_back({line.seconds, line.line});
        }
        add_tools();
        return std::move(scene_);
    }

private:
    // Adds a link after the parent; returns the number of the node.
    std::size_t add_link(const setup::MachineBody& link) {
        const auto known = numbers_.find(link.link);
        if (known != numbers_.end()) return known->second;
        SceneNode node;
        node.name = link.link;
        if (const auto parent = links_.find(link.parent); parent != links_.end()) {
            node.parent = add_link(*parent->second);
            node.origin = scene_.nodes[*node.parent].origin;
        }
        if (link.joint) {
            const machine::Joint& joint = *link.joint;
            if (joint.turns) node.origin = joint.through;
            node.joint = {joint.letter, joint.turns, joint.direction,
                          keys_of(course_, joint.letter)};
        }
        if (!link.mesh.triangles.empty())
            node.bodies.push_back(machine_body(link, link.mesh.vertices));
        scene_.nodes.push_back(std::move(node));
        return numbers_.emplace(link.link, scene_.nodes.size() - 1).first->second;
    }

    // Adds a node for each tool and each length from the spindle nose.
    void add_tools() {
        const auto carrier = numbers_.find(outcome_.machine->tool_link);
        std::map<std::pair<int, double>, std::size_t> nodes;
        for (const simulation::ToolTime& time : course_.tools) {
            const auto used = outcome_.survey.tools.find(time.number);
            if (used == outcome_.survey.tools.end()) continue;
            const auto [place, is_new] =
                nodes.emplace(std::pair(time.number, time.length_mm), scene_.nodes.size());
            if (is_new) {
                SceneNode node;
                node.name = fmt::format("T{}", time.number);
                if (carrier != numbers_.end()) node.parent = carrier->second;
                node.origin = {0, 0, -time.length_mm};
                node.bodies = tool_bodies(used->second.tool, {{}, node.origin});
                scene_.nodes.push_back(std::move(node));
            }
            scene_.nodes[place->second].shown.emplace_back(time.from_seconds, time.to_seconds);
        }
        // A single tool is always shown.
        if (nodes.size() == 1 && course_.tools.size() == 1)
            scene_.nodes[nodes.begin()->second].shown.clear();
    }

    const Outcome& outcome_;
    simulation::JointCourse course_;
    MovingScene scene_;
    std::map<std::string, const setup::MachineBody*> links_;
    std::map<std::string, std::size_t> numbers_;
};

}  // namespace

MovingScene moving_machine(const Outcome& outcome) {
    return SceneBuilder(outcome).build();
}

}  // namespace ncsim::app
