// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine as glTF: node 0 converts mm to metres, node i + 1 is node i of the scene, and the part
// is last.
#include "ncsim/base/angles.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/export/gltf.h"

#include "formats/file_text.h"
#include "formats/gltf_model.h"
#include "formats/scene_keys.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ncsim::exporter {

namespace {

using Extra = tinygltf::Value;

using Quaternion = std::array<float, 4>;

// Largest rotation between two keys. Readers rotate the shorter way between two keys, so larger
// rotations could reverse.
constexpr double kMostDegrees = 90.0;

// Adds the components of `v` as separate numbers. Some readers (assimp 5.2) fail if the extras of a
// node hold lists.
void add_components(Extra::Object& specified, const std::string& name, Vec3 v) {
    for (int i = 0; i < 3; ++i)
        specified.emplace(name + "_" + "xyz"[i], Extra(v[i] + 0.0));
}

std::array<double, 4> turn_of(const SceneJoint& joint, double degrees) {
    const SinCos half = sin_cos(0.5 * degrees);
    const Vec3 axis = half.sin * joint.direction;
    return {axis.x, axis.y, axis.z, half.cos};
}

class SceneModel {
public:
    SceneModel(const MovingScene& scene, tinygltf::Model& model)
        : scene_(scene), model_(model), packer_(model) {}

    void add_nodes() {
        constexpr double kMetres = 0.001;
        const double half_root = std::sqrt(0.5);
        tinygltf::Node machine;
        machine.name = "machine";
        machine.rotation = {-half_root, 0.0, 0.0, half_root};
        machine.scale = {kMetres, kMetres, kMetres};
        model_.nodes.push_back(machine);
        for (const SceneNode& node : scene_.nodes)
            add_node(node);
        model_.scenes.front().name = "machine";
        model_.scenes.front().nodes = {0};
    }

    // Adds the node of the part. `mesh` is the number of its mesh, relative to `centre` in W.
    void add_part_node(int mesh, Vec3 centre) {
        tinygltf::Node node;
        node.name = "part";
        node.mesh = mesh;
        Vec3 carrier;
        if (scene_.part_on) carrier = scene_.nodes[*scene_.part_on].origin;
        const Vec3 at = scene_.zero + centre - carrier;
        node.translation = {at.x, at.y, at.z};
        attach(std::move(node), scene_.part_on);
    }

    void add_animation() {
        tinygltf::Animation animation;
        animation.name = "program";
        for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
            const SceneNode& node = scene_.nodes[i];
            const int target = static_cast<int>(i) + 1;
            if (node.joint && is_moving(*node.joint)) add_joint(node, target, animation);
            if (!node.shown.empty()) add_visibility(node, target, animation);
        }
        if (animation.channels.empty()) return;
        Extra::Array seconds, lines;
        for (const SceneLine& line : scene_.lines) {
            seconds.emplace_back(line.seconds);
            lines.emplace_back(static_cast<int>(line.line));
        }
        animation.extras = Extra(Extra::Object{{"error_mm", Extra(scene_.missed_mm)},
                                               {"seconds", Extra(std::move(seconds))},
                                               {"lines", Extra(std::move(lines))}});
        model_.animations.push_back(std::move(animation));
    }

private:
    void attach(tinygltf::Node node, std::optional<std::size_t> parent) {
        const int number = static_cast<int>(model_.nodes.size());
        model_.nodes.push_back(std::move(node));
        model_.nodes[parent ? *parent + 1 : 0].children.push_back(number);
    }

    Vec3 origin_of_parent(const SceneNode& node) const {
        return node.parent ? scene_.nodes[*node.parent].origin : Vec3{};
    }

    // Returns the origin of the node's frame in its parent's frame with the joint at `value`.
    Vec3 place_of(const SceneNode& node, double value) const {
        const Vec3 home = node.origin - origin_of_parent(node);
        if (!node.joint || node.joint->turns) return home;
        return home + value * node.joint->direction;
    }

    void add_node(const SceneNode& from) {
        tinygltf::Node node;
        node.name = printable_utf8(from.name);
        const double value = from.joint ? first_value(*from.joint) : 0.0;
        const Vec3 at = place_of(from, value);
        node.translation = {at.x, at.y, at.z};
        if (from.joint) {
            if (from.joint->turns) {
                const auto turn = turn_of(*from.joint, value);
                node.rotation.assign(turn.begin(), turn.end());
            }
            Extra::Object specified{{"axis", Extra(std::string(1, from.joint->letter))},
                                    {"turns", Extra(from.joint->turns)}};
            add_components(specified, "direction", from.joint->direction);
            if (from.joint->turns) add_components(specified, "through", from.origin);
            node.extras = Extra(std::move(specified));
        }
        if (!from.shown.empty() && visibility_keys(from).front().value == 0.0)
            node.scale = {0.0, 0.0, 0.0};
        if (!from.bodies.empty()) node.mesh = add_mesh(from);
        attach(std::move(node), from.parent);
    }

