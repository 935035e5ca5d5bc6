// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics and XML output of the flat aggregate, as visitors.
#include "ncsim/base/number_text.h"
#include "ncsim/cda/flat.h"

#include <ostream>
#include <string_view>

namespace ncsim::cda {

namespace {

std::string_view name(CellKind kind) {
    switch (kind) {
        case CellKind::Positive: return "positive";
        case CellKind::Negative: return "negative";
        case CellKind::Zero: return "zero";
        case CellKind::Contact: return "contact";
    }
    return "";
}

class StatisticsVisitor final : public CdaVisitor {
public:
    explicit StatisticsVisitor(std::ostream& out) : out_(out) {}

    void visit_cda(const FlatCda& cda) override {
        out_ << "negative_cell,origin,lp_negative_ms,hull_negative_ms,lp_zero_ms,hull_zero_ms,"
                "stencilled_negative_facets,visible_negative_facets,zero_facets,new_zero_cells,"
                "zero_cells_per_negative_cell,new_contacts,intersections,exact_fallbacks,"
                "removed_mm3\n";
        std::uint64_t zero_cells = 0;
        std::uint32_t row = 0;
        for (const StepStatistics& step : cda.steps()) {
            zero_cells += step.new_zero_cells;
            ++row;
            write_row(
                row, static_cast<std::uint32_t>(step.origin),
                1e3 * step.negative.linear_programming_seconds,
                1e3 * step.negative.convex_hull_seconds, 1e3 * step.zero.linear_programming_seconds,
                1e3 * step.zero.convex_hull_seconds, step.stencilled_negative_facets,
                step.visible_negative_facets, step.zero_facets, step.new_zero_cells,
                static_cast<double>(zero_cells) / static_cast<double>(row), step.new_contacts,
                step.negative.intersections + step.zero.intersections,
                step.negative.exact_fallbacks + step.zero.exact_fallbacks, step.removed_volume);
        }
    }
    void visit_cell(const CdaCell&, std::uint32_t) override {}
    void visit_facet(const CdaCell&, const FacetRef&) override {}
    void visit_contact(const Contact&, std::uint32_t) override {}
    void end_cda(const FlatCda&) override {}

private:
    template <class First, class... Rest>
    void write_row(First first, Rest... rest) {
        out_ << shortest(first);
        ((out_ << ',' << shortest(rest)), ...);
        out_ << '\n';
    }
    std::ostream& out_;
};

class XmlVisitor final : public CdaVisitor {
public:
    explicit XmlVisitor(std::ostream& out) : out_(out) {}

    void visit_cda(const FlatCda& cda) override {
        lattice_ = cda.lattice();
        out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<cda unit_mm=\"";
        out_ << shortest(lattice_.unit_mm);
        out_ << "\">\n";
    }

    void visit_cell(const CdaCell& cell, std::uint32_t index) override {
        close_cell();
        out_ << "  <cell kind=\"" << name(cell.kind) << "\" index=\"";
        out_ << shortest(index);
        out_ << "\" origin=\"";
        out_ << shortest(static_cast<std::uint32_t>(cell.origin));
        out_ << "\">\n";
        for (const ExactPoint& vertex : cell.body.vertices())
            write_vertex("    ", vertex);
        is_open_ = true;
    }

    void visit_facet(const CdaCell& cell, const FacetRef& ref) override {
        const auto& facet = cell.body.facets()[ref.facet];
        out_ << "    <facet index=\"";
        out_ << shortest(ref.facet);
        out_ << "\">\n      ";
        write_plane(facet.plane);
        out_ << "      <vertices>";
        for (std::size_t i = 0; i < facet.vertices.size(); ++i) {
            if (i > 0) out_ << ' ';
            out_ << shortest(facet.vertices[i]);
        }
        out_ << "</vertices>\n";
        const FacetBinding& binding = cell.bindings[ref.facet];
        if (binding.up) write_binding("up", *binding.up);
        for (const FacetRef& down : binding.down)
            write_binding("down", down);
        out_ << "    </facet>\n";
    }

    void visit_contact(const Contact& contact, std::uint32_t index) override {
        close_cell();
        out_ << "  <contact index=\"";
        out_ << shortest(index);
        out_ << "\">\n    ";
        write_plane(contact.polygon.plane);
        for (const ExactPoint& corner : contact.polygon.corners)
            write_vertex("    ", corner);
        write_binding("up", contact.first);
        write_binding("up", contact.second);
        out_ << "  </contact>\n";
    }

    void end_cda(const FlatCda&) override {
        close_cell();
        out_ << "</cda>\n";
    }

private:
    void close_cell() {
        if (is_open_) out_ << "  </cell>\n";
        is_open_ = false;
    }
    void write_vertex(std::string_view indent, const ExactPoint& vertex) {
        const Vec3 mm = lattice_.to_mm(vertex.approx);
        out_ << indent << "<vertex x=\"";
        out_ << shortest(mm.x);
        out_ << "\" y=\"";
        out_ << shortest(mm.y);
        out_ << "\" z=\"";
        out_ << shortest(mm.z);
        out_ << "\"/>\n";
    }
    void write_plane(const Plane& plane) {
        out_ << "<plane nx=\"";
        out_ << shortest(plane.nx);
        out_ << "\" ny=\"";
        out_ << shortest(plane.ny);
        out_ << "\" nz=\"";
        out_ << shortest(plane.nz);
        out_ << "\" d=\"";
        out_ << shortest(plane.d);
        out_ << "\"/>\n";
    }
    void write_binding(std::string_view way, const FacetRef& facet) {
        out_ << "      <" << way << " kind=\"" << name(facet.kind) << "\" cell=\"";
        out_ << shortest(facet.cell);
        out_ << "\" facet=\"";
        out_ << shortest(facet.facet);
        out_ << "\"/>\n";
    }

    std::ostream& out_;
    Lattice lattice_;
    bool is_open_ = false;
};

}  // namespace

void FlatCda::write_statistics(std::ostream& out) const {
    StatisticsVisitor visitor(out);
    accept(visitor);
}

void FlatCda::write_cells(std::ostream& out) const {
    XmlVisitor visitor(out);
    accept(visitor);
}

}  // namespace ncsim::cda
