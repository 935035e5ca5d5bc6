// SPDX-License-Identifier: GPL-3.0-or-later
//
// A STEP file is a list of numbered entities, written in an order in which each entity refers only
// to earlier entities: units and product, then the faces of each shell, before each face the edges
// that no earlier face uses, and before each edge its curve and vertices.
#include "ncsim/export/step.h"

#include "ncsim/base/angles.h"
#include "ncsim/brep/frames.h"
#include "ncsim/brep/long_windings.h"
#include "ncsim/brep/parameter_curve.h"
#include "ncsim/brep/patch.h"
#include "ncsim/cda/shape.h"
#include "ncsim/mesh/simplify.h"

#include "formats/file_text.h"
#include "render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::exporter {

namespace {

using Entity = std::uint64_t;  // number after #

// Smallest uncertainty in a file, in mm: readers identify points that are nearer. The value is
// above the rounding of coordinates and below the lattice on which parts are cut.
constexpr const char* kUncertainty = "1.E-06";
constexpr double kUncertaintyMm = 1e-6;
// Largest number of lines in the name of a face.
constexpr std::size_t kNamedLines = 8;

// Returns a real number in STEP form, always with a decimal point.
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

// Returns a STEP string: ASCII in quotes, other characters by number (ISO 10303-21, 6.4.3).
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

// Returns the uncertainty of the file: the largest distance of an edge from its surfaces, at least
// kUncertaintyMm.
std::string uncertainty_of(const brep::Part& part) {
    return part.miss_mm > kUncertaintyMm ? real(part.miss_mm) : kUncertainty;
}

class StepWriter {
public:
    StepWriter(std::ostream& out, const brep::Part& part, const mesh::Provenance& provenance,
               const StepOptions& options)
        : out_(out),
          part_(part),
          provenance_(provenance),
          options_(options),
          palette_(provenance),
          vertices_(part.vertices.size()),
          edges_(part.edges.size(), 0),
          styles_(palette_.face_sources().size(), 0),
          faces_(part.faces.size(), 0),
          surfaces_(part.faces.size()),
          faces_of_edge_(part.edges.size(), {kNoFace, kNoFace}) {
        for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
            for (const brep::Loop& loop : part.faces[f].loops) {
                for (const brep::EdgeUse& use : loop)
                    faces_of_edge_[use.edge][use.is_forward ? 0 : 1] = f;
            }
        }
    }

    void write() {
        header();
        context_ = units();
        products();
        const Product whole = product(
            quoted(provenance_.program.empty() ? std::string("part") : provenance_.program));
        const Entity origin = placement({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
        std::vector<Product> parts;  // with solids
        if (part_.solids.size() > 1) {
            parts = assembly(whole, origin);
        } else {
            std::vector<Entity> items{origin};
            for (const brep::Solid& solid : part_.solids)
                items.push_back(solid_brep(solid, name_of_solid(0)));
            parts = {represented(whole, items)};
        }
        if (!styled_.empty()) {
            add("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION(''," + list(styled_) +
                "," + ref(context_) + ")");
        }
        validate(whole, parts);
        if (options_.has_attributes) attribute(parts);
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
            "FILE_DESCRIPTION(('part milled by an NC program'" +
            (provenance_.assumed.empty()
                 ? std::string()
                 : "," + quoted(std::string(cda::kAssumedMark) + provenance_.assumed)) +
            "),'2;1');\n"
            "FILE_NAME(" +
            quoted(provenance_.program) +
            ",'1970-01-01T00:00:00',(''),(''),'ncsim','ncsim','');\n"
            "FILE_SCHEMA(('" +
            std::string(is_242() ? "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF"
                                   " { 1 0 10303 442 1 1 4 }"
                                 : "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }") +
            "'));\nENDSEC;\nDATA;\n";
    }

    bool is_242() const { return options_.schema == StepSchema::Ap242; }

    // Writes the units (mm, radians) and the context of all geometry. Returns the context.
    Entity units() {
        const Entity length = add("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))");
        length_ = length;
        const Entity angle = add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))");
        const Entity solid = add("(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT())");
        const Entity uncertainty =
            add("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(" + uncertainty_of(part_) + ")," +
                ref(length) + ",'distance_accuracy_value','')");
        return add("(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((" +
                   ref(uncertainty) + ")) GLOBAL_UNIT_ASSIGNED_CONTEXT(" +
                   list(std::array{length, angle, solid}) + ") REPRESENTATION_CONTEXT('',''))");
    }