    int add_mesh(const SceneNode& from) {
        tinygltf::Mesh mesh;
        mesh.name = printable_utf8(from.name);
        for (const Body& body : from.bodies) {
            tinygltf::Primitive primitive;
            primitive.mode = TINYGLTF_MODE_TRIANGLES;
            primitive.material = static_cast<int>(model_.materials.size());
            model_.materials.push_back(plain_material(mesh.name, body.colour));
            std::vector<mesh::FloatPoint> points;
            for (const Vec3& p : body.surface.vertices)
                points.push_back(mesh::to_floats(p - from.origin));
            std::vector<std::uint32_t> indices;
            for (const auto& triangle : cda::triangulate(body.surface).triangles)
                indices.insert(indices.end(), triangle.begin(), triangle.end());
            if (indices.empty()) continue;
            bytes_ += 4 * indices.size() + 12 * points.size();
            check_size();
            primitive.indices = packer_.pack_indices(indices);
            primitive.attributes["POSITION"] = packer_.pack_positions(points);
            mesh.primitives.push_back(std::move(primitive));
        }
        if (mesh.primitives.empty()) return -1;
        model_.meshes.push_back(std::move(mesh));
        return static_cast<int>(model_.meshes.size()) - 1;
    }

    void check_size() const {
        if (bytes_ > std::numeric_limits<std::uint32_t>::max() / 4)
            throw std::runtime_error("the machine is too large for a glTF file (1 GiB)");
    }

    // Converts keys to times and values for a sampler. Times must ascend as floats, so a key whose
    // float time is not later replaces the value of the preceding key.
    template <class Output, class Make>
    static void make_samples(const std::vector<JointKey>& keys, std::vector<float>& times,
                             std::vector<Output>& values, const Make& make) {
        for (const JointKey& key : keys) {
            const auto time = static_cast<float>(key.seconds);
            if (!times.empty() && time <= times.back()) {
                values.back() = make(key.value);
                continue;
            }
            times.push_back(time);
            values.push_back(make(key.value));
        }
    }

    void add_channel(tinygltf::Animation& animation, int target, const char* path,
                     const char* interpolation, const std::vector<float>& times, int output) {
        tinygltf::AnimationSampler sampler;
        sampler.input = packer_.pack_times(times);
        sampler.output = output;
        sampler.interpolation = interpolation;
        tinygltf::AnimationChannel channel;
        channel.sampler = static_cast<int>(animation.samplers.size());
        channel.target_node = target;
        channel.target_path = path;
        animation.samplers.push_back(std::move(sampler));
        animation.channels.push_back(std::move(channel));
    }

    void add_joint(const SceneNode& node, int target, tinygltf::Animation& animation) {
        const SceneJoint& joint = *node.joint;
        const std::vector<JointKey> keys = divided_keys(joint, kMostDegrees);
        bytes_ += 20 * keys.size();
        check_size();
        std::vector<float> times;
        if (joint.turns) {
            std::vector<Quaternion> turns;
            make_samples(keys, times, turns, [&joint](double degrees) {
                Quaternion q{};
                const auto turn = turn_of(joint, degrees);
                for (std::size_t i = 0; i < q.size(); ++i)
                    q[i] = static_cast<float>(turn[i] + 0.0);
                return q;
            });
            add_channel(animation, target, "rotation", "LINEAR", times, packer_.pack_turns(turns));
            return;
        }
        std::vector<mesh::FloatPoint> places;
        make_samples(keys, times, places,
                     [&](double mm) { return mesh::to_floats(place_of(node, mm)); });
        add_channel(animation, target, "translation", "LINEAR", times, packer_.pack_places(places));
    }

    void add_visibility(const SceneNode& node, int target, tinygltf::Animation& animation) {
        std::vector<float> times;
        std::vector<mesh::FloatPoint> scales;
        make_samples(visibility_keys(node), times, scales, [](double value) {
            const auto share = static_cast<float>(value);
            return mesh::FloatPoint{share, share, share};
        });
        add_channel(animation, target, "scale", "STEP", times, packer_.pack_places(scales));
    }

    const MovingScene& scene_;
    tinygltf::Model& model_;
    Packer packer_;
    std::uint64_t bytes_ = 0;
};

}  // namespace

void write_gltf(std::ostream& out, const cda::Boundary& boundary,
                const mesh::Provenance& provenance, const MovingScene& scene,
                const brep::Shading& shading) {
    const Vec3 centre = whole_centre(boundary);
    const mesh::FloatMesh mesh = mesh::round_to_floats(cda::triangulate(boundary), centre);
    tinygltf::Model model = model_of(boundary, provenance);
    const std::optional<int> part = add_part(model, {boundary, mesh, centre, shading}, provenance);
    SceneModel machine(scene, model);
    machine.add_nodes();
    if (part) machine.add_part_node(*part, centre);
    machine.add_animation();
    write_model(out, model);
}

}  // namespace ncsim::exporter
