// SPDX-License-Identifier: GPL-3.0-or-later
//
// History of a stock from a file: the motions of earlier runs that left its faces, with the
// surfaces that they left.
#pragma once

#include "ncsim/brep/swept_surfaces.h"
#include "ncsim/cda/shape.h"
#include "ncsim/mesh/provenance.h"
#include "ncsim/toolpath/stock.h"

#include <memory>
#include <string>
#include <vector>

namespace ncsim::simulation {

/// Sources of the faces of a stock, mm, in the frame of the program. Entry i belongs to Origin{i};
/// entry 0 is the stock of the first run.
struct StockHistory {
    std::vector<mesh::Provenance::Entry> entries;
    std::vector<std::string> programs;  ///< Names that entries refer to, from 1.
    std::vector<brep::SweptSurfaces> surfaces;
};

/// Reads what the file of `stock` records; null if the file records no sources. Throws:
/// std::runtime_error with file and line if a record has another form, or if a surface lies on no
/// face of its origin.
/// Cost: that of the boundary of the stock.
std::shared_ptr<const StockHistory> read_stock_history(const toolpath::Stock& stock);

/// Returns the record of `entry` for read_stock_history(), with the candidates of `source`.
cda::ShapeSource record_of(const mesh::Provenance& provenance, const mesh::Provenance::Entry& entry,
                           const brep::SweptSurfaces& source);

}  // namespace ncsim::simulation
