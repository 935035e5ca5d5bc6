// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of small programs, from text to solid.
#pragma once

#include "ncsim/brep/recognise.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/mesh/provenance.h"
#include "ncsim/setup/job.h"

#include <string>

namespace ncsim::brep::test {

struct Made {
    Recognised solid;
    mesh::Provenance provenance;
    std::string step;  // the solid as a STEP file
    cda::Boundary boundary;
};

/// Simulates `job` and recognises the surfaces of the part. `tool_tolerance` is in mm. With
/// `is_draft`, consecutive moves that are nearly straight are joined.
Made make_part(setup::Job job, double tool_tolerance, unsigned threads = 0, bool is_draft = false);

/// Makes the part of `moves` on a block of 80 x 60 x 20 mm with the zero in a corner of its top, or
/// with `is_bar` on a bar D60 x 20 with its top in Z0. `moves` may call T1 flat D10, T2 drill D6
/// 118 degrees, T3 ball D8, T4 bull nose D12 R2, and T5 chamfer D10 45 degrees per side.
Made make_part(const std::string& name, const std::string& moves, double tool_tolerance = 0.05,
               unsigned threads = 0, bool is_bar = false);

}  // namespace ncsim::brep::test
