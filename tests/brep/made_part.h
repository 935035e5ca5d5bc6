// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of small programs, from text to solid.
#pragma once

#include "ncsim/brep/recognise.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/export/provenance.h"
#include "ncsim/setup/job.h"

#include <string>

namespace ncsim::brep::test {

struct Made {
    Recognised solid;
    exporter::Provenance provenance;
    std::string step;  // the solid as a file
    cda::Boundary boundary;
};

/// With `is_draft` moves in a row are joined where they are nearly straight.
Made make_part(setup::Job job, double tool_tolerance, unsigned threads = 0, bool is_draft = false);

/// Of a block of 80 x 60 x 20 with a corner in the zero and its top in Z20, or of a bar D60 x 20
/// with its top in Z0. `moves` may call T1 flat D10, T2 drill D6 118 degrees, T3 ball D8, T4 bull
/// nose D12 R2, T5 chamfer D10 45 degrees a side.
Made make_part(const std::string& name, const std::string& moves, double tool_tolerance = 0.05,
               unsigned threads = 0, bool is_bar = false);

}  // namespace ncsim::brep::test
