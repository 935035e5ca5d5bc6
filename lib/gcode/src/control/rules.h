// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where controls differ, as switches: the only place that knows what a dialect means.
#pragma once

#include "ncsim/gcode/dialect.h"

#include "text/expression.h"

namespace ncsim::gcode {

struct Rules {
    Dialect dialect = Dialect::Rs274;
    bool strict = false;
    Arithmetic arithmetic;
    /// G4 P without a point is in milliseconds (Fanuc, Haas, Mach3's default).
    bool dwell_milliseconds = false;
    /// G28 and G30 cancel the tool length (Haas).
    bool home_cancels_length = false;
    /// G70 and G71 alone select inch and millimetre; else they are cycles.
    bool g70_is_units = true;
    /// G70, G71 and G72 with I, J, K, L are holes on a circle, an arc and a line (Haas). A program
    /// without a sign of its control is read as Fanuc's, so there, too, where all words are told.
    bool hole_patterns = false;
    /// G12 and G13 mill circular pockets (Haas); on Fanuc where I and D tell that they are meant.
    bool circular_pockets = false;
    /// ,R and ,C round and chamfer the corner to the next line (Fanuc, Haas, Mazak).
    bool corner_words = false;
    /// There, C may be a corner that somebody wrote without the comma: it never is what an axis
    /// would be told.
    bool c_may_be_corner = false;
    /// The user has named grbl, so codes that grbl 1.1 does not have are errors.
    bool only_grbl = false;
    CompensationStart compensation_start = CompensationStart::SquareToItself;
    /// K is the number of repeats of a cycle, and 0 means "define only" (Fanuc; on Haas L).
    bool k_repeats = false;
    /// I, J and K of G83 and G73 are pecks that shrink (Haas).
    bool pecks_shrink = false;
    /// G68.2 and its kin as the remaps of LinuxCNC have them: only where the program is one of that
    /// control by a sign of its own; else they are Fanuc's.
    bool linuxcnc_planes = false;
    /// Local variables #1 … #33 (Fanuc), not #1 … #30 of an O-word call.
    bool macro_b = false;

    /// The program is LinuxCNC's: by its rules, by the user, or by a sign of its own. A program
    /// without a sign counts as RS274/NGC, and may be for another control.
    bool is_linuxcnc() const { return strict || linuxcnc_planes; }

    static Rules of(Dialect dialect, bool strict) {
        Rules rules;
        rules.dialect = dialect;
        rules.strict = strict;
        rules.arithmetic.strict = strict;
        const bool fanuc = !strict && (dialect == Dialect::Fanuc || dialect == Dialect::Haas);
        rules.arithmetic.fix_truncates = fanuc;
        rules.arithmetic.bitwise = fanuc;
        rules.arithmetic.vacant = fanuc;
        rules.arithmetic.compares_loosely = strict || dialect == Dialect::Rs274;
        rules.dwell_milliseconds = fanuc;
        rules.home_cancels_length = !strict && dialect == Dialect::Haas;
        rules.k_repeats = !strict && dialect == Dialect::Fanuc;
        rules.pecks_shrink = !strict && dialect == Dialect::Haas;
        rules.corner_words = fanuc;
        if (fanuc) rules.compensation_start = CompensationStart::SquareToNext;
        rules.hole_patterns = fanuc;
        rules.circular_pockets = fanuc;
        rules.macro_b = fanuc;
        rules.g70_is_units = !strict && !fanuc;
        return rules;
    }
};

}  // namespace ncsim::gcode
