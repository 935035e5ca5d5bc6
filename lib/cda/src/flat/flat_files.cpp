// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics and XML output of the flat aggregate.
#include "ncsim/base/number_text.h"
#include "ncsim/cda/flat.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string_view>
#include <vector>

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

template <class First, class... Rest>
void write_row(std::ostream& out, First first, Rest... rest) {
    out << shortest(first);
    ((out << ',' << shortest(rest)), ...);
    out << '\n';
}

class XmlWriter {
public:
    XmlWriter(std::ostream& out, const Lattice& lattice) : out_(out), lattice_(lattice) {}

    void write_cell(const CdaCell& cell, std::size_t index) {
        out_ << "  <cell kind=\"" << name(cell.kind) << "\" index=\"" << shortest(index)
             << "\" origin=\"" << shortest(static_cast<std::uint32_t>(cell.origin)) << "\">\n";
        for (const ExactPoint& vertex : cell.body.vertices())
            write_vertex(vertex);
        for (std::size_t i = 0; i < cell.body.facets().size(); ++i)
            write_facet(cell, i);
        out_ << "  </cell>\n";
    }

    void write_contact(const Contact& contact, std::size_t index) {
        out_ << "  <contact index=\"" << shortest(index) << "\">\n    ";
        write_plane(contact.polygon.plane);
        for (const ExactPoint& corner : contact.polygon.corners)
            write_vertex(corner);
        write_binding("up", contact.first);
        write_binding("up", contact.second);
        out_ << "  </contact>\n";
    }

private:
    void write_facet(const CdaCell& cell, std::size_t index) {
        const auto& facet = cell.body.facets()[index];
        out_ << "    <facet index=\"" << shortest(index) << "\">\n      ";
        write_plane(facet.plane);
        out_ << "      <vertices>";
        for (std::size_t i = 0; i < facet.vertices.size(); ++i)
            out_ << (i > 0 ? " " : "") << shortest(facet.vertices[i]);
        out_ << "</vertices>\n";
        const FacetBinding& binding = cell.bindings[index];
        if (binding.up) write_binding("up", *binding.up);
        for (const FacetRef& down : binding.down)
            write_binding("down", down);
        out_ << "    </facet>\n";
    }
    void write_vertex(const ExactPoint& vertex) {
        const Vec3 mm = lattice_.to_mm(vertex.approx);
        out_ << "    <vertex x=\"" << shortest(mm.x) << "\" y=\"" << shortest(mm.y) << "\" z=\""
             << shortest(mm.z) << "\"/>\n";
    }
    void write_plane(const Plane& plane) {
        out_ << "<plane nx=\"" << shortest(plane.nx) << "\" ny=\"" << shortest(plane.ny)
             << "\" nz=\"" << shortest(plane.nz) << "\" d=\"" << shortest(plane.d) << "\"/>\n";
    }
    void write_binding(std::string_view way, const FacetRef& facet) {
        out_ << "      <" << way << " kind=\"" << name(facet.kind) << "\" cell=\""
             << shortest(facet.cell) << "\" facet=\"" << shortest(facet.facet) << "\"/>\n";
    }

    std::ostream& out_;
    const Lattice& lattice_;
};

}  // namespace

void FlatCda::write_statistics(std::ostream& out) const {
    out << "negative_cell,origin,lp_negative_ms,hull_negative_ms,lp_zero_ms,hull_zero_ms,"
           "stencilled_negative_facets,visible_negative_facets,zero_facets,new_zero_cells,"
           "zero_cells_per_negative_cell,new_contacts,intersections,exact_fallbacks,removed_mm3\n";
    std::uint64_t zero_cells = 0;
    std::uint32_t row = 0;
    for (const StepStatistics& step : steps_) {
        zero_cells += step.new_zero_cells;
        ++row;
        write_row(out, row, static_cast<std::uint32_t>(step.origin),
                  1e3 * step.negative.linear_programming_seconds,
                  1e3 * step.negative.convex_hull_seconds,
                  1e3 * step.zero.linear_programming_seconds, 1e3 * step.zero.convex_hull_seconds,
                  step.stencilled_negative_facets, step.visible_negative_facets, step.zero_facets,
                  step.new_zero_cells, static_cast<double>(zero_cells) / static_cast<double>(row),
                  step.new_contacts, step.negative.intersections + step.zero.intersections,
                  step.negative.exact_fallbacks + step.zero.exact_fallbacks, step.removed_volume);
    }
}

void FlatCda::write_cells(std::ostream& out) const {
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<cda unit_mm=\""
        << shortest(lattice_.unit_mm) << "\">\n";
    XmlWriter writer(out, lattice_);
    writer.write_cell(positive_, 0);
    for (const std::vector<CdaCell>* cells : {&negative_, &zero_}) {
        for (std::size_t i = 0; i < cells->size(); ++i)
            writer.write_cell((*cells)[i], i);
    }
    for (std::size_t i = 0; i < contacts_.size(); ++i)
        writer.write_contact(contacts_[i], i);
    out << "</cda>\n";
}

}  // namespace ncsim::cda
