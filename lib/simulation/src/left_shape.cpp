// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as stock of the next run.
#include "ncsim/simulation/left_shape.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/brep/candidate_filter.h"
#include "ncsim/cda/tree.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/simulation/stock_history.h"

#include "sources.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace ncsim::simulation {

namespace {

void keep_fitting(brep::SweptSurfaces& source, const std::vector<bool>& fits) {
    std::vector<brep::CandidateSurface> kept;
    for (std::size_t i = 0; i < fits.size(); ++i) {
        if (fits[i]) kept.push_back(std::move(source.candidates[i]));
    }
    source.candidates = std::move(kept);
}

}  // namespace

cda::Shape take_left_shape(const Plan& plan, const Survey& survey, Simulation& simulation,
                           const std::vector<std::string>& assumed) {
    cda::Shape shape = toolpath::stock_shape(*survey.stock, plan.tool_tolerance);
    if (!simulation.history) {
        for (cda::Cell& cell : shape.carved)
            cell.origin = cda::kStockOrigin;
    }
    std::ranges::move(simulation.carved, std::back_inserter(shape.carved));
    simulation.carved.clear();
    shape.assumed.clear();
    for (const std::string& text : assumed)
        shape.assumed.push_back(one_line(text));
    const mesh::Provenance& provenance = simulation.provenance;
    shape.sources.clear();
    for (const mesh::Provenance::Entry& entry : provenance.entries)
        shape.sources.push_back(record_of(provenance, entry, {}));
    // Boundary of the cells as read from the file: ranks of cells are not written, and decide which
    // of several origins a common plane has.
    for (cda::Cell& cell : shape.carved)
        cell.rank = cda::Cell::kFirstRank;
    const cda::Boundary boundary =
        cda::create(cda::TreeCda(cda::TreeParameters{}), shape)->boundary();
    const brep::CandidateFilter filter(boundary);
    for_each_source(plan, survey, simulation, boundary, 0.0,
                    [&](cda::Origin origin, brep::SweptSurfaces source) {
                        keep_fitting(source, filter.fitting(origin, source, 1.0));
                        const auto i = static_cast<std::size_t>(origin);
                        shape.sources[i] = record_of(provenance, provenance.entries[i], source);
                    });
    return shape;
}

}  // namespace ncsim::simulation
