// SPDX-License-Identifier: GPL-3.0-or-later
//
// Report at the end of a run, as text and as JSON.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/report/cutting_facts.h"
#include "ncsim/report/design_facts.h"
#include "ncsim/simulation/facts.h"
#include "ncsim/verify/ledger.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::report {

/// Result of simplify().
struct SimplifiedFacts {
    double tolerance_mm = 0.0, deviation_mm = 0.0;
    std::size_t faces = 0;
};

/// STEP file with true surfaces.
struct SolidFacts {
    std::size_t faces = 0;
    double volume_mm3 = 0.0;  ///< Volume inside the true surfaces.
    /// Number of faces of each kind, in the order of the list: "plane", "cylinder" …
    std::vector<std::pair<std::string, std::size_t>> kinds{};
    double miss_mm = 0.0;  ///< Largest distance of an edge from its surfaces.
    /// Facets of round tools that were not recognised, and of the mesh of the stock; included in
    /// the planes.
    std::size_t facets_kept = 0;
    std::size_t stock_facets = 0;  ///< Facets of the mesh of the stock among `facets_kept`.
    /// Largest distance of an edge of these facets from the adjacent faces.
    double facet_miss_mm = 0.0;
    std::vector<std::uint32_t> facet_lines{};  ///< Lines that cut these facets, ascending.
    /// Tolerances of a separate cut for the STEP file, if any.
    struct Cut {
        double tools_mm = 0.0, arcs_mm = 0.0;
    };
    std::optional<Cut> own_cut{};
    /// Largest height of the lunes omitted at path corners of ball end mills; 0: none.
    double mitred_mm = 0.0;
    /// Factor on the tolerance for shells of facets alone (FlatPart::tolerance_factor).
    double tolerance_factor = 1.0;
    double polyhedron_mm3 = 0.0;  ///< Volume of the polyhedron.
    /// Numbers of further cuts that were made, and that the budget did not allow.
    int cuts = 0, cuts_not_tried = 0;
    bool has_ended_early = false;  ///< True if the budget ended corrections of the surfaces.
};

/// Section of the part.
struct SectionFacts {
    std::string plane;  ///< "z=-4"
    std::size_t outlines = 0;
    /// Numbers of lines, arcs, ellipses, and curves given as chords.
    std::array<std::size_t, 4> curves{};
    std::size_t facets = 0;   ///< Lines of round tools that were not recognised.
    bool is_faceted = false;  ///< True if all lines are those of facets.
    double area_mm2 = 0.0, length_mm = 0.0;
    double moved_mm = 0.0;  ///< Shift to the right on the drawing.
};

/// Facts at the end of a run.
/// Requires: the pointers stay valid.
struct RunFacts {
    std::string name;  ///< Name of the program.
    const simulation::ProgramFacts* program = nullptr;
    CuttingFacts cutting;
    const simulation::PartFacts* part = nullptr;  ///< Null: the program could not be simulated.
    const cda::Boundary* boundary = nullptr;      ///< Null: not requested.
    std::optional<SimplifiedFacts> simplified;
    std::optional<SolidFacts> solid;
    std::vector<SectionFacts> sections{};
    std::optional<DesignFacts> design{};       ///< Comparison with a design, if requested.
    std::vector<DesignPlace> design_places{};  ///< The largest, largest first.
    /// Times on the machine of --machine; null: no machine, or only a part of the program was run.
    const verify::Ledger* on_machine = nullptr;
};

/// Returns a few lines of text.
std::string summary(const RunFacts& run);

/// Writes JSON, UTF-8. The bytes depend on the input and the options only, not on time or date.
/// Lengths are in mm, volumes in mm³; lines count from 1. Keys are only added.
void write_report(std::ostream& out, const RunFacts& run);

}  // namespace ncsim::report
