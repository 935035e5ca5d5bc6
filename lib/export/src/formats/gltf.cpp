// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes glTF in three steps:
//  1. Sort triangles by the rank of their tool, with a primitive for each tool.
//  2. Within a primitive, share vertices between corners with equal point, normal
//     (corner_normals.h) and line.
//  3. Fill the buffer stream by stream (indices, positions, normals, lines, tools), with an
//     accessor for each stream of each primitive.
#include "ncsim/export/gltf.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/shape.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/mesh/float_mesh.h"

#include "formats/corner_normals.h"
#include "formats/file_text.h"
#include "formats/gltf_model.h"
#include "render/palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ncsim::exporter {

namespace {

struct Primitive {
    FaceSource maker{{}};
    std::vector<std::uint32_t> indices;
    std::vector<mesh::FloatPoint> positions;
    std::vector<mesh::FloatPoint> normals;
    std::vector<float> lines;
    std::vector<float> tools;

    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> last_at;  // for each point, the latest vertex
    std::vector<std::uint32_t> before;   // for each vertex, the preceding vertex at the same point

    std::uint32_t vertex(std::uint32_t point, const mesh::FloatPoint& position,
                         const mesh::FloatPoint& normal, mesh::Provenance::Entry entry);
};

// Returns the vertex at `point` with this normal and line; adds the vertex if there is none.
std::uint32_t Primitive::vertex(std::uint32_t point, const mesh::FloatPoint& position,
                                const mesh::FloatPoint& normal, mesh::Provenance::Entry entry) {
    const auto line = static_cast<float>(entry.nc_line);
    for (std::uint32_t v = last_at[point]; v != kNone; v = before[v]) {
        if (normals[v] == normal && lines[v] == line) return v;
    }
    const auto made = static_cast<std::uint32_t>(positions.size());
    before.push_back(std::exchange(last_at[point], made));
    positions.push_back(position);
    normals.push_back(normal);
    lines.push_back(line);
    tools.push_back(static_cast<float>(entry.tool));
    return made;
}

// Returns the primitives with at least one triangle (steps 1 and 2).
std::vector<Primitive> primitives(const PartMesh& part, const mesh::Provenance& provenance,
                                  const Palette& palette) {
    const auto& [boundary, mesh, centre, shading] = part;
    std::vector<Primitive> all(palette.face_sources().size());
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i].maker = palette.face_sources()[i];
    for (Primitive& primitive : all)
        primitive.last_at.assign(mesh.points.size(), Primitive::kNone);
    const CornerNormals normals(boundary, provenance, palette, shading);
    constexpr std::uint32_t kNoFace = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t current_face = kNoFace;
    std::unordered_map<std::uint32_t, std::uint32_t> local;  // point → vertex in the current face
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.face[t] != current_face) local.clear();
        current_face = mesh.face[t];
        const cda::BoundaryFace& face = boundary.faces[current_face];
        const mesh::Provenance::Entry entry = provenance.of(face.origin);
        Primitive& primitive = all[palette.rank(entry)];
        for (const std::uint32_t point : mesh.triangles[t]) {
            const auto [found, is_new] = local.try_emplace(point, 0);
            if (is_new) {
                const mesh::FloatPoint& p = mesh.points[point];
                const mesh::FloatPoint normal = mesh::to_floats(
                    normals.at(current_face, mesh.vertex[point], centre + Vec3{p[0], p[1], p[2]}));
                found->second = primitive.vertex(point, p, normal, entry);
            }
            primitive.indices.push_back(found->second);
        }
    }
    std::erase_if(all, [](const Primitive& primitive) { return primitive.indices.empty(); });
    return all;
}

tinygltf::Material material(const FaceSource& maker, Rgba8 colour) {
    tinygltf::Material result = plain_material(maker.name(), colour);
    result.extras = tinygltf::Value(
        tinygltf::Value::Object{{"tool", tinygltf::Value(static_cast<int>(maker.tool))}});
    return result;
}

tinygltf::Mesh mesh_of(const std::vector<Primitive>& primitives, const Palette& palette,
                       tinygltf::Model& model) {
    tinygltf::Mesh mesh;
    mesh.name = "part";
    Packer packer(model);
    for (const Primitive& from : primitives) {
        tinygltf::Primitive to;
        to.mode = TINYGLTF_MODE_TRIANGLES;
        to.material = static_cast<int>(model.materials.size());
        model.materials.push_back(material(from.maker, palette.colour(from.maker)));
        to.indices = packer.pack_indices(from.indices);
        to.attributes["POSITION"] = packer.pack_positions(from.positions);
        to.attributes["NORMAL"] = packer.pack_points(from.normals);
        to.attributes["_NC_LINE"] = packer.pack_floats(from.lines);
        to.attributes["_TOOL"] = packer.pack_floats(from.tools);
        mesh.primitives.push_back(std::move(to));
    }
    return mesh;
}

// Returns a node that converts mm relative to `centre`, z up, to metres, y up: x stays, z becomes
// y, y becomes -z.
tinygltf::Node node_of(Vec3 centre) {
    constexpr double kMetres = 0.001;
    const double half_root = std::sqrt(0.5);
    tinygltf::Node node;
    node.name = "part";
    node.mesh = 0;
    node.translation = {kMetres * centre.x, kMetres * centre.z, 0.0 - kMetres * centre.y};
    node.rotation = {-half_root, 0.0, 0.0, half_root};
    node.scale = {kMetres, kMetres, kMetres};
    return node;
}

