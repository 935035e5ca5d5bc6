// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said at the end of a run: for people as text, for programs as JSON.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/report/facts.h"
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

/// A mesh with fewer faces.
struct SimplifiedFacts {
    double tolerance_mm = 0.0, deviation_mm = 0.0;
    std::size_t faces = 0;
};

/// What STEP was written with true surfaces.
struct SolidFacts {
    std::size_t faces = 0;
    double volume_mm3 = 0.0;  ///< Of the true surfaces.
    /// Of each kind, as many as there are, in the order of the list: "plane", "cylinder" …
    std::vector<std::pair<std::string, std::size_t>> kinds{};
    double miss_mm = 0.0;         ///< Of edges from surfaces, at most.
    std::size_t facets_kept = 0;  ///< Among the planes: of round tools, not recognised.
    double facet_miss_mm = 0.0;   ///< Of edges of theirs, from the faces beside them.
    std::vector<std::uint32_t> facet_lines{};  ///< Lines that cut those, ascending.
    /// Tolerances of a cut made for it alone, if any.
    struct Cut {
        double tools_mm = 0.0, arcs_mm = 0.0;
    };
    std::optional<Cut> own_cut{};
    double mitred_mm = 0.0;  ///< Left out at bends of balls, at most; 0: nothing.
    /// Facets alone were joined within so many times the tolerance.
    double coarser = 1.0;
};

/// The part cut open.
struct SectionFacts {
    std::string plane;  ///< "z=-4"
    std::size_t outlines = 0;
    std::array<std::size_t, 4> curves{};  ///< Lines, arcs, ellipses, and curves that are chords.
    std::size_t facets = 0;               ///< Among the lines: of round tools, not recognised.
    bool is_faceted = false;              ///< All of it is of facets.
    double area_mm2 = 0.0, length_mm = 0.0;
    double moved_mm = 0.0;  ///< To the right on the drawing.
};

/// What is known at the end of a run. What is pointed to must outlive it.
struct RunFacts {
    std::string name;  ///< Of the program.
    const ProgramFacts* program = nullptr;
    CuttingFacts cutting;
    const PartFacts* part = nullptr;          ///< Null: it could not be simulated.
    const cda::Boundary* boundary = nullptr;  ///< Null: nobody asked for it.
    std::optional<SimplifiedFacts> simplified;
    std::optional<SolidFacts> solid;
    std::vector<SectionFacts> sections{};
    /// Times on the machine of --machine; null: none, or only a part of the program was run.
    const verify::Ledger* on_machine = nullptr;
};

/// A few lines for people.
std::string summary(const RunFacts& run);

/// JSON, UTF-8. Depends on the input and the options only: no times, no dates. Lengths in mm,
/// volumes in mm³; lines count from 1. Keys are only ever added.
void write_report(std::ostream& out, const RunFacts& run);

}  // namespace ncsim::report