    struct Product {
        Entity definition = 0, shape = 0;  // shape: the definition of the shape
        Entity representation = 0;
        Entity place = 0;  // in the representation, for an assembly
    };

    // Writes the contexts of all products.
    void products() {
        const Entity application =
            add(is_242() ? "APPLICATION_CONTEXT('managed model based 3d engineering')"
                         : "APPLICATION_CONTEXT('core data for automotive mechanical design "
                           "processes')");
        add("APPLICATION_PROTOCOL_DEFINITION('international standard'," +
            std::string(is_242() ? "'ap242_managed_model_based_3d_engineering',2014,"
                                 : "'automotive_design',2000,") +
            ref(application) + ")");
        product_context_ = add("PRODUCT_CONTEXT(''," + ref(application) + ",'mechanical')");
        design_context_ =
            add("PRODUCT_DEFINITION_CONTEXT('part definition'," + ref(application) + ",'design')");
    }

    // Writes a product without a representation of its shape. `name` is quoted.
    Product product(const std::string& name) {
        const Entity made =
            add("PRODUCT(" + name + "," + name + ",'',(" + ref(product_context_) + "))");
        add("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(" + ref(made) + "))");
        const Entity formation = add("PRODUCT_DEFINITION_FORMATION('',''," + ref(made) + ")");
        Product result;
        result.definition = add("PRODUCT_DEFINITION('design',''," + ref(formation) + "," +
                                ref(design_context_) + ")");
        result.shape = add("PRODUCT_DEFINITION_SHAPE('',''," + ref(result.definition) + ")");
        return result;
    }

    // Writes the representation of the shape of `product`: a placement, and solids or further
    // placements. Returns the product with its representation.
    Product represented(Product product, const std::vector<Entity>& items, bool has_solids = true) {
        const std::string kind = has_solids && items.size() > 1
                                     ? "ADVANCED_BREP_SHAPE_REPRESENTATION"
                                     : "SHAPE_REPRESENTATION";
        product.representation = add(kind + "(''," + list(items) + "," + ref(context_) + ")");
        add("SHAPE_DEFINITION_REPRESENTATION(" + ref(product.shape) + "," +
            ref(product.representation) + ")");
        return product;
    }

    static std::string name_of_solid(std::size_t number) {
        return "SOLID_" + std::to_string(number + 1);
    }

