// SPDX-License-Identifier: GPL-3.0-or-later
//
// A STEP file is a list of numbered entities. They are written in an order in which each
// refers to earlier ones only: units and product, then for each shell its faces, before each face
// the edges it is the first to use, before each edge its line and vertices.
#include "ncsim/export/step.h"

#include "ncsim/export/simplify.h"
#include "ncsim/trig/angles.h"

#include "palette.h"
#include "text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ncsim::exporter {

namespace {

using cda::Vec3;
using Entity = std::uint64_t;  // the number after #

constexpr std::size_t kFlushSize = std::size_t{1} << 20;
// Points nearer than this are one point to the reader, in mm. Above the rounding of coordinates,
// below the lattice on which parts are cut.
constexpr const char* kUncertainty = "1.E-06";
// Lines named in the name of a face at most.
constexpr std::size_t kNamedLines = 8;

// A real number of STEP always has a point.
std::string real(double number) {
    std::string text;
    append_number(text, number);
    const std::size_t exponent = text.find('e');
    if (exponent != std::string::npos) text[exponent] = 'E';
    if (text.find('.') == std::string::npos) {
        text.insert(std::min(exponent, text.size()), 1, '.');
    }
    return text;
}

void append_hex(std::string& text, std::uint32_t number, int digits) {
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
        text += "0123456789ABCDEF"[(number >> shift) & 0xF];
    }
}

// A string of STEP: ASCII in quotes, other characters by number (ISO 10303-21, 6.4.3).
std::string quoted(std::string_view words) {
    const std::string utf8 = printable_utf8(words);
    std::string text = "'";
    for (std::size_t i = 0; i < utf8.size();) {
        const auto lead = static_cast<std::uint8_t>(utf8[i]);
        if (lead < 0x80) {
            text += utf8[i];
            if (utf8[i] == '\'' || utf8[i] == '\\') text += utf8[i];
            ++i;
            continue;
        }
        const int length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        std::uint32_t number = lead & (0xFFU >> (length + 1));
        for (int j = 1; j < length; ++j) {
            number = number << 6 | (static_cast<std::uint8_t>(utf8[++i]) & 0x3FU);
        }
        ++i;
        text += length == 4 ? "\\X4\\" : "\\X2\\";
        append_hex(text, number, length == 4 ? 8 : 4);
        text += "\\X0\\";
    }
    return text + "'";
}

std::string ref(Entity entity) {
    std::string text = "#";
    text += std::to_string(entity);
    return text;
}

std::string list(std::span<const Entity> entities) {
    std::string text = "(";
    for (const Entity entity : entities) {
        if (text.size() > 1) text += ',';
        text += ref(entity);
    }
    text += ')';
    return text;
}

// Volume inside the faces, six times, about a common corner; negative for a void.
double sixfold_volume(const cda::Boundary& boundary, std::span<const std::size_t> faces) {
    double sum = 0.0;
    const Vec3 apex = boundary.vertices[boundary.faces[faces[0]].loops[0][0]];
    for (const std::size_t f : faces) {
        for (const auto& loop : boundary.faces[f].loops) {
            const Vec3 a = boundary.vertices[loop[0]] - apex;
            for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
                sum += cda::dot(a, cda::cross(boundary.vertices[loop[i]] - apex,
                                              boundary.vertices[loop[i + 1]] - apex));
            }
        }
    }
    return sum;
}

// How often the faces wind around the point: ±1 inside, 0 outside. Sum of the solid angles of the
// loops' triangles, signed (van Oosterom and Strackee, The Solid Angle of a Plane Triangle, 1983).
double winding_number(const cda::Boundary& boundary, std::span<const std::size_t> faces, Vec3 p) {
    double sum = 0.0;
    for (const std::size_t f : faces) {
        for (const auto& loop : boundary.faces[f].loops) {
            const Vec3 a = cda::normalized(boundary.vertices[loop[0]] - p);
            for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
                const Vec3 b = cda::normalized(boundary.vertices[loop[i]] - p);
                const Vec3 c = cda::normalized(boundary.vertices[loop[i + 1]] - p);
                sum += 2.0 * trig::angle_of(1.0 + cda::dot(a, b) + cda::dot(b, c) + cda::dot(c, a),
                                            cda::dot(a, cda::cross(b, c)));
            }
        }
    }
    return sum / 720.0;
}

