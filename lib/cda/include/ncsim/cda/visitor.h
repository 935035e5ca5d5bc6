// SPDX-License-Identifier: GPL-3.0-or-later
//
// Visitors of the flat CDA, thesis 6.3 (CDA::CVisitor). Rendering, statistics and XML are visitors.
#pragma once

#include <cstdint>

namespace ncsim::cda {

class FlatCda;
struct CdaCell;
struct Contact;
struct FacetRef;

/// Base class of visitors of a FlatCda.
class CdaVisitor {
public:
    virtual ~CdaVisitor() = default;
    /// Called first.
    virtual void visit_cda(const FlatCda& cda) = 0;
    /// Called for the positive cell, then the negative cells, then the zero cells, each before the
    /// cell's facets.
    virtual void visit_cell(const CdaCell& cell, std::uint32_t index) = 0;
    virtual void visit_facet(const CdaCell& cell, const FacetRef& facet) = 0;
    virtual void visit_contact(const Contact& contact, std::uint32_t index) = 0;
    /// Called last.
    virtual void end_cda(const FlatCda& cda) = 0;
};

}  // namespace ncsim::cda
