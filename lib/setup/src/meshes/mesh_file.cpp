// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes in STL and binary glTF, and checks of closed surfaces.
#include "ncsim/setup/mesh_file.h"

#include "ncsim/cda/check.h"
#include "ncsim/cda/shape.h"

#include "meshes/obj_mesh.h"
#include "meshes/polygons.h"
#include "meshes/step_file.h"
#include "meshes/vrml_mesh.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace ncsim::setup {

namespace {

constexpr std::size_t kHead = 84, kRecord = 50;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;)
        word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
    return word;
}

// Reads binary STL. Binary files may begin with "solid", too, so the number of triangles decides.
std::optional<std::vector<Vec3>> read_binary(std::string_view bytes) {
    if (bytes.size() < kHead) return std::nullopt;
    const std::size_t count = word_at(bytes, kHead - 4);
    if (bytes.size() != kHead + kRecord * count) return std::nullopt;
    std::vector<Vec3> corners;
    corners.reserve(3 * count);
    for (std::size_t t = 0; t < count; ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Vec3 v;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t at = kHead + kRecord * t + 12 + 12 * corner + 4 * axis;
                v[static_cast<int>(axis)] = std::bit_cast<float>(word_at(bytes, at));
            }
            corners.push_back(v);
        }
    }
    return corners;
}

std::optional<std::vector<Vec3>> read_text(std::string_view text) {
    std::vector<Vec3> corners;
    for (std::size_t at = text.find("vertex"); at != std::string_view::npos;
         at = text.find("vertex", at)) {
        at += 6;
        Vec3 v;
        for (int axis = 0; axis < 3; ++axis) {
            at = text.find_first_not_of(" \t\r\n+", at);
            if (at == std::string_view::npos) return std::nullopt;
            const auto [end, error] =
                std::from_chars(text.data() + at, text.data() + text.size(), v[axis]);
            if (error != std::errc{}) return std::nullopt;
            at = static_cast<std::size_t>(end - text.data());
        }
        corners.push_back(v);
    }
    if (corners.empty() || corners.size() % 3 != 0) return std::nullopt;
    return corners;
}

// --- Binary glTF: Khronos Group, glTF 2.0 Specification (ISO/IEC 12113:2022) -------------------

bool is_gltf(std::string_view bytes) {
    return bytes.starts_with("glTF");
}

// A linear map (rotation, scale and shear) followed by a translation.
struct Placing {
    std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    Vec3 shift;
    Vec3 operator()(Vec3 p) const {
        return Vec3{dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)} + shift;
    }
};

Placing placing_of(const tinygltf::Node& node) {
    Placing placing;
    if (node.matrix.size() == 16) {  // column by column
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 3; ++column)
                placing.rows[row][static_cast<int>(column)] = node.matrix[4 * column + row];
            placing.shift[static_cast<int>(row)] = node.matrix[12 + row];
        }
        return placing;
    }
    if (node.rotation.size() == 4) {
        const double x = node.rotation[0], y = node.rotation[1], z = node.rotation[2],
                     w = node.rotation[3];
        placing.rows = {Vec3{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                        Vec3{2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                        Vec3{2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    }
    if (node.scale.size() == 3) {
        for (Vec3& row : placing.rows)
            row = {row.x * node.scale[0], row.y * node.scale[1], row.z * node.scale[2]};
    }
    if (node.translation.size() == 3)
        placing.shift = {node.translation[0], node.translation[1], node.translation[2]};
    return placing;
}

// Access to numbers in the buffers of a file, which may contain any offsets.
class Accessed {
public:
    Accessed(const tinygltf::Model& model, int number) {
        if (number < 0 || static_cast<std::size_t>(number) >= model.accessors.size())
            throw Refused{"a mesh without positions"};
        const auto& accessor = model.accessors[static_cast<std::size_t>(number)];
        const auto view_number = static_cast<std::size_t>(accessor.bufferView);
        if (accessor.sparse.isSparse || accessor.bufferView < 0 ||
            view_number >= model.bufferViews.size()) {
            throw Refused{"sparse or compressed meshes are not read"};
        }
        const auto& view = model.bufferViews[view_number];
        const int stride = accessor.ByteStride(view);
        if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size() ||
            stride <= 0) {
            throw Refused{"it refers to data that it does not have"};
        }
        const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
        type = accessor.componentType;
        components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
        count = accessor.count;
        stride_ = static_cast<std::size_t>(stride);
        const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type));
        const std::size_t element =
            static_cast<std::size_t>(std::max(0, size)) * static_cast<std::size_t>(components);
        const std::size_t begin = view.byteOffset + accessor.byteOffset;
        if (size <= 0 || components <= 0 || begin > data.size() ||
            (count > 0 && (count - 1 > (data.size() - begin) / stride_ ||
                           (count - 1) * stride_ + element > data.size() - begin))) {
            throw Refused{"it refers to data that it does not have"};
        }
        bytes_ = {reinterpret_cast<const char*>(data.data()) + begin, data.size() - begin};
    }

    float real(std::size_t i, std::size_t component) const {
        return std::bit_cast<float>(word_at(bytes_, i * stride_ + 4 * component));
    }
    std::uint32_t whole(std::size_t i) const {
        const auto byte = [&](std::size_t k) {
            return std::uint32_t{static_cast<unsigned char>(bytes_[i * stride_ + k])};
        };
        if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return byte(0);
        if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return byte(0) | byte(1) << 8;
        if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) return word_at(bytes_, i * stride_);
        throw Refused{"indices that are no numbers"};
    }

    int type = 0, components = 0;
    std::size_t count = 0;