struct Solid {
    std::vector<std::size_t> outside;             // faces
    std::vector<std::vector<std::size_t>> voids;  // faces of each
};

// Shells that enclose material, each with the voids that lie in it. `shells` is the number of them.
std::vector<Solid> solids_of(const cda::Boundary& boundary) {
    std::vector<std::vector<std::size_t>> shells(boundary.shells);
    for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
        const std::uint32_t shell = boundary.faces[f].shell;
        if (shell >= shells.size()) shells.resize(std::size_t{shell} + 1);
        shells[shell].push_back(f);
    }
    std::erase_if(shells, [](const auto& shell) { return shell.empty(); });
    std::vector<Solid> solids;
    std::vector<std::vector<std::size_t>> voids;
    for (auto& shell : shells) {
        if (sixfold_volume(boundary, shell) > 0.0) {
            solids.push_back({std::move(shell), {}});
        } else {
            voids.push_back(std::move(shell));
        }
    }
    for (auto& shell : voids) {
        const Vec3 point = boundary.vertices[boundary.faces[shell[0]].loops[0][0]];
        // Nothing to choose from with a single solid, the usual case.
        const auto around = std::find_if(solids.begin(), solids.end(), [&](const Solid& solid) {
            return solids.size() == 1 || winding_number(boundary, solid.outside, point) > 0.5;
        });
        if (around != solids.end()) around->voids.push_back(std::move(shell));
    }
    return solids;
}

class Writer {
public:
    Writer(std::ostream& out, const Simplified& part, const Provenance& provenance)
        : out_(out),
          boundary_(part.boundary),
          origins_(part.origins),
          provenance_(provenance),
          palette_(provenance),
          vertices_(boundary_.vertices.size()),
          styles_(palette_.makers().size(), 0) {}

    void write() {
        header();
        const Entity context = units();
        const Entity shape = product();
        std::vector<Entity> items{placement({0, 0, 0}, {0, 0, 1}, {1, 0, 0})};
        for (const Solid& solid : solids_of(boundary_))
            items.push_back(brep(solid));
        const std::string kind =
            items.size() > 1 ? "ADVANCED_BREP_SHAPE_REPRESENTATION" : "SHAPE_REPRESENTATION";
        const Entity representation = add(kind + "(''," + list(items) + "," + ref(context) + ")");
        add("SHAPE_DEFINITION_REPRESENTATION(" + ref(shape) + "," + ref(representation) + ")");
        if (!styled_.empty()) {
            add("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION(''," + list(styled_) +
                "," + ref(context) + ")");
        }
        text_ += "ENDSEC;\nEND-ISO-10303-21;\n";
        flush();
        if (!out_) throw std::runtime_error("cannot write STEP: the stream failed");
    }

private:
    Entity add(const std::string& entity) {
        ++last_;
        text_ += ref(last_) + "=" + entity + ";\n";
        if (text_.size() >= kFlushSize) flush();
        return last_;
    }

    void header() {
        text_ +=
            "ISO-10303-21;\nHEADER;\n"
            "FILE_DESCRIPTION(('part milled by an NC program'),'2;1');\n"
            "FILE_NAME(" +
            quoted(provenance_.program) +
            ",'1970-01-01T00:00:00',(''),(''),'ncsim','ncsim','');\n"
            "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\n"
            "ENDSEC;\nDATA;\n";
    }

