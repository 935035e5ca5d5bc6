// SPDX-License-Identifier: GPL-3.0-or-later
//
// A STEP file is a list of numbered entities, written in an order in which each entity refers only
// to earlier entities: units and product, then the faces of each shell, before each face the edges
// that no earlier face uses, and before each edge its curve and vertices.
#include "ncsim/export/step.h"

#include "ncsim/brep/long_windings.h"
#include "ncsim/cda/shape.h"
#include "ncsim/mesh/simplify.h"

#include "formats/step_geometry.h"
#include "render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::exporter {

namespace {

// Smallest uncertainty in a file, in mm: readers identify points that are nearer. The value is
// above the rounding of coordinates and below the lattice on which parts are cut.
constexpr const char* kUncertainty = "1.E-06";
constexpr double kUncertaintyMm = 1e-6;
// Largest number of lines in the name of a face.
constexpr std::size_t kNamedLines = 8;

// Returns the uncertainty of the file: a little more than the largest distance of an edge from its
// surfaces, at least kUncertaintyMm. Readers drop the parameter curves of edges that are off by
// more, and project these edges themselves.
StepValue uncertainty_of(const brep::Part& part) {
    constexpr double kMargin = 1.01;
    return part.miss_mm > kUncertaintyMm ? StepValue(kMargin * part.miss_mm) : kUncertainty;
}

class StepWriter : private StepGeometry {
public:
    StepWriter(std::ostream& out, const brep::Part& part, const mesh::Provenance& provenance,
               const StepOptions& options)
        : StepGeometry(out, part),
          part_(part),
          provenance_(provenance),
          options_(options),
          palette_(provenance),
          styles_(palette_.face_sources().size()),
          faces_(part.faces.size()) {}

    void write() {
        header();
        context_ = units();
        products();
        const Product whole =
            product(step_string(provenance_.program.empty() ? "part" : provenance_.program));
        const Entity origin = origin_placement();
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
            add("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',{},{})",
                {styled_, context_});
        }
        validate(whole, parts);
        if (options_.has_attributes) attribute(parts);
        add_text("ENDSEC;\nEND-ISO-10303-21;\n");
        finish();
    }

private:
    void header() {
        add_text(
            "ISO-10303-21;\nHEADER;\n"
            "FILE_DESCRIPTION(('part milled by an NC program'" +
            (provenance_.assumed.empty()
                 ? std::string()
                 : "," + step_string(std::string(cda::kAssumedMark) + provenance_.assumed)) +
            "),'2;1');\n"
            "FILE_NAME(" +
            step_string(provenance_.program) +
            ",'1970-01-01T00:00:00',(''),(''),'ncsim','ncsim','');\n"
            "FILE_SCHEMA(('" +
            (is_242() ? "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF"
                        " { 1 0 10303 442 1 1 4 }"
                      : "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }") +
            "'));\nENDSEC;\nDATA;\n");
    }

    bool is_242() const { return options_.schema == StepSchema::Ap242; }

