// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as binary PLY.
#include "ncsim/export/ply.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/boundary.h"

#include "formats/file_text.h"
#include "render/palette.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>

namespace ncsim::exporter {

namespace {

template <typename Unsigned>
void append(std::string& bytes, Unsigned number) {
    for (std::size_t i = 0; i < sizeof number; ++i) {
        bytes.push_back(static_cast<char>((number >> (8 * i)) & 0xFF));
    }
}

void append(std::string& bytes, double number) {
    append(bytes, std::bit_cast<std::uint64_t>(number + 0.0));  // turns -0 into 0
}

std::string header(const mesh::Provenance& provenance, std::size_t vertices, std::size_t faces) {
    return "ply\nformat binary_little_endian 1.0\n"
           "comment made by ncsim from " +
           printable_utf8(provenance.program) +
           "\ncomment unit: mm, z up\n"
           "element vertex " +
           std::to_string(vertices) +
           "\nproperty double x\nproperty double y\nproperty double z\n"
           "element face " +
           std::to_string(faces) +
           "\nproperty list uchar int vertex_indices\n"
           "property uint nc_line\nproperty uint tool\n"
           "property uchar red\nproperty uchar green\nproperty uchar blue\n"
           "end_header\n";
}

}  // namespace

void write_ply(std::ostream& out, const cda::Boundary& boundary, const TriangleMesh& mesh,
               const mesh::Provenance& provenance) {
    const Palette palette(provenance);
    std::string bytes = header(provenance, mesh.vertices.size(), mesh.triangles.size());
    const auto flush = [&](std::size_t limit) {
        if (bytes.size() < limit) return;
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        bytes.clear();
    };
    for (const Vec3& p : mesh.vertices) {
        append(bytes, p.x);
        append(bytes, p.y);
        append(bytes, p.z);
        flush(kFlushSize);
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const mesh::Provenance::Entry entry = provenance.of(boundary.faces[mesh.face[t]].origin);
        const Rgba8 colour = palette.colour(entry);
        append(bytes, std::uint8_t{3});
        for (const std::uint32_t vertex : mesh.triangles[t])
            append(bytes, vertex);
        append(bytes, entry.nc_line);
        append(bytes, entry.tool);
        for (const std::uint8_t channel : {colour.r, colour.g, colour.b}) {
            append(bytes, channel);
        }
        flush(kFlushSize);
    }
    flush(0);
    if (!out) throw std::runtime_error("cannot write PLY: the stream failed");
}

}  // namespace ncsim::exporter