    // Millimetres and radians; the context all geometry is in.
    Entity units() {
        const Entity length = add("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))");
        const Entity angle = add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))");
        const Entity solid = add("(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT())");
        const Entity uncertainty =
            add(std::string("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(") + kUncertainty + ")," +
                ref(length) + ",'distance_accuracy_value','')");
        return add("(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((" +
                   ref(uncertainty) + ")) GLOBAL_UNIT_ASSIGNED_CONTEXT(" +
                   list(std::array{length, angle, solid}) + ") REPRESENTATION_CONTEXT('',''))");
    }

    // The product that has a shape; the shape's definition.
    Entity product() {
        const std::string name =
            quoted(provenance_.program.empty() ? std::string("part") : provenance_.program);
        const Entity application =
            add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
        add("APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000," +
            ref(application) + ")");
        const Entity context = add("PRODUCT_CONTEXT(''," + ref(application) + ",'mechanical')");
        const Entity made = add("PRODUCT(" + name + "," + name + ",'',(" + ref(context) + "))");
        add("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(" + ref(made) + "))");
        const Entity formation = add("PRODUCT_DEFINITION_FORMATION('',''," + ref(made) + ")");
        const Entity design =
            add("PRODUCT_DEFINITION_CONTEXT('part definition'," + ref(application) + ",'design')");
        const Entity definition =
            add("PRODUCT_DEFINITION('design',''," + ref(formation) + "," + ref(design) + ")");
        return add("PRODUCT_DEFINITION_SHAPE('',''," + ref(definition) + ")");
    }

    static std::string triple(Vec3 v) {
        return "(" + real(v.x) + "," + real(v.y) + "," + real(v.z) + ")";
    }

    Entity point(Vec3 p) { return add("CARTESIAN_POINT(''," + triple(p) + ")"); }

    // Equal directions are one entity: parts have many parallel edges.
    Entity direction(Vec3 v) {
        std::string key = triple(v);
        const auto found = directions_.find(key);
        if (found != directions_.end()) return found->second;
        const Entity made = add("DIRECTION(''," + key + ")");
        directions_.emplace(std::move(key), made);
        return made;
    }

    Entity placement(Vec3 p, Vec3 z, Vec3 x) { return placement(point(p), z, x); }
    Entity placement(Entity p, Vec3 z, Vec3 x) {
        const Entity dz = direction(z);
        const Entity dx = direction(x);
        return add("AXIS2_PLACEMENT_3D(''," + ref(p) + "," + ref(dz) + "," + ref(dx) + ")");
    }

    struct Vertex {
        Entity point = 0, vertex = 0;
    };
    const Vertex& vertex(std::uint32_t i) {
        Vertex& v = vertices_[i];
        if (v.vertex == 0) {
            v.point = point(boundary_.vertices[i]);
            v.vertex = add("VERTEX_POINT(''," + ref(v.point) + ")");
        }
        return v;
    }

    Vec3 along(std::uint32_t a, std::uint32_t b) const {
        return cda::normalized(boundary_.vertices[b] - boundary_.vertices[a]);
    }

    // The edge between two vertices, from the one with the smaller number to the other.
    Entity edge(std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax(a, b);
        const std::uint64_t key = std::uint64_t{low} << 32 | high;
        const auto found = edges_.find(key);
        if (found != edges_.end()) return found->second;
        const Vertex from = vertex(low);
        const Vertex to = vertex(high);
        const Entity vector = add("VECTOR(''," + ref(direction(along(low, high))) + ",1.)");
        const Entity line = add("LINE(''," + ref(from.point) + "," + ref(vector) + ")");
        const Entity made = add("EDGE_CURVE(''," + ref(from.vertex) + "," + ref(to.vertex) + "," +
                                ref(line) + ",.T.)");
        edges_.emplace(key, made);
        return made;
    }

    Entity edge_loop(const std::vector<std::uint32_t>& loop) {
        std::vector<Entity> oriented;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const std::uint32_t a = loop[i];
            const std::uint32_t b = loop[(i + 1) % loop.size()];
            const Entity of = edge(a, b);
            oriented.push_back(
                add("ORIENTED_EDGE('',*,*," + ref(of) + (a < b ? ",.T.)" : ",.F.)")));
        }
        return add("EDGE_LOOP(''," + list(oriented) + ")");
    }

    std::string name_of(std::size_t face) const {
        std::vector<std::uint32_t> lines;
        for (const cda::Origin origin : origins_[face]) {
            lines.push_back(provenance_.of(origin).nc_line);
        }
        std::sort(lines.begin(), lines.end());
        lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
        if (lines.front() == 0) return "STOCK";
        std::string name = "LINE";
        for (std::size_t i = 0; i < std::min(lines.size(), kNamedLines); ++i) {
            name += '_';
            name += std::to_string(lines[i]);
        }
        return lines.size() > kNamedLines ? name + "_ETC" : name;
    }

    Entity face(std::size_t f) {
        const cda::BoundaryFace& from = boundary_.faces[f];
        std::vector<Entity> bounds;
        for (const auto& loop : from.loops) {
            const Entity of = edge_loop(loop);
            bounds.push_back(add((bounds.empty() ? "FACE_OUTER_BOUND(''," : "FACE_BOUND('',") +
                                 ref(of) + ",.T.)"));
        }
        const auto& outline = from.loops.front();
        const Entity where =
            placement(vertex(outline[0]).point, from.normal,
                      along(std::min(outline[0], outline[1]), std::max(outline[0], outline[1])));
        const Entity plane = add("PLANE(''," + ref(where) + ")");
        const Entity made =
            add("ADVANCED_FACE('" + name_of(f) + "'," + list(bounds) + "," + ref(plane) + ",.T.)");
        const Entity look = style(provenance_.of(from.origin));
        styled_.push_back(add("STYLED_ITEM('',(" + ref(look) + ")," + ref(made) + ")"));
        return made;
    }

    // The colour of a tool.
    Entity style(Provenance::Entry entry) {
        Entity& made = styles_[palette_.rank(entry)];
        if (made != 0) return made;
        const Rgba8 colour = palette_.colour(entry);
        std::string rgb;
        for (const std::uint8_t channel : {colour.r, colour.g, colour.b}) {
            rgb += ',';
            rgb += real(unit_share(channel));
        }
        const Entity of = add("COLOUR_RGB(''" + rgb + ")");
        const Entity fill = add("FILL_AREA_STYLE_COLOUR(''," + ref(of) + ")");
        const Entity area = add("FILL_AREA_STYLE('',(" + ref(fill) + "))");
        const Entity surface = add("SURFACE_STYLE_FILL_AREA(" + ref(area) + ")");
        const Entity side = add("SURFACE_SIDE_STYLE('',(" + ref(surface) + "))");
        const Entity usage = add("SURFACE_STYLE_USAGE(.BOTH.," + ref(side) + ")");
        made = add("PRESENTATION_STYLE_ASSIGNMENT((" + ref(usage) + "))");
        return made;
    }

    Entity shell(std::span<const std::size_t> faces) {
        std::vector<Entity> made;
        for (const std::size_t f : faces)
            made.push_back(face(f));
        return add("CLOSED_SHELL(''," + list(made) + ")");
    }

    Entity brep(const Solid& solid) {
        const Entity outside = shell(solid.outside);
        if (solid.voids.empty()) return add("MANIFOLD_SOLID_BREP(''," + ref(outside) + ")");
        std::vector<Entity> voids;
        for (const auto& faces : solid.voids) {
            const Entity inside = shell(faces);
            voids.push_back(add("ORIENTED_CLOSED_SHELL('',*," + ref(inside) + ",.T.)"));
        }
        return add("BREP_WITH_VOIDS(''," + ref(outside) + "," + list(voids) + ")");
    }

    void flush() {
        out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
        text_.clear();
    }

    std::ostream& out_;
    const cda::Boundary& boundary_;
    const std::vector<std::vector<cda::Origin>>& origins_;
    const Provenance& provenance_;
    Palette palette_;
    Entity last_ = 0;
    std::string text_;
    std::vector<Vertex> vertices_;
    std::unordered_map<std::uint64_t, Entity> edges_;     // by the two vertices
    std::unordered_map<std::string, Entity> directions_;  // by their text
    std::vector<Entity> styles_;                          // by rank of the tool; 0: not yet
    std::vector<Entity> styled_;
};

}  // namespace

void write_step(std::ostream& out, const cda::Boundary& boundary, const Provenance& provenance,
                const StepOptions& options) {
    const Simplified part = simplify(boundary, options.tolerance_mm);
    if (part.boundary.faces.size() > options.max_faces) {
        throw std::runtime_error("the part has " + std::to_string(part.boundary.faces.size()) +
                                 " faces, more than the " + std::to_string(options.max_faces) +
                                 " that a STEP file is to have (--step-max-faces, --simplify)");
    }
    Writer(out, part, provenance).write();
}

}  // namespace ncsim::exporter
