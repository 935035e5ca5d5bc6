// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies a program while it is being simulated: it sees every motion before and after its cells
// are taken away, and changes nothing.
//
//     if (verifier.needs_account()) part.keep_account();  // before the first cell
//     verifier.begin(motion, &part);  // each motion its own origin
//     walk.take(motion, origin, [&](const toolpath::Step& step) {
//         verifier.look(step, part);
//         for (const cda::Cell& cell : step.cells) part.subtract(cell);
//         verifier.look_back(step, part, removed);
//     });
//     verifier.end(&part);
#pragma once

#include "ncsim/cda/workpiece.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/evidence.h"
#include "ncsim/verify/setup.h"
#include "ncsim/verify/verdict.h"

#include <memory>
#include <string>
#include <vector>

namespace ncsim::verify {

/// What a walk has to follow whose steps a Verifier of this setup looks at.
toolpath::Watch watch_of(const Setup& setup);

class Verifier {
public:
    /// `stock` (mm, W) and `lattice` are those of the part; an empty box if nothing is simulated.
    Verifier(Setup setup, const cda::Box& stock, const cda::Lattice& lattice, Share share = {});
    ~Verifier();
    Verifier(const Verifier&) = delete;
    Verifier& operator=(const Verifier&) = delete;

    /// The frame that the next motion is programmed in: where its tool length is taken from.
    void set_frame(const gcode::ProgramFrame& frame);
    /// `part` is as it is before the motion; null if nothing is simulated.
    void begin(const gcode::Motion& motion, const cda::WorkpieceModel* part = nullptr);
    /// Before the cells of the step are taken away from `part`, which is of a model that verifies.
    void look(const toolpath::Step& step, const cda::WorkpieceModel& part);
    /// After that. `removed` is the volume they took (mm³), where measures_all().
    void look_back(const toolpath::Step& step, const cda::WorkpieceModel& part,
                   double removed = 0.0);
    /// The tool at rest where a motion ends that came from nobody knows where.
    void arrive(const toolpath::Step& step, const cda::WorkpieceModel& part);
    /// And as it is after it.
    void end(const cda::WorkpieceModel* part = nullptr);
    /// Wants it the volume of every step?
    bool measures_all() const;
    /// Else: wants it the part to keep an account of all of them?
    bool needs_account() const;

    /// Adds what the interpreter and others have to say.
    void add(const gcode::Diagnostics& diagnostics);
    /// Adds what somebody else found, complete but for category, hint and suppression. Left out if
    /// its rule is not selected.
    void add(Finding finding);
    /// The same for a reason that keeps the program from being proven.
    void add_doubt(std::string_view reason, std::string message, const Place& place = {});
    /// After the last motion. `part` is null if nothing was simulated; `stock_mm3` is its volume
    /// before the first cut.
    Verdict finish(const gcode::Interpretation& interpretation, const cda::WorkpieceModel* part,
                   double stock_mm3);

    /// Of a tile: what was seen so far. It is asked for that instead of finish().
    Evidence take_evidence();

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ncsim::verify
