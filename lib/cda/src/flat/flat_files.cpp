// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics and XML output of the flat aggregate, as visitors.
#include "ncsim/cda/flat.h"

#include <array>
#include <charconv>
#include <ostream>
#include <string_view>

namespace ncsim::cda {

namespace {

// Writes the shortest text that reads back as the same number, in any locale.
template <class T>
void write_number(std::ostream& out, T value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    out.write(text.data(), end - text.data());
}

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
        write_number(out_, first);
        ((out_ << ',', write_number(out_, rest)), ...);
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
        write_number(out_, lattice_.unit_mm);
        out_ << "\">\n";
    }

    void visit_cell(const CdaCell& cell, std::uint32_t index) override {
        close_cell();
        out_ << "  <cell kind=\"" << name(cell.kind) << "\" index=\"";
        write_number(out_, index);
        out_ << "\" origin=\"";
        write_number(out_, static_cast<std::uint32_t>(cell.origin));
        out_ << "\">\n";
        for (const ExactPoint& vertex : cell.body.vertices())
            write_vertex("    ", vertex);
        is_open_ = true;
    }

    void visit_facet(const CdaCell& cell, const FacetRef& ref) override {
        const auto& facet = cell.body.facets()[ref.facet];
        out_ << "    <facet index=\"";
        write_number(out_, ref.facet);
        out_ << "\">\n      ";
        write_plane(facet.plane);
        out_ << "      <vertices>";
        for (std::size_t i = 0; i < facet.vertices.size(); ++i) {
            if (i > 0) out_ << ' ';
            write_number(out_, facet.vertices[i]);
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
        write_number(out_, index);
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
        write_number(out_, mm.x);
        out_ << "\" y=\"";
        write_number(out_, mm.y);
        out_ << "\" z=\"";
        write_number(out_, mm.z);
        out_ << "\"/>\n";
    }
    void write_plane(const Plane& plane) {
        out_ << "<plane nx=\"";
        write_number(out_, plane.nx);
        out_ << "\" ny=\"";
        write_number(out_, plane.ny);
        out_ << "\" nz=\"";
        write_number(out_, plane.nz);
        out_ << "\" d=\"";
        write_number(out_, plane.d);
        out_ << "\"/>\n";
    }
    void write_binding(std::string_view way, const FacetRef& facet) {
        out_ << "      <" << way << " kind=\"" << name(facet.kind) << "\" cell=\"";
        write_number(out_, facet.cell);
        out_ << "\" facet=\"";
        write_number(out_, facet.facet);
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