// Returns the text of each line that cut a remaining face, by line number.
tinygltf::Value text_of_lines(const cda::Boundary& boundary, const mesh::Provenance& provenance) {
    tinygltf::Value::Object lines;
    for (const cda::BoundaryFace& face : boundary.faces) {
        const auto found = provenance.text.find(provenance.of(face.origin).nc_line);
        if (found == provenance.text.end()) continue;
        lines.try_emplace(std::to_string(found->first), printable_utf8(found->second));
    }
    return tinygltf::Value(std::move(lines));
}

void check_size(const std::vector<Primitive>& primitives) {
    std::uint64_t bytes = 0;
    for (const Primitive& p : primitives)
        bytes += 4 * p.indices.size() + 32 * p.positions.size();
    constexpr std::uint64_t kRoomForJson = std::uint64_t{1} << 26;
    if (bytes + kRoomForJson > std::numeric_limits<std::uint32_t>::max()) {
        throw std::runtime_error("the part is too large for a glTF file (4 GiB)");
    }
}

// Rounds each vertex independently of all others, so two files round a shared vertex to the same
// floats. Omits triangles with two equal corners.
mesh::FloatMesh round_vertices(const TriangleMesh& mesh, Vec3 centre) {
    mesh::FloatMesh result;
    result.points.reserve(mesh.vertices.size());
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        result.points.push_back(mesh::to_floats(mesh.vertices[v] - centre));
        result.vertex.push_back(v);
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const auto& p = result.points;
        if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a]) continue;
        result.triangles.push_back(mesh.triangles[t]);
        result.face.push_back(mesh.face[t]);
    }
    return result;
}

}  // namespace

Vec3 whole_centre(const cda::Boundary& boundary) {
    const Vec3 centre = cda::bounds(boundary).centre();
    return {std::round(centre.x), std::round(centre.y), std::round(centre.z)};
}

tinygltf::Material plain_material(const std::string& name, Rgba8 colour) {
    tinygltf::Material result;
    result.name = name;
    result.pbrMetallicRoughness.baseColorFactor = {linear_share(colour.r), linear_share(colour.g),
                                                   linear_share(colour.b), colour.a / 255.0};
    if (colour.a < 255) result.alphaMode = "BLEND";
    result.pbrMetallicRoughness.metallicFactor = 0.0;
    result.pbrMetallicRoughness.roughnessFactor = 0.6;
    return result;
}

tinygltf::Model model_of(const cda::Boundary& boundary, const mesh::Provenance& provenance) {
    tinygltf::Model model;
    model.asset.version = "2.0";
    model.asset.generator = "ncsim";
    model.asset.extras = tinygltf::Value(
        tinygltf::Value::Object{{"program", tinygltf::Value(printable_utf8(provenance.program))},
                                {"unit", tinygltf::Value(std::string("mm"))}});
    if (!provenance.assumed.empty()) {
        model.asset.extras.Get<tinygltf::Value::Object>().emplace(
            "assumptions", tinygltf::Value(std::string(cda::kAssumedMark) + provenance.assumed));
    }
    if (!provenance.text.empty()) {
        model.asset.extras.Get<tinygltf::Value::Object>().emplace(
            "lines", text_of_lines(boundary, provenance));
    }
    model.scenes.emplace_back();
    model.scenes.front().name = "part";  // tinygltf writes a scene without nodes and name as null
    model.defaultScene = 0;
    return model;
}

std::optional<int> add_part(tinygltf::Model& model, const PartMesh& part,
                            const mesh::Provenance& provenance) {
    const Palette palette(provenance);
    const std::vector<Primitive> parts = primitives(part, provenance, palette);
    check_size(parts);
    if (parts.empty()) return std::nullopt;
    model.meshes.push_back(mesh_of(parts, palette, model));
    return static_cast<int>(model.meshes.size()) - 1;
}

void write_model(std::ostream& out, tinygltf::Model& model) {
    constexpr bool kPretty = false;
    constexpr bool kBinary = true;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, out, kPretty, kBinary) || !out) {
        throw std::runtime_error("cannot write glTF: the stream failed");
    }
}

namespace {

void write_mesh(std::ostream& out, const PartMesh& part, const mesh::Provenance& provenance) {
    tinygltf::Model model = model_of(part.boundary, provenance);
    if (add_part(model, part, provenance)) {
        model.nodes.push_back(node_of(part.centre));
        model.scenes.front().nodes = {0};
    }
    write_model(out, model);
}

}  // namespace

void write_gltf(std::ostream& out, const cda::Boundary& boundary,
                const mesh::Provenance& provenance, std::size_t threads,
                const brep::Shading& shading) {
    const Vec3 centre = whole_centre(boundary);
    const mesh::FloatMesh mesh =
        mesh::round_to_floats(cda::triangulate(boundary, threads), centre, threads);
    write_mesh(out, {boundary, mesh, centre, shading}, provenance);
}

std::vector<mesh::FloatEdge> write_gltf_piece(std::ostream& out, const cda::Boundary& piece,
                                              const mesh::Provenance& provenance, Vec3 centre,
                                              const brep::Shading& shading) {
    const mesh::FloatMesh mesh = round_vertices(cda::triangulate(piece), centre);
    write_mesh(out, {piece, mesh, centre, shading}, provenance);
    mesh::Seams seams;
    for (const auto& corners : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i)
            seams.add({mesh.points[corners[i]], mesh.points[corners[(i + 1) % 3]]});
    }
    return seams.edges();
}

}  // namespace ncsim::exporter
