// SPDX-License-Identifier: GPL-3.0-or-later
//
// Functions that glTF files of a part and of a machine share.
#pragma once

#include "ncsim/brep/part_shading.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/export/image.h"
#include "ncsim/mesh/float_mesh.h"
#include "ncsim/mesh/provenance.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::exporter {

/// Appends arrays to the single buffer of a model, with buffer views and accessors.
class Packer {
public:
    explicit Packer(tinygltf::Model& model) : model_(model) {
        if (model_.buffers.empty()) model_.buffers.emplace_back();
    }

    /// Adds an accessor over `values`. `target` is kNoTarget for data of an animation.
    /// Returns: the number of the accessor.
    template <typename T>
    int pack(const std::vector<T>& values, int component_type, int type, int target) {
        std::vector<unsigned char>& bytes = model_.buffers.front().data;
        constexpr std::size_t kAlignment = 4;
        bytes.resize((bytes.size() + kAlignment - 1) / kAlignment * kAlignment);
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = bytes.size();
        view.byteLength = values.size() * sizeof(T);
        view.target = target;
        for (const T& value : values)
            append_value(bytes, value);
        model_.bufferViews.push_back(std::move(view));
        tinygltf::Accessor accessor;
        accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
        accessor.componentType = component_type;
        accessor.type = type;
        accessor.count = values.size();
        model_.accessors.push_back(std::move(accessor));
        return static_cast<int>(model_.accessors.size()) - 1;
    }

    /// Adds `indices` with two bytes each if all are below 65,535, which is reserved; otherwise
    /// with four bytes.
    int pack_indices(const std::vector<std::uint32_t>& indices) {
        constexpr std::uint32_t kMostInTwoBytes = 65534;
        const auto fits = [](std::uint32_t index) { return index <= kMostInTwoBytes; };
        if (std::ranges::all_of(indices, fits)) {
            std::vector<std::uint16_t> narrow;
            narrow.reserve(indices.size());
            for (const std::uint32_t index : indices)
                narrow.push_back(static_cast<std::uint16_t>(index));
            return pack(narrow, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR,
                        TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        }
        return pack(indices, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                    TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    }
    int pack_floats(const std::vector<float>& values) {
        return pack(values, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR,
                    TINYGLTF_TARGET_ARRAY_BUFFER);
    }
    int pack_points(const std::vector<mesh::FloatPoint>& points) {
        return pack(points, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3,
                    TINYGLTF_TARGET_ARRAY_BUFFER);
    }
    /// Adds positions with their bounds, as glTF requires.
    int pack_positions(const std::vector<mesh::FloatPoint>& points) {
        const int number = pack_points(points);
        tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(number)];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto [least, greatest] =
                std::minmax_element(points.begin(), points.end(),
                                    [&](const mesh::FloatPoint& a, const mesh::FloatPoint& b) {
                                        return a[axis] < b[axis];
                                    });
            accessor.minValues.push_back(static_cast<double>((*least)[axis]));
            accessor.maxValues.push_back(static_cast<double>((*greatest)[axis]));
        }
        return number;
    }

    /// Adds times in seconds with their bounds.
    /// Requires: `seconds` is ascending and not empty.
    int pack_times(const std::vector<float>& seconds) {
        const int number =
            pack(seconds, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR, kNoTarget);
        tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(number)];
        accessor.minValues = {static_cast<double>(seconds.front())};
        accessor.maxValues = {static_cast<double>(seconds.back())};
        return number;
    }
    /// Adds translations or scales of nodes.
    int pack_places(const std::vector<mesh::FloatPoint>& places) {
        return pack(places, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, kNoTarget);
    }
    /// Adds rotations of nodes as quaternions.
    int pack_turns(const std::vector<std::array<float, 4>>& quaternions) {
        return pack(quaternions, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC4, kNoTarget);
    }

private:
    static constexpr int kNoTarget = 0;

    static void append_value(std::vector<unsigned char>& bytes, std::uint32_t number) {
        for (int shift = 0; shift < 32; shift += 8)
            bytes.push_back(static_cast<unsigned char>((number >> shift) & 0xFF));
    }
    static void append_value(std::vector<unsigned char>& bytes, std::uint16_t number) {
        for (int shift = 0; shift < 16; shift += 8)
            bytes.push_back(static_cast<unsigned char>((number >> shift) & 0xFF));
    }
    static void append_value(std::vector<unsigned char>& bytes, float number) {
        append_value(bytes, std::bit_cast<std::uint32_t>(number));
    }
    template <std::size_t N>
    static void append_value(std::vector<unsigned char>& bytes,
                             const std::array<float, N>& numbers) {
        for (const float number : numbers)
            append_value(bytes, number);
    }

    tinygltf::Model& model_;
};

/// The surface of a part and its triangles in floats.
struct PartMesh {
    const cda::Boundary& boundary;
    const mesh::FloatMesh& mesh;  ///< Triangles of `boundary`, relative to `centre`.
    Vec3 centre;                  ///< In mm, W.
    const brep::Shading& shading;
};

/// Returns a model whose asset names ncsim, the program and the unit, with the text of each line
/// that cut a remaining face.
tinygltf::Model model_of(const cda::Boundary& boundary, const mesh::Provenance& provenance);
/// Adds the part, with a primitive for each tool.
/// Returns: the number of the mesh; nullopt if the part is empty.
/// Throws: std::runtime_error if the part is too large for the format.
std::optional<int> add_part(tinygltf::Model& model, const PartMesh& part,
                            const mesh::Provenance& provenance);
/// Returns the centre of the part rounded to whole mm, so positions with few decimals keep few
/// decimals.
Vec3 whole_centre(const cda::Boundary& boundary);
/// Returns a material with `colour` (sRGB) and without gloss.
tinygltf::Material plain_material(const std::string& name, Rgba8 colour);
/// Throws: std::runtime_error if the stream fails.
void write_model(std::ostream& out, tinygltf::Model& model);

}  // namespace ncsim::exporter