    // Writes the units (mm, radians) and the context of all geometry. Returns the context.
    Entity units() {
        length_ = add("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))");
        const Entity angle = add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))");
        const Entity solid = add("(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT())");
        const Entity uncertainty =
            add("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({}),{},'distance_accuracy_value','')",
                {uncertainty_of(part_), length_});
        return add(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({})) "
            "GLOBAL_UNIT_ASSIGNED_CONTEXT(({},{},{})) REPRESENTATION_CONTEXT('',''))",
            {uncertainty, length_, angle, solid});
    }

    struct Product {
        Entity definition, shape;  // shape: the definition of the shape
        Entity representation;
        Entity place;  // in the representation, for an assembly
    };

    // Writes the contexts of all products.
    void products() {
        const Entity application = add("APPLICATION_CONTEXT('{}')",
                                       {is_242() ? "managed model based 3d engineering"
                                                 : "core data for automotive mechanical design "
                                                   "processes"});
        add("APPLICATION_PROTOCOL_DEFINITION('international standard',{},{})",
            {is_242() ? "'ap242_managed_model_based_3d_engineering',2014"
                      : "'automotive_design',2000",
             application});
        product_context_ = add("PRODUCT_CONTEXT('',{},'mechanical')", {application});
        design_context_ =
            add("PRODUCT_DEFINITION_CONTEXT('part definition',{},'design')", {application});
    }

    // Writes a product without a representation of its shape. `name` is quoted.
    Product product(const std::string& name) {
        const Entity made = add("PRODUCT({},{},'',({}))", {name, name, product_context_});
        add("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({}))", {made});
        const Entity formation = add("PRODUCT_DEFINITION_FORMATION('','',{})", {made});
        const Entity definition =
            add("PRODUCT_DEFINITION('design','',{},{})", {formation, design_context_});
        return {definition, add("PRODUCT_DEFINITION_SHAPE('','',{})", {definition}), {}, {}};
    }

    // Writes the representation of the shape of `product`: a placement, and solids or further
    // placements. Returns the product with its representation.
    Product represented(Product product, const std::vector<Entity>& items, bool has_solids = true) {
        product.representation = add(
            "{}('',{},{})", {has_solids && items.size() > 1 ? "ADVANCED_BREP_SHAPE_REPRESENTATION"
                                                            : "SHAPE_REPRESENTATION",
                             items, context_});
        add("SHAPE_DEFINITION_REPRESENTATION({},{})", {product.shape, product.representation});
        return product;
    }

    Entity origin_placement() { return placement(Vec3{0, 0, 0}, {0, 0, 1}, {1, 0, 0}); }

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
            const Entity place = origin_placement();
            parts.push_back(represented(product(step_string(name)), {place, solid}));
            parts.back().place = place;
            places.push_back(origin_placement());
        }
        const Product all = represented(whole, places, false);
        for (std::size_t i = 0; i < parts.size(); ++i)
            place_part(all, parts[i], step_string(name_of_solid(i)), places[i + 1]);
        return parts;
    }

    // Writes the use of `part` in the assembly `whole`, at the placement `place` there.
    void place_part(const Product& whole, const Product& part, const std::string& name,
                    Entity place) {
        const Entity use = add("NEXT_ASSEMBLY_USAGE_OCCURRENCE({},{},'',{},{},$)",
                               {name, name, whole.definition, part.definition});
        const Entity shape = add("PRODUCT_DEFINITION_SHAPE('','',{})", {use});
        const Entity same = add("ITEM_DEFINED_TRANSFORMATION('','',{},{})", {part.place, place});
        const Entity relation =
            add("(REPRESENTATION_RELATIONSHIP('','',{},{})REPRESENTATION_RELATIONSHIP_WITH_"
                "TRANSFORMATION({})SHAPE_REPRESENTATION_RELATIONSHIP())",
                {part.representation, whole.representation, same});
        add("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({},{})", {relation, shape});
    }

    Entity edge_loop(const brep::Loop& loop) {
        std::vector<Entity> oriented;
        for (const brep::EdgeUse& use : loop) {
            std::vector<Entity> edges = edges_of(use.edge);
            if (!use.is_forward) std::ranges::reverse(edges);
            for (const Entity of : edges)
                oriented.push_back(
                    add("ORIENTED_EDGE('',*,*,{},{})", {of, use.is_forward ? ".T." : ".F."}));
        }
        return add("EDGE_LOOP('',{})", {oriented});
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

    Entity power_of_length(double power) {
        const Entity element = add("DERIVED_UNIT_ELEMENT({},{})", {length_, power});
        return add("DERIVED_UNIT(({}))", {element});
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
        const auto property = [&](const char* name, Entity item) {
            const Entity definition =
                add("PROPERTY_DEFINITION('geometric validation property','{}',{})", {name, of});
            const Entity value = add("REPRESENTATION('{}',({}),{})", {name, item, context_});
            add("PROPERTY_DEFINITION_REPRESENTATION({},{})", {definition, value});
        };
        const auto measure = [&](const char* form, double value, Entity unit) {
            return add(form, {value, unit});
        };
        property("volume",
                 measure("MEASURE_REPRESENTATION_ITEM('volume measure',VOLUME_MEASURE({}),{})",
                         mass.volume, cube_));
        property("surface area",
                 measure("MEASURE_REPRESENTATION_ITEM('surface area measure',AREA_MEASURE({}),{})",
                         mass.area, square_));
        property("centroid", add("CARTESIAN_POINT('centre point',{})", {mass.centroid}));
    }

    // Writes a shape aspect of a face of `product` that can carry properties. Returns the aspect.
    Entity aspect_of(const std::string& name, Entity face, const Product& product) {
        const Entity aspect = add("SHAPE_ASPECT('{}','',{},.T.)", {name, product.shape});
        if (is_242()) {
            add("GEOMETRIC_ITEM_SPECIFIC_USAGE('','',{},{},{})",
                {aspect, product.representation, face});
        } else {
            const Entity definition =
                add("PROPERTY_DEFINITION('shape with specific properties','',{})", {aspect});
            const Entity only = add("SHAPE_REPRESENTATION('',({}),{})", {face, context_});
            add("SHAPE_DEFINITION_REPRESENTATION({},{})", {definition, only});
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
            Entity general{};
            std::unordered_map<std::string, Entity> values{};  // equal values share an entity
        };
        std::array<Attribute, 3> attributes{{{"nc_lines"}, {"tools"}, {"kind"}}};
        for (Attribute& a : attributes)
            a.general = add("GENERAL_PROPERTY('','{}','')", {a.name});
        const std::vector<std::size_t> solids = solids_of_faces();
        for (std::uint32_t f = 0; f < faces_.size(); ++f) {
            if (!faces_[f]) continue;
            const brep::Face& face = part_.faces[f];
            const Entity aspect = aspect_of(name_of(face), faces_[f], parts[solids[f]]);
            const std::array<std::string, 3> words{
                numbers_of(face, &mesh::Provenance::Entry::nc_line),
                numbers_of(face, &mesh::Provenance::Entry::tool), kind_of(face)};
            for (std::size_t i = 0; i < words.size(); ++i) {
                Attribute& a = attributes[i];
                Entity& value = a.values[words[i]];
                if (!value) {
                    const Entity item =
                        add("DESCRIPTIVE_REPRESENTATION_ITEM('{}','{}')", {a.name, words[i]});
                    value = add("REPRESENTATION('{}',({}),{})", {a.name, item, context_});
                }
                const Entity definition = add("PROPERTY_DEFINITION('{}','',{})", {a.name, aspect});
                add("PROPERTY_DEFINITION_REPRESENTATION({},{})", {definition, value});
                add("GENERAL_PROPERTY_ASSOCIATION('user defined attribute','',{},{})",
                    {a.general, definition});
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

    // --- Faces ------------------------------------------------------------------------------

    Entity face(std::uint32_t number) {
        const brep::Face& from = part_.faces[number];
        const bool is_flat = std::holds_alternative<brep::Plane>(from.surface.form);
        std::vector<Entity> bounds;
        for (const brep::Loop& loop : from.loops) {
            const Entity of = edge_loop(loop);
            const bool is_outline = bounds.empty() && is_flat;
            bounds.push_back(
                add("{}('',{},.T.)", {is_outline ? "FACE_OUTER_BOUND" : "FACE_BOUND", of}));
        }
        // A vertex loop marks a cone's apex that is inside the face. Without the loop, readers lose
        // the apex unless the only edge of the face is a circle.
        if (brep::has_tip(part_, from)) {
            const Entity tip = point(tip_of(from));
            const Entity corner = add("VERTEX_POINT('',{})", {tip});
            const Entity loop = add("VERTEX_LOOP('',{})", {corner});
            bounds.push_back(add("FACE_BOUND('',{},.T.)", {loop}));
        }
        const Entity made =
            add("ADVANCED_FACE({},{},{},{})", {step_string(name_of(from)), bounds, surface(number),
                                               from.surface.is_hollow ? ".F." : ".T."});
        const Entity look = style(provenance_.of(from.origin));
        faces_[number] = made;
        styled_.push_back(add("STYLED_ITEM('',({}),{})", {look, made}));
        return made;
    }

    static Vec3 tip_of(const brep::Face& face) {
        if (const auto* cone = std::get_if<brep::Cone>(&face.surface.form)) return cone->apex;
        const auto& torus = std::get<brep::Torus>(face.surface.form);
        const double height =
            std::sqrt(std::max(0.0, torus.minor * torus.minor - torus.major * torus.major));
        return torus.centre - height * face.frame.axis;
    }

    // Returns the style with the colour of the tool.
    Entity style(mesh::Provenance::Entry entry) {
        Entity& made = styles_[palette_.rank(entry)];
        if (made) return made;
        const Rgba8 colour = palette_.colour(entry);
        const Entity of = add("COLOUR_RGB('',{},{},{})",
                              {unit_share(colour.r), unit_share(colour.g), unit_share(colour.b)});
        const Entity fill = add("FILL_AREA_STYLE_COLOUR('',{})", {of});
        const Entity area = add("FILL_AREA_STYLE('',({}))", {fill});
        const Entity surface = add("SURFACE_STYLE_FILL_AREA({})", {area});
        const Entity side = add("SURFACE_SIDE_STYLE('',({}))", {surface});
        const Entity usage = add("SURFACE_STYLE_USAGE(.BOTH.,{})", {side});
        made = add("PRESENTATION_STYLE_ASSIGNMENT(({}))", {usage});
        return made;
    }

    Entity shell(const brep::Shell& faces) {
        std::vector<Entity> made;
        for (const std::uint32_t f : faces)
            made.push_back(face(f));
        return add("CLOSED_SHELL('',{})", {made});
    }

    Entity solid_brep(const brep::Solid& solid, const std::string& name) {
        const Entity outside = shell(solid.outside);
        if (solid.voids.empty()) return add("MANIFOLD_SOLID_BREP('{}',{})", {name, outside});
        std::vector<Entity> voids;
        for (const auto& faces : solid.voids) {
            const Entity inside = shell(faces);
            voids.push_back(add("ORIENTED_CLOSED_SHELL('',*,{},.T.)", {inside}));
        }
        return add("BREP_WITH_VOIDS('{}',{},{})", {name, outside, voids});
    }

    const brep::Part& part_;
    const mesh::Provenance& provenance_;
    StepOptions options_;
    Palette palette_;
    Entity length_, square_, cube_;  // units
    Entity context_;                 // of all geometry
    Entity product_context_, design_context_;
    std::vector<Entity> styles_;  // by rank of the tool
    std::vector<Entity> styled_;
    std::vector<Entity> faces_;
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
