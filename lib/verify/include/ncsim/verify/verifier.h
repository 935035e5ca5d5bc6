// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifier of a program during the simulation. The verifier observes every motion before and after
// the cells are removed, and changes neither motions nor cells.
//
//     if (verifier.needs_account()) part.track_removal();  // before the first cell
//     verifier.begin(motion, &part);  // each motion has its own origin
//     walk.take(motion, origin, [&](const toolpath::Step& step) {
//         verifier.before_cut(step);
//         for (const cda::Cell& cell : step.cells) part.subtract(cell);
//         verifier.after_cut(step, removed);
//     });
//     verifier.end();
#pragma once

#include "ncsim/cda/workpiece.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/evidence.h"
#include "ncsim/verify/setup.h"
#include "ncsim/verify/verdict.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ncsim::verify {

/// Returns the places and parts of tools that a walk must follow for a Verifier with this setup.
toolpath::WatchedParts watched_parts(const Setup& setup);

/// Verifier of a program, or of a tile of the part.
class Verifier {
public:
    /// Starts the verification of a program. `stock` (mm, W) and `lattice` are the part's; `stock`
    /// is empty without a simulation.
    Verifier(Setup setup, const Box& stock, const cda::Lattice& lattice, Share share = {});
    ~Verifier();
    Verifier(const Verifier&) = delete;
    Verifier& operator=(const Verifier&) = delete;

    /// Begins a motion. All functions observe `part`, which the motion cuts; null without a
    /// simulation, or for the evidence of tiles.
    void begin(const gcode::Motion& motion, const cda::VerifyingModel* part = nullptr);
    /// Observes `step` before the cells are removed.
    void before_cut(const toolpath::Step& step);
    /// Observes `step` after the cells are removed. `removed` is the removed volume (mm³); only
    /// used if measures_all().
    void after_cut(const toolpath::Step& step, double removed = 0.0);
    /// Observes the tool at rest at the end of a motion with an unknown start.
    void at_end_position(const toolpath::Step& step);
    /// Ends and judges the motion; open contacts stay open.
    void end();
    /// Ends the motion without a judgement. Returns the open contacts if Setup::decides_contacts.
    std::vector<OpenContact> end_steps();
    /// Judges the motion after end_steps(), with a decision for each open contact.
    void judge(std::span<const ContactDecision> decisions);
    /// True if after_cut() needs the removed volume of every step.
    bool measures_all() const;
    /// True if the part must keep an account of removed volumes; false if measures_all().
    bool needs_account() const;

    /// Adds diagnostics of the interpreter and of further sources.
    void add(const gcode::Diagnostics& diagnostics);
    /// Adds a finding of the caller, complete except for category, hint and suppression. Ignored if
    /// the rule is not selected.
    void add(Finding finding);
    /// Adds a doubt of the caller.
    void add_doubt(std::string_view reason, std::string message, const Place& place = {});
    /// Finishes the verification after the last motion. `part` is null without a simulation;
    /// `stock_mm3` is the volume of the stock before the first cut.
    Verdict finish(const gcode::Interpretation& interpretation, const cda::WorkpieceModel* part,
                   double stock_mm3);

    /// Returns the evidence of a tile so far.
    /// Requires: the Verifier is of a tile; finish() is not called.
    Evidence take_evidence();

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ncsim::verify
