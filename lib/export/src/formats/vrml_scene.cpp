// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moving nodes and their interpolators as VRML97.
#include "formats/vrml_scene.h"

#include "ncsim/base/angles.h"
#include "ncsim/cda/triangulate.h"

#include "formats/file_text.h"
#include "formats/scene_keys.h"
#include "render/palette.h"

#include <cmath>
#include <string_view>
#include <vector>

namespace ncsim::exporter {

namespace {

// Largest rotation between two keys. Readers rotate the shorter way between two keys, so larger
// rotations could reverse.
constexpr double kMaxKeyTurn = 90.0;

// Scale of hidden nodes. VRML requires scales above 0.
constexpr double kAway = 1e-6;

// Appends a rotation about the joint's direction, in radians without whole turns.
void append_turn(std::string& text, const SceneJoint& joint, double degrees) {
    append_point(text, joint.direction);
    text += ' ';
    append_number(text, kRadiansPerDegree * std::remainder(degrees, 360.0));
}

void append_body(std::string& text, const Body& body, Vec3 origin) {
    text += "Shape {\nappearance ";
    append_appearance(text, body.colour);
    text += "\ngeometry IndexedFaceSet { coord Coordinate { point [\n";
    for (const Vec3& p : body.surface.vertices) {
        append_point(text, p - origin);
        text += '\n';
    }
    text += "] }\ncoordIndex [\n";
    for (const auto& triangle : cda::triangulate(body.surface).triangles) {
        for (const std::uint32_t corner : triangle)
            text += std::to_string(corner) + ' ';
        text += "-1\n";
    }
    text += "] } }\n";
}

template <class Append>
void append_keys(std::string& text, const std::vector<JointKey>& keys, double all_seconds,
                 const Append& append) {
    text += "key [";
    for (const JointKey& key : keys) {
        text += ' ';
        append_number(text, all_seconds > 0.0 ? key.seconds / all_seconds : 0.0);
    }
    text += " ]\nkeyValue [\n";
    for (const JointKey& key : keys) {
        append(key.value);
        text += '\n';
    }
    text += "] }\n";
}

}  // namespace

void append_point(std::string& text, Vec3 p) {
    append_number(text, p.x);
    text += ' ';
    append_number(text, p.y);
    text += ' ';
    append_number(text, p.z);
}

void append_appearance(std::string& text, Rgba8 colour) {
    text += "Appearance { material Material { diffuseColor";
    for (const std::uint8_t channel : {colour.r, colour.g, colour.b}) {
        text += ' ';
        append_number(text, unit_share(channel));
    }
    text += " specularColor 0.2 0.2 0.2";
    if (colour.a < 255) {
        text += " transparency ";
        append_number(text, unit_share(static_cast<std::uint8_t>(255 - colour.a)));
    }
    text += " } }";
}

std::string VrmlScene::name_of(std::size_t number) const {
    std::string name = "LINK_" + std::to_string(number) + '_';
    for (const char c : scene_.nodes[number].name) {
        constexpr std::string_view kNameLetters =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";
        name += kNameLetters.find(c) == std::string_view::npos ? '_' : c;
    }
    return name;
}

Vec3 VrmlScene::place_of(std::size_t number, double value) const {
    const SceneNode& node = scene_.nodes[number];
    Vec3 home = node.origin;
    if (node.parent) home = home - scene_.nodes[*node.parent].origin;
    if (!node.joint || node.joint->turns) return home;
    return home + value * node.joint->direction;
}

void VrmlScene::begin_node(std::string& text, std::size_t number) const {
    const SceneNode& node = scene_.nodes[number];
    const double value = node.joint ? first_value(*node.joint) : 0.0;
    text += "DEF " + name_of(number) + " Transform { translation ";
    append_point(text, place_of(number, value));
    if (node.joint && node.joint->turns) {
        text += " rotation ";
        append_turn(text, *node.joint, value);
    }
    if (!node.shown.empty() && visibility_keys(node).front().value == 0.0) {
        text += " scale ";
        append_point(text, {kAway, kAway, kAway});
    }
    text += " children [\n";
    for (const Body& body : node.bodies)
        append_body(text, body, node.origin);
}

void VrmlScene::append_interpolators(std::string& text) const {
    std::string made, routes;
    const auto connect = [&](const std::string& name, const std::string& node, const char* field) {
        routes += "ROUTE CLOCK.fraction_changed TO " + name + ".set_fraction\n";
        routes += "ROUTE " + name + ".value_changed TO " + node + ".set_" + field + '\n';
    };
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
        const SceneNode& node = scene_.nodes[i];
        if (node.joint && is_moving(*node.joint)) {
            const SceneJoint& joint = *node.joint;
            const std::string name = "JOINT_" + std::string(1, joint.letter);
            made += "DEF " + name + (joint.turns ? " Orientation" : " Position");
            made += "Interpolator { ";
            append_keys(made, divided_keys(joint, kMaxKeyTurn), scene_.seconds, [&](double value) {
                if (joint.turns) {
                    append_turn(made, joint, value);
                } else {
                    append_point(made, place_of(i, value));
                }
            });
            connect(name, name_of(i), joint.turns ? "rotation" : "translation");
        }
        if (node.shown.empty()) continue;
        // The scale changes at once, so there are two keys at the same time.
        std::vector<JointKey> keys;
        for (const JointKey& key : visibility_keys(node)) {
            if (!keys.empty()) keys.push_back({key.seconds, keys.back().value});
            keys.push_back(key);
        }
        const std::string name = "SHOWN_" + std::to_string(i);
        made += "DEF " + name + " PositionInterpolator { ";
        append_keys(made, keys, scene_.seconds, [&](double value) {
            const double scale = value > 0.0 ? 1.0 : kAway;
            append_point(made, {scale, scale, scale});
        });
        connect(name, name_of(i), "scale");
    }
    if (made.empty()) return;
    text += "DEF CLOCK TimeSensor { loop TRUE cycleInterval ";
    append_number(text, scene_.seconds > 0.0 ? scene_.seconds : 1.0);
    text += " }\n" + made + routes;
}

}  // namespace ncsim::exporter