    // Writes each solid as a product of its own in the assembly `whole`, because readers show names
    // of products, not of solids. Returns the products of the solids.
    std::vector<Product> assembly(const Product& whole, Entity origin) {
        std::vector<Product> parts;
        std::vector<Entity> places{origin};
        for (std::size_t i = 0; i < part_.solids.size(); ++i) {
            const std::string name = name_of_solid(i);
            const Entity solid = solid_brep(part_.solids[i], name);
            const Entity place = placement({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
            parts.push_back(represented(product(quoted(name)), {place, solid}));
            parts.back().place = place;
            places.push_back(placement({0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
        }
        const Product all = represented(whole, places, false);
        for (std::size_t i = 0; i < parts.size(); ++i)
            place_part(all, parts[i], quoted(name_of_solid(i)), places[i + 1]);
        return parts;
    }

    // Writes the use of `part` in the assembly `whole`, at the placement `place` there.
    void place_part(const Product& whole, const Product& part, const std::string& name,
                    Entity place) {
        const Entity use = add("NEXT_ASSEMBLY_USAGE_OCCURRENCE(" + name + "," + name + ",''," +
                               ref(whole.definition) + "," + ref(part.definition) + ",$)");
        const Entity shape = add("PRODUCT_DEFINITION_SHAPE('',''," + ref(use) + ")");
        const Entity same =
            add("ITEM_DEFINED_TRANSFORMATION('',''," + ref(part.place) + "," + ref(place) + ")");
        const Entity relation =
            add("(REPRESENTATION_RELATIONSHIP('',''," + ref(part.representation) + "," +
                ref(whole.representation) + ")REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(" +
                ref(same) + ")SHAPE_REPRESENTATION_RELATIONSHIP())");
        add("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(" + ref(relation) + "," + ref(shape) + ")");
    }

    static std::string triple(Vec3 v) {
        return "(" + real(v.x) + "," + real(v.y) + "," + real(v.z) + ")";
    }

    Entity point(Vec3 p) { return add("CARTESIAN_POINT(''," + triple(p) + ")"); }

    // Returns a shared entity for equal directions, because parts have many parallel edges.
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
            v.point = point(part_.vertices[i]);
            v.vertex = add("VERTEX_POINT(''," + ref(v.point) + ")");
        }
        return v;
    }

    Entity edge(std::uint32_t number) {
        Entity& made = edges_[number];
        if (made != 0) return made;
        const brep::Edge& e = part_.edges[number];
        const Vertex from = vertex(e.from);
        const Vertex to = vertex(e.to);
        const Entity curve = with_parameters(
            std::visit([&](const auto& c) { return curve_of(c, e, from); }, e.curve), number);
        made = add("EDGE_CURVE(''," + ref(from.vertex) + "," + ref(to.vertex) + "," + ref(curve) +
                   ",.T.)");
        return made;
    }

    // Adds to a curve what it is in the parameters of its surfaces. Without these, readers project
    // the curve, and their Booleans find what they miss by.
    Entity with_parameters(Entity curve, std::uint32_t number) {
        const auto& faces = faces_of_edge_[number];
        if (faces[0] == faces[1]) return curve;
        std::vector<Entity> in_parameters;
        for (const std::uint32_t f : faces) {
            if (f == kNoFace) continue;
            const Surface& on = surface(f);
            if (!on.parameters) continue;
            const auto found = on.parameters->curve_of(part_, part_.edges[number]);
            if (found) in_parameters.push_back(parameter_curve(on.entity, *found));
        }
        if (in_parameters.empty()) return curve;
        return add("SURFACE_CURVE(''," + ref(curve) + "," + list(in_parameters) + ",.CURVE_3D.)");
    }

    Entity parameter_curve(Entity surface, const brep::ParameterCurve& curve) {
        if (flat_context_ == 0)
            flat_context_ =
                add("(GEOMETRIC_REPRESENTATION_CONTEXT(2) PARAMETRIC_REPRESENTATION_CONTEXT() "
                    "REPRESENTATION_CONTEXT('',''))");
        std::vector<Entity> points;
        points.reserve(curve.points.size());
        // More digits are below what the curve is off.
        const auto rounded = [](double x) { return real(std::round(1e11 * x) / 1e11); };
        for (const auto& [u, v] : curve.points)
            points.push_back(add("CARTESIAN_POINT('',(" + rounded(u) + "," + rounded(v) + "))"));
        const Entity spline = b_spline(points, curve.knots);
        const Entity definition =
            add("DEFINITIONAL_REPRESENTATION('',(" + ref(spline) + ")," + ref(flat_context_) + ")");
        return add("PCURVE(''," + ref(surface) + "," + ref(definition) + ")");
    }

    Entity b_spline(const std::vector<Entity>& points, const std::vector<double>& at) {
        const Knots knots(at, 3);
        return add("B_SPLINE_CURVE_WITH_KNOTS('',3," + list(points) + ",.UNSPECIFIED.,.F.,.F.," +
                   knots.multiplicities + "," + knots.places + ",.UNSPECIFIED.)");
    }

    Entity curve_of(const brep::Line&, const brep::Edge& e, const Vertex& from) {
        const Vec3 along = normalized(part_.vertices[e.to] - part_.vertices[e.from]);
        const Entity vector = add("VECTOR(''," + ref(direction(along)) + ",1.)");
        return add("LINE(''," + ref(from.point) + "," + ref(vector) + ")");
    }

    // The parameter of the circle is 0 at the start of the edge.
    Entity curve_of(const brep::Circle& c, const brep::Edge& e, const Vertex&) {
        const Vec3 out = part_.vertices[e.from] - c.centre;
        const Vec3 x = normalized(out - dot(out, c.axis) * c.axis);
        return add("CIRCLE(''," + ref(placement(c.centre, c.axis, x)) + "," + real(c.radius) + ")");
    }

    Entity curve_of(const brep::Ellipse& c, const brep::Edge&, const Vertex&) {
        return add("ELLIPSE(''," + ref(placement(c.centre, c.axis, c.major)) + "," +
                   real(c.major_radius) + "," + real(c.minor_radius) + ")");
    }

    Entity curve_of(const brep::Spline& c, const brep::Edge&, const Vertex&) {
        std::vector<Entity> points;
        for (const Vec3& p : c.points)
            points.push_back(point(p));
        return b_spline(points, c.knots);
    }

    struct Knots {
        Knots(const std::vector<double>& knots, int degree) {
            const std::string end = std::to_string(degree + 1);
            const std::string inner = std::to_string((degree + 1) / 2);
            for (std::size_t i = 0; i < knots.size(); ++i) {
                multiplicities += i == 0 ? '(' : ',';
                places += i == 0 ? '(' : ',';
                multiplicities += i == 0 || i + 1 == knots.size() ? end : inner;
                places += real(knots[i]);
            }
            multiplicities += ')';
            places += ')';
        }
        std::string multiplicities, places;
    };

    Entity edge_loop(const brep::Loop& loop) {
        std::vector<Entity> oriented;
        for (const brep::EdgeUse& use : loop) {
            const Entity of = edge(use.edge);
            oriented.push_back(
                add("ORIENTED_EDGE('',*,*," + ref(of) + (use.is_forward ? ",.T.)" : ",.F.)")));
        }
        return add("EDGE_LOOP(''," + list(oriented) + ")");
    }

    std::string name_of(const brep::Face& face) const {
        std::vector<std::uint32_t> lines;
        std::uint32_t earlier = 0;
        for (const cda::Origin origin : face.origins) {
            const mesh::Provenance::Entry entry = provenance_.of(origin);
            earlier = std::max(earlier, entry.earlier_program);
            if (entry.earlier_program == 0) lines.push_back(entry.nc_line);
        }
        std::sort(lines.begin(), lines.end());
        lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
        if (lines.empty()) return "EARLIER " + provenance_.earlier_programs[earlier - 1];
        if (lines.front() == 0) return "STOCK";
        std::string name = "LINE";
        for (std::size_t i = 0; i < std::min(lines.size(), kNamedLines); ++i) {
            name += '_';
            name += std::to_string(lines[i]);
        }
        return lines.size() > kNamedLines ? name + "_ETC" : name;
    }

    // --- Properties -------------------------------------------------------------------------

    Entity power_of_length(int power) {
        const Entity element = add("DERIVED_UNIT_ELEMENT(" + ref(length_) + "," +
                                   real(static_cast<double>(power)) + ")");
        return add("DERIVED_UNIT((" + ref(element) + "))");
    }

    // Writes validation properties of the part, and of each solid if there are several.
    void validate(const Product& whole, const std::vector<Product>& parts) {
        if (part_.solids.empty()) return;
        square_ = power_of_length(2);
        cube_ = power_of_length(3);
        validate(whole.shape, options_.mass ? *options_.mass : brep::mass_of(part_));
        if (part_.solids.size() == 1) return;
        for (std::size_t i = 0; i < parts.size(); ++i)
            validate(parts[i].shape, brep::mass_of(part_, part_.solids[i]));
    }

    void validate(Entity of, const brep::Mass& mass) {
        const auto property = [&](const std::string& name, Entity item) {
            const Entity definition = add("PROPERTY_DEFINITION('geometric validation property','" +
                                          name + "'," + ref(of) + ")");
            const Entity value =
                add("REPRESENTATION('" + name + "',(" + ref(item) + ")," + ref(context_) + ")");
            add("PROPERTY_DEFINITION_REPRESENTATION(" + ref(definition) + "," + ref(value) + ")");
        };
        property("volume", add("MEASURE_REPRESENTATION_ITEM('volume measure',VOLUME_MEASURE(" +
                               real(mass.volume) + ")," + ref(cube_) + ")"));
        property("surface area",
                 add("MEASURE_REPRESENTATION_ITEM('surface area measure',AREA_MEASURE(" +
                     real(mass.area) + ")," + ref(square_) + ")"));
        property("centroid", add("CARTESIAN_POINT('centre point'," + triple(mass.centroid) + ")"));
    }

    // Writes a shape aspect of a face of `product` that can carry properties. Returns the aspect.
    Entity aspect_of(const std::string& name, Entity face, const Product& product) {
        const Entity aspect = add("SHAPE_ASPECT('" + name + "',''," + ref(product.shape) + ",.T.)");
        if (is_242()) {
            add("GEOMETRIC_ITEM_SPECIFIC_USAGE('',''," + ref(aspect) + "," +
                ref(product.representation) + "," + ref(face) + ")");
        } else {
            const Entity definition =
                add("PROPERTY_DEFINITION('shape with specific properties',''," + ref(aspect) + ")");
            const Entity only =
                add("SHAPE_REPRESENTATION('',(" + ref(face) + ")," + ref(context_) + ")");
            add("SHAPE_DEFINITION_REPRESENTATION(" + ref(definition) + "," + ref(only) + ")");
        }
        return aspect;
    }

    // Returns the number of the solid with each face.
    std::vector<std::size_t> solids_of_faces() const {
        std::vector<std::size_t> solids(part_.faces.size(), 0);
        for (std::size_t i = 0; i < part_.solids.size(); ++i) {
            for (const std::uint32_t f : part_.solids[i].outside)
                solids[f] = i;
            for (const brep::Shell& shell : part_.solids[i].voids) {
                for (const std::uint32_t f : shell)
                    solids[f] = i;
            }
        }
        return solids;
    }

    void attribute(const std::vector<Product>& parts) {
        struct Attribute {
            std::string name;
            Entity general = 0;
            std::unordered_map<std::string, Entity> values{};  // equal values share an entity
        };
        std::array<Attribute, 3> attributes{{{"nc_lines"}, {"tools"}, {"kind"}}};
        for (Attribute& a : attributes)
            a.general = add("GENERAL_PROPERTY('','" + a.name + "','')");
        const std::vector<std::size_t> solids = solids_of_faces();
        for (std::uint32_t f = 0; f < faces_.size(); ++f) {
            if (faces_[f] == 0) continue;
            const brep::Face& face = part_.faces[f];
            const Entity aspect = aspect_of(name_of(face), faces_[f], parts[solids[f]]);
            const std::array<std::string, 3> words{
                numbers_of(face, &mesh::Provenance::Entry::nc_line),
                numbers_of(face, &mesh::Provenance::Entry::tool), kind_of(face)};
            for (std::size_t i = 0; i < words.size(); ++i) {
                Attribute& a = attributes[i];
                Entity& value = a.values[words[i]];
                if (value == 0) {
                    const Entity item =
                        add("DESCRIPTIVE_REPRESENTATION_ITEM('" + a.name + "','" + words[i] + "')");
                    value = add("REPRESENTATION('" + a.name + "',(" + ref(item) + ")," +
                                ref(context_) + ")");
                }
                const Entity definition =
                    add("PROPERTY_DEFINITION('" + a.name + "',''," + ref(aspect) + ")");
                add("PROPERTY_DEFINITION_REPRESENTATION(" + ref(definition) + "," + ref(value) +
                    ")");
                add("GENERAL_PROPERTY_ASSOCIATION('user defined attribute',''," + ref(a.general) +
                    "," + ref(definition) + ")");
            }
        }
    }

    static std::string kind_of(const brep::Face& face) {
        if (face.is_facet) return "facet";
        return std::string(brep::kForms[face.surface.form.index()]);
    }

    // Returns the lines or tools of the face, ascending; empty for uncut stock.
    std::string numbers_of(const brep::Face& face,
                           std::uint32_t mesh::Provenance::Entry::*number) const {
        std::vector<std::uint32_t> numbers;
        for (const cda::Origin origin : face.origins) {
            const mesh::Provenance::Entry entry = provenance_.of(origin);
            if (entry.nc_line != 0 ||
                (!entry.is_stock() && number == &mesh::Provenance::Entry::tool))
                numbers.push_back(entry.*number);
        }
        std::sort(numbers.begin(), numbers.end());
        numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
        std::string text;
        for (const std::uint32_t n : numbers)
            text += (text.empty() ? "" : " ") + std::to_string(n);
        return text;
    }

    Entity face(std::uint32_t number) {
        const brep::Face& from = part_.faces[number];
        const bool is_flat = std::holds_alternative<brep::Plane>(from.surface.form);
        std::vector<Entity> bounds;
        for (const brep::Loop& loop : from.loops) {
            const Entity of = edge_loop(loop);
            const bool is_outline = bounds.empty() && is_flat;
            bounds.push_back(
                add((is_outline ? "FACE_OUTER_BOUND(''," : "FACE_BOUND('',") + ref(of) + ",.T.)"));
        }
        // A vertex loop marks a cone's apex that is inside the face. Without the loop, readers lose
        // the apex unless the only edge of the face is a circle.
        if (brep::has_tip(part_, from)) {
            const Entity tip = point(tip_of(from));
            const Entity corner = add("VERTEX_POINT(''," + ref(tip) + ")");
            const Entity loop = add("VERTEX_LOOP(''," + ref(corner) + ")");
            bounds.push_back(add("FACE_BOUND(''," + ref(loop) + ",.T.)"));
        }
        const Entity made =
            add("ADVANCED_FACE(" + quoted(name_of(from)) + "," + list(bounds) + "," +
                ref(surface(number).entity) + (from.surface.is_hollow ? ",.F.)" : ",.T.)"));
        const Entity look = style(provenance_.of(from.origin));
        faces_[number] = made;
        styled_.push_back(add("STYLED_ITEM('',(" + ref(look) + ")," + ref(made) + ")"));
        return made;
    }

    static Vec3 tip_of(const brep::Face& face) {
        if (const auto* cone = std::get_if<brep::Cone>(&face.surface.form)) return cone->apex;
        const auto& torus = std::get<brep::Torus>(face.surface.form);
        const double height =
            std::sqrt(std::max(0.0, torus.minor * torus.minor - torus.major * torus.major));
        return torus.centre - height * face.frame.axis;
    }

    struct Surface {
        Entity entity = 0;
        std::optional<brep::ParameterSurface> parameters;
    };
    // Returns the surface of a face.
    const Surface& surface(std::uint32_t number) {
        Surface& made = surfaces_[number];
        if (made.entity != 0) return made;
        const brep::Face& face = part_.faces[number];
        std::shared_ptr<const brep::Patch> patch;
        if (brep::is_spline_in_files(face.surface.form)) {
            patch = std::make_shared<brep::Patch>(brep::patch_of(part_, face));
            made.entity = patch_surface(*patch);
        } else {
            made.entity = std::visit([&](const auto& form) { return surface_of(form, face); },
                                     face.surface.form);
        }
        made.parameters = brep::ParameterSurface::of(part_, face, std::move(patch));
        return made;
    }

    std::string place_of(const brep::Frame& frame) {
        return ref(placement(frame.origin, frame.axis, frame.x));
    }

    // The origin of the plane is the first corner of the outline.
    Entity surface_of(const brep::Plane&, const brep::Face& face) {
        const brep::EdgeUse& use = face.loops.front().front();
        const brep::Edge& e = part_.edges[use.edge];
        const Entity corner = vertex(use.is_forward ? e.from : e.to).point;
        return add("PLANE(''," + ref(placement(corner, face.frame.axis, face.frame.x)) + ")");
    }
    Entity surface_of(const brep::Cylinder& form, const brep::Face& face) {
        return add("CYLINDRICAL_SURFACE(''," + place_of(face.frame) + "," + real(form.radius) +
                   ")");
    }
    Entity surface_of(const brep::Cone& form, const brep::Face& face) {
        const double height = dot(face.frame.origin - form.apex, form.axis);
        const double half = brep::half_angle_rad(form);
        return add("CONICAL_SURFACE(''," + place_of(face.frame) + "," + real(form.slope * height) +
                   "," + real(half) + ")");
    }
    Entity surface_of(const brep::Sphere& form, const brep::Face& face) {
        return add("SPHERICAL_SURFACE(''," + place_of(brep::frame_in_file(part_, face)) + "," +
                   real(form.radius) + ")");
    }
    Entity surface_of(const brep::Extrusion& form, const brep::Face& face) {
        const auto half = brep::half_of_ramp(part_, face);
        const Entity circle =
            half ? half_circle(form, *half)
                 : add("CIRCLE(''," + place_of(face.frame) + "," + real(form.radius) + ")");
        const Entity vector = add("VECTOR(''," + ref(direction(form.along)) + ",1.)");
        return add("SURFACE_OF_LINEAR_EXTRUSION(''," + ref(circle) + "," + ref(vector) + ")");
    }
    // Writes an exact half circle as a rational cubic.
    Entity half_circle(const brep::Extrusion& form, Vec3 middle) {
        const Vec3 end = form.radius * cross(form.axis, middle);
        const Vec3 out = (2.0 * form.radius) * middle;
        std::vector<Entity> points;
        for (const Vec3& p : {-end, out - end, out + end, end})
            points.push_back(point(form.centre + p));
        const std::string third = real(1.0 / 3.0);
        return add("(BOUNDED_CURVE()B_SPLINE_CURVE(3," + list(points) +
                   ",.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((4,4),(0.,1.),.UNSPECIFIED.)"
                   "CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.," +
                   third + "," + third + ",1.))REPRESENTATION_ITEM(''))");
    }
    template <typename Other>
    Entity surface_of(const Other&, const brep::Face&) {
        throw std::logic_error("the form is a patch, or no face lies on it");
    }
    Entity patch_surface(const brep::Patch& patch) {
        std::string rows;
        for (const auto& points : patch.net) {
            std::vector<Entity> row;
            row.reserve(points.size());
            for (const Vec3& p : points)
                row.push_back(point(p));
            rows += (rows.empty() ? "(" : ",") + list(row);
        }
        const Knots around(patch.around, patch.degree), along(patch.along, patch.degree);
        const std::string degree = std::to_string(patch.degree);
        return add("B_SPLINE_SURFACE_WITH_KNOTS(''," + degree + "," + degree + "," + rows +
                   "),.UNSPECIFIED.,.F.,.F.,.F.," + around.multiplicities + "," +
                   along.multiplicities + "," + around.places + "," + along.places +
                   ",.UNSPECIFIED.)");
    }
    Entity surface_of(const brep::Torus& form, const brep::Face& face) {
        if (brep::is_spindle(form)) return spindle(form, face.frame);
        return add("TOROIDAL_SURFACE(''," + place_of(face.frame) + "," + real(form.major) + "," +
                   real(form.minor) + ")");
    }

    // Writes a spindle torus, for which readers do not accept TOROIDAL_SURFACE, as a surface of
    // revolution: the arc of its circle from tip to tip, rotated about the axis. The circle begins
    // in the lower tip.
    Entity spindle(const brep::Torus& form, const brep::Frame& frame) {
        const Vec3 y = cross(frame.axis, frame.x);
        const double height =
            std::sqrt(std::max(0.0, form.minor * form.minor - form.major * form.major));
        const Vec3 down = (-1.0 / form.minor) * (form.major * frame.x + height * frame.axis);
        const brep::Frame place{frame.origin + form.major * frame.x, -y, down};
        const Entity circle = add("CIRCLE(''," + place_of(place) + "," + real(form.minor) + ")");
        const Entity from = point(frame.origin - height * frame.axis);
        // If both tips are one point, a circle trimmed there would be ambiguous.
        constexpr double kLeastApart = 1e-2, kMost = 175.0;
        const auto last = sin_cos(kMost);
        const Entity to =
            point(height > kLeastApart * form.minor
                      ? frame.origin + height * frame.axis
                      : frame.origin + (form.major + form.minor * last.cos) * frame.x +
                            form.minor * last.sin * frame.axis);
        const Entity half = add("TRIMMED_CURVE(''," + ref(circle) + ",(" + ref(from) + "),(" +
                                ref(to) + "),.T.,.CARTESIAN.)");
        const Entity axis = add("AXIS1_PLACEMENT(''," + ref(point(frame.origin)) + "," +
                                ref(direction(frame.axis)) + ")");
        return add("SURFACE_OF_REVOLUTION(''," + ref(half) + "," + ref(axis) + ")");
    }

    // Returns the style with the colour of the tool.
    Entity style(mesh::Provenance::Entry entry) {
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

    Entity shell(const brep::Shell& faces) {
        std::vector<Entity> made;
        for (const std::uint32_t f : faces)
            made.push_back(face(f));
        return add("CLOSED_SHELL(''," + list(made) + ")");
    }

    Entity solid_brep(const brep::Solid& solid, const std::string& name) {
        const Entity outside = shell(solid.outside);
        if (solid.voids.empty()) {
            return add("MANIFOLD_SOLID_BREP('" + name + "'," + ref(outside) + ")");
        }
        std::vector<Entity> voids;
        for (const auto& faces : solid.voids) {
            const Entity inside = shell(faces);
            voids.push_back(add("ORIENTED_CLOSED_SHELL('',*," + ref(inside) + ",.T.)"));
        }
        return add("BREP_WITH_VOIDS('" + name + "'," + ref(outside) + "," + list(voids) + ")");
    }

    void flush() {
        out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
        text_.clear();
    }

    std::ostream& out_;
    const brep::Part& part_;
    const mesh::Provenance& provenance_;
    StepOptions options_;
    Palette palette_;
    Entity last_ = 0;
    Entity length_ = 0, square_ = 0, cube_ = 0;  // units
    Entity context_ = 0;                         // of all geometry
    Entity product_context_ = 0, design_context_ = 0;
    std::string text_;
    std::vector<Vertex> vertices_;
    std::vector<Entity> edges_;                           // by edge; 0: not written
    std::unordered_map<std::string, Entity> directions_;  // by their text
    std::vector<Entity> styles_;                          // by rank of the tool; 0: not written
    std::vector<Entity> styled_;
    std::vector<Entity> faces_;      // by face; 0: not written
    std::vector<Surface> surfaces_;  // by face; entity 0: not written
    static constexpr std::uint32_t kNoFace = ~std::uint32_t{0};
    std::vector<std::array<std::uint32_t, 2>> faces_of_edge_;  // that uses it forward, backward
    Entity flat_context_ = 0;                                  // of curves in parameters
};

}  // namespace

void write_step_solid(std::ostream& out, const brep::Part& part, const mesh::Provenance& provenance,
                      const StepOptions& options) {
    if (part.faces.size() > options.max_faces) {
        throw std::runtime_error("the part has " + std::to_string(part.faces.size()) +
                                 " faces, more than the " + std::to_string(options.max_faces) +
                                 " that a STEP file is to have (--step-max-faces, --simplify)");
    }
    if (!brep::has_long_windings(part)) {
        StepWriter(out, part, provenance, options).write();
        return;
    }
    brep::Part divided = part;
    brep::split_long_windings(divided);
    StepWriter(out, divided, provenance, options).write();
}

brep::FlatPart flat_solid(const cda::Boundary& boundary, double tolerance_mm) {
    return brep::flat_part([&](double times) {
        const double tolerance =
            times == 1.0 ? tolerance_mm : times * std::max(tolerance_mm, kStepTolerance);
        mesh::Simplified part = mesh::simplify(boundary, tolerance);
        return brep::Facets{std::move(part.boundary), std::move(part.origins)};
    });
}

void write_step(std::ostream& out, const cda::Boundary& boundary,
                const mesh::Provenance& provenance, const StepOptions& options) {
    const brep::FlatPart flat = flat_solid(boundary, options.tolerance_mm);
    if (!flat.is_sound) throw std::runtime_error(kUnsoundSolid);
    write_step_solid(out, flat.part, provenance, options);
}

}  // namespace ncsim::exporter