private:
    std::string_view bytes_;
    std::size_t stride_ = 0;
};

void add_mesh(const tinygltf::Model& model, const tinygltf::Mesh& mesh,
              const std::vector<Placing>& placings, std::vector<Vec3>& corners) {
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
        if (primitive.mode >= 0 && primitive.mode < TINYGLTF_MODE_TRIANGLES) continue;
        if (primitive.mode > TINYGLTF_MODE_TRIANGLES)
            throw Refused{"strips and fans of triangles are not read"};
        const auto found = primitive.attributes.find("POSITION");
        const Accessed positions(model, found == primitive.attributes.end() ? -1 : found->second);
        if (positions.type != TINYGLTF_COMPONENT_TYPE_FLOAT || positions.components != 3)
            throw Refused{"positions that are no points"};
        const auto add = [&](std::size_t i) {
            if (i >= positions.count) throw Refused{"it refers to data that it does not have"};
            Vec3 p{positions.real(i, 0), positions.real(i, 1), positions.real(i, 2)};
            for (auto placing = placings.rbegin(); placing != placings.rend(); ++placing)
                p = (*placing)(p);
            // glTF uses metres, with y up.
            corners.push_back(1000.0 * Vec3{p.x, 0.0 - p.z, p.y});
        };
        if (primitive.indices >= 0) {
            const Accessed indices(model, primitive.indices);
            for (std::size_t i = 0; i < indices.count / 3 * 3; ++i)
                add(indices.whole(i));
        } else {
            for (std::size_t i = 0; i < positions.count / 3 * 3; ++i)
                add(i);
        }
    }
}

void add_node(const tinygltf::Model& model, int number, std::vector<Placing>& placings,
              std::vector<Vec3>& corners) {
    constexpr std::size_t kDeepest = 64;  // files may contain circular references
    if (number < 0 || static_cast<std::size_t>(number) >= model.nodes.size() ||
        placings.size() >= kDeepest) {
        throw Refused{"its nodes are no tree"};
    }
    const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(number)];
    placings.push_back(placing_of(node));
    if (node.mesh >= 0 && static_cast<std::size_t>(node.mesh) < model.meshes.size())
        add_mesh(model, model.meshes[static_cast<std::size_t>(node.mesh)], placings, corners);
    for (const int child : node.children)
        add_node(model, child, placings, corners);
    placings.pop_back();
}

