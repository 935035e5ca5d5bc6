// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes nodes of bodies that do not move relative to the part.
#include "run/standing_bodies.h"

#include "ncsim/simulation/fixtures.h"

#include "run/tool_body.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace ncsim::app {

namespace {

void add_node(const std::string& name, std::vector<exporter::Body> bodies,
              exporter::MovingScene& scene) {
    exporter::SceneNode node;
    node.name = name;
    node.parent = scene.part_on;
    if (node.parent) node.origin = scene.nodes[*node.parent].origin;
    for (exporter::Body& body : bodies) {
        for (Vec3& p : body.surface.vertices)
            p = p + scene.zero;
    }
    node.bodies = std::move(bodies);
    scene.nodes.push_back(std::move(node));
}

}  // namespace

void add_standing_bodies(const Outcome& outcome, exporter::MovingScene& scene) {
    for (const verify::Fixture& fixture : outcome.fixtures)
        add_node(fixture.name, {simulation::body_of(fixture)}, scene);
    const auto& position = outcome.simulation->tool_position;
    if (!outcome.options.shows_tool || outcome.options.shows_machine || !position) return;
    const auto used = outcome.survey.tools.find(position->tool);
    if (used == outcome.survey.tools.end()) return;
    add_node(fmt::format("T{}", position->tool), tool_bodies(used->second.tool, position->X_WT),
             scene);
}

}  // namespace ncsim::app
