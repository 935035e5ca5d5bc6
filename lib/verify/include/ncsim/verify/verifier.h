// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies a program while it is being simulated: it sees every motion before and after, and does
// the cutting itself, since only it knows what has to be measured.
//
//     verifier.begin(motion);
//     walk.take(motion, origin, [&](const toolpath::Step& step) { verifier.cut(step, part); });
//     verifier.end();
#pragma once

#include "ncsim/cda/tree.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/setup.h"
#include "ncsim/verify/verdict.h"

#include <memory>
#include <string>
#include <vector>

namespace ncsim::verify {

class Verifier {
public:
    /// `stock` (mm, W) and `lattice` are those of the part; an empty box if nothing is simulated.
    Verifier(Setup setup, const cda::Box& stock, const cda::Lattice& lattice);
    ~Verifier();
    Verifier(const Verifier&) = delete;
    Verifier& operator=(const Verifier&) = delete;

    /// The frame that the next motion is programmed in: where its tool length is taken from.
    void set_frame(const gcode::ProgramFrame& frame);
    void begin(const gcode::Motion& motion);
    /// Cuts `part` by the cells of the step. Returns the volume removed (mm³) where it was
    /// measured, else 0.
    double cut(const toolpath::Step& step, cda::TreeCda& part);
    void end();
    /// Is every volume measured, so that the sum of cut() is what the program removed?
    bool measures_all() const;

    /// Adds what the interpreter and others have to say.
    void add(const gcode::Diagnostics& diagnostics);
    /// Adds what somebody else found, complete but for category, hint and suppression. Left out if
    /// its rule is not selected.
    void add(Finding finding);
    /// After the last motion. `part` is null if nothing was simulated; `stock_mm3` is its volume
    /// before the first cut.
    Verdict finish(const gcode::Interpretation& interpretation, const cda::TreeCda* part,
                   double stock_mm3);

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ncsim::verify
