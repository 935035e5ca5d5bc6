// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes VRML in three steps:
//  1. Sort faces by line, then by tool (stable).
//  2. Write each run of one line as a Group, and each run of one tool within the group as a Shape.
//  3. In each Shape, list the points that its faces use, then the faces.
#include "ncsim/export/vrml.h"

#include "ncsim/cda/shape.h"
#include "ncsim/mesh/pieces.h"

#include "formats/file_text.h"
#include "formats/vrml_scene.h"
#include "render/palette.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace ncsim::exporter {

namespace {

using FaceIndex = std::uint32_t;

class VrmlWriter {
public:
    VrmlWriter(std::ostream& out, const cda::Boundary& boundary, const mesh::Provenance& provenance)
        : out_(out),
          boundary_(boundary),
          provenance_(provenance),
          palette_(provenance),
          pieces_(boundary),
          is_defined_(palette_.face_sources().size(), false) {}

    void write() {
        header();
        part();
        finish();
    }

    // Writes the part inside the tree of moving nodes.
    void write(const MovingScene& scene) {
        header();
        const VrmlScene moving(scene);
        text_ += "DEF MACHINE Group { children [\n";
        for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
            if (!scene.nodes[i].parent) node(scene, moving, i);
        }
        if (!scene.part_on) placed_part(scene, {});
        text_ += "] }\n";
        moving.append_interpolators(text_);
        finish();
    }

private:
    void node(const MovingScene& scene, const VrmlScene& moving, std::size_t number) {
        moving.begin_node(text_, number);
        if (scene.part_on == number) placed_part(scene, scene.nodes[number].origin);
        for (std::size_t i = number + 1; i < scene.nodes.size(); ++i) {
            if (scene.nodes[i].parent == number) node(scene, moving, i);
        }
        text_ += "] }\n";
        if (text_.size() >= kFlushSize) flush();
    }

    // Writes the part below its parent node, whose frame has its origin at `origin`.
    void placed_part(const MovingScene& scene, Vec3 origin) {
        text_ += "DEF PART Transform { translation ";
        append_point(text_, scene.zero - origin);
        text_ += " children [\n";
        part();
        text_ += "] }\n";
    }

    void part() {
        const std::vector<FaceIndex> order = faces_by_line();
        for (std::size_t i = 0; i < order.size();) {
            const auto same_line = [&](FaceIndex face) {
                return entry(face).nc_line == entry(order[i]).nc_line;
            };
            const auto end = std::find_if_not(order.begin() + static_cast<std::ptrdiff_t>(i),
                                              order.end(), same_line);
            const auto count = static_cast<std::size_t>(end - order.begin()) - i;
            group(std::span(order).subspan(i, count));
            i += count;
        }
    }

    void finish() {
        flush();
        if (!out_) throw std::runtime_error("cannot write VRML: the stream failed");
    }

    mesh::Provenance::Entry entry(FaceIndex face) const {
        return provenance_.of(boundary_.faces[face].origin);
    }

    std::vector<FaceIndex> faces_by_line() const {
        std::vector<FaceIndex> order(boundary_.faces.size());
        std::iota(order.begin(), order.end(), FaceIndex{0});
        std::stable_sort(order.begin(), order.end(), [&](FaceIndex a, FaceIndex b) {
            const mesh::Provenance::Entry ea = entry(a);
            const mesh::Provenance::Entry eb = entry(b);
            return std::pair(ea.nc_line, ea.tool) < std::pair(eb.nc_line, eb.tool);
        });
        return order;
    }

    void header() {
        text_ += "#VRML V2.0 utf8\n";
        text_ += "WorldInfo { title ";
        quoted(provenance_.program);
        text_ += " info [ \"made by ncsim\" \"unit: mm, z up\"";
        if (!provenance_.assumed.empty()) {
            text_ += ' ';
            quoted(std::string(cda::kAssumedMark) + provenance_.assumed);
        }
        text_ += " ] }\n";
    }

    void quoted(std::string_view words) {
        text_ += '"';
        for (const char c : printable_utf8(words)) {
            if (c == '"' || c == '\\') text_ += '\\';
            text_ += c;
        }
        text_ += '"';
    }

    // Writes all faces of a line.
    void group(std::span<const FaceIndex> faces) {
        const std::uint32_t line = entry(faces.front()).nc_line;
        text_ += "DEF ";
        text_ += line == 0 ? std::string("STOCK") : "LINE_" + std::to_string(line);
        text_ += " Group { children [\n";
        while (!faces.empty()) {
            const std::uint32_t tool = entry(faces.front()).tool;
            const auto end = std::find_if_not(faces.begin(), faces.end(), [&](FaceIndex face) {
                return entry(face).tool == tool;
            });
            const auto count = static_cast<std::size_t>(end - faces.begin());
            shape(faces.first(count));
            faces = faces.subspan(count);
        }
        text_ += "] }\n";
    }

    // Writes all faces of a tool and a line.
    void shape(std::span<const FaceIndex> faces) {
        text_ += "Shape {\nappearance ";
        appearance(entry(faces.front()));
        text_ += "\ngeometry IndexedFaceSet { coord Coordinate { point [\n";
        local_.clear();
        std::string polygons;
        for (const FaceIndex face : faces) {
            for (std::size_t i = 0; i < pieces_.count(face); ++i) {
                polygon(pieces_.corners(face, i), polygons);
            }
        }
        text_ += "] }\ncoordIndex [\n" + polygons + "] } }\n";
        if (text_.size() >= kFlushSize) flush();
    }

    // Appends a polygon to `polygons`, and the points that no earlier polygon of the shape uses to
    // the text.
    void polygon(std::span<const std::uint32_t> corners, std::string& polygons) {
        for (const std::uint32_t vertex : corners) {
            const auto [found, is_new] = local_.try_emplace(vertex, local_.size());
            if (is_new) point(pieces_.vertices()[vertex]);
            polygons += std::to_string(found->second);
            polygons += ' ';
        }
        polygons += "-1\n";
    }

    void point(Vec3 p) {
        append_point(text_, p);
        text_ += '\n';
    }

    // Writes the appearance in full for the first shape of a tool, and by name for later shapes.
    void appearance(mesh::Provenance::Entry by) {
        const std::size_t rank = palette_.rank(by);
        const FaceSource& maker = palette_.face_sources()[rank];
        const std::string name =
            maker.is_tool ? "TOOL_" + std::to_string(maker.tool) : std::string("STOCK_LOOK");
        if (is_defined_[rank]) {
            text_ += "USE " + name;
            return;
        }
        is_defined_[rank] = true;
        const Rgba8 colour = palette_.colour(by);
        text_ += "DEF " + name + ' ';
        append_appearance(text_, colour);
    }

    void flush() {
        out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
        text_.clear();
    }

    std::ostream& out_;
    const cda::Boundary& boundary_;
    const mesh::Provenance& provenance_;
    Palette palette_;
    mesh::Pieces pieces_;
    std::vector<bool> is_defined_;                          // appearances, by rank of the tool
    std::unordered_map<std::uint32_t, std::size_t> local_;  // vertex → point of this shape
    std::string text_;
};

}  // namespace

void write_vrml(std::ostream& out, const cda::Boundary& boundary,
                const mesh::Provenance& provenance) {
    VrmlWriter(out, boundary, provenance).write();
}

void write_vrml(std::ostream& out, const cda::Boundary& boundary,
                const mesh::Provenance& provenance, const MovingScene& scene) {
    VrmlWriter(out, boundary, provenance).write(scene);
}

}  // namespace ncsim::exporter