std::vector<Vec3> read_gltf(std::string_view bytes) {
    tinygltf::TinyGLTF loader;
    // Textures are ignored.
    loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                             const unsigned char*, int, void*) { return true; },
                          nullptr);
    // References to further files are not followed.
    tinygltf::FsCallbacks no_files{};
    no_files.FileExists = [](const std::string&, void*) { return false; };
    no_files.ExpandFilePath = [](const std::string& path, void*) { return path; };
    no_files.ReadWholeFile = [](std::vector<unsigned char>*, std::string*, const std::string&,
                                void*) { return false; };
    no_files.WriteWholeFile = [](std::string*, const std::string&,
                                 const std::vector<unsigned char>&, void*) { return false; };
    loader.SetFsCallbacks(no_files);
    tinygltf::Model model;
    std::string error, warning;
    if (!loader.LoadBinaryFromMemory(&model, &error, &warning,
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<unsigned int>(bytes.size()))) {
        // The message of tinygltf may quote the file.
        std::string reason =
            "no binary glTF that can be read: " + error.substr(0, error.find('\n'));
        std::ranges::replace_if(
            reason, [](char c) { return c < ' ' || c > '~'; }, '?');
        throw Refused{reason};
    }
    if (!model.extensionsRequired.empty())
        throw Refused{"it needs " + model.extensionsRequired.front()};
    std::vector<Vec3> corners;
    std::vector<Placing> placings;
    const auto scene = static_cast<std::size_t>(std::max(0, model.defaultScene));
    if (scene < model.scenes.size()) {
        for (const int node : model.scenes[scene].nodes)
            add_node(model, node, placings, corners);
    }
    return corners;
}

// --- Surfaces ----------------------------------------------------------------------------------

// Returns the number of edges that occur in one direction more often than in the opposite
// direction.
std::size_t open_edges(const TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
    for (const auto& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    }
    return static_cast<std::size_t>(
        std::ranges::count_if(balance, [](const auto& edge) { return edge.second != 0; }));
}

TriangleMesh weld(const std::vector<Vec3>& corners) {
    TriangleMesh mesh;
    std::map<std::tuple<double, double, double>, std::uint32_t> known;
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 v = corners[i];
        if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
            throw Refused{"it has a corner that is no place"};
        const auto [at, is_new] =
            known.try_emplace({v.x, v.y, v.z}, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (is_new) mesh.vertices.push_back(v);
        triangle[i % 3] = at->second;
        if (i % 3 < 2) continue;
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
            triangle[2] == triangle[0]) {
            continue;
        }
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

std::vector<Vec3> corners_in(std::string_view bytes) {
    if (is_gltf(bytes)) return read_gltf(bytes);
    if (is_vrml(bytes)) return read_vrml(bytes);
    if (is_obj(bytes)) return read_obj(bytes);
    auto corners = read_binary(bytes);
    if (!corners) corners = read_text(bytes);
    if (!corners) throw Refused{"it is neither STL, OBJ, VRML97, binary glTF nor STEP"};
    return std::move(*corners);
}

// Returns the text after the mark that writers of meshes leave in headers, comments and extras of
// STL, STEP, glTF and VRML; empty if there is none.
std::string assumptions_in(std::string_view bytes) {
    constexpr std::size_t kLongest = 400;
    const std::size_t at = bytes.find(cda::kAssumedMark);
    if (at == std::string_view::npos) return {};
    const std::string_view text = bytes.substr(at + cda::kAssumedMark.size(), kLongest);
    const auto ends = [](char c) { return c < ' ' || c > '~' || c == '"' || c == '\''; };
    const std::string_view list =
        text.substr(0, static_cast<std::size_t>(std::ranges::find_if(text, ends) - text.begin()));
    return fmt::format("written by a run of ncsim that assumed: {}", list);
}

}  // namespace

SurfaceFile read_surface_file(const std::string& path, InputSet& inputs) {
    const std::string bytes = inputs.read(path);
    try {
        SurfaceFile file;
        if (is_step(bytes)) {
            StepSurface step = read_step(bytes, kStepDeflectionMm);
            file = {std::move(step.mesh), std::move(step.face_names), kStepDeflectionMm, true};
        } else {
            file.mesh = weld(corners_in(bytes));
            file.has_unit = is_gltf(bytes);
        }
        file.assumed = assumptions_in(bytes);
        const TriangleMesh& mesh = file.mesh;
        if (mesh.triangles.empty()) throw Refused{"it has no triangles"};
        if (const std::size_t open = open_edges(mesh); open > 0) {
            throw Refused{
                fmt::format("its surface is not closed ({} open edge{}): what is inside "
                            "of it?",
                            open, open == 1 ? "" : "s")};
        }
        if (!(cda::volume(mesh) > 0.0))
            throw Refused{"its surface is turned inside out: what is inside of it?"};
        return file;
    } catch (const Refused& refused) {
        throw std::runtime_error(fmt::format("'{}': {}", name_of_input(path), refused.reason));
    } catch (const std::runtime_error& e) {
        throw std::runtime_error(fmt::format("'{}': {}", name_of_input(path), e.what()));
    }
}

}  // namespace ncsim::setup
