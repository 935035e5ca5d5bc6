// SPDX-License-Identifier: GPL-3.0-or-later
//
// Differences between controls, as switches. Rules::of() derives the switches from a dialect.
#pragma once

#include "ncsim/gcode/dialect.h"

#include "text/expression.h"

namespace ncsim::gcode {

/// Switches for the differences between controls.
struct Rules {
    Dialect dialect = Dialect::Rs274;
    bool strict = false;
    Arithmetic arithmetic;
    /// G4 P without a point is in milliseconds (Fanuc, Haas, Mach3's default).
    bool dwell_milliseconds = false;
    /// G28 and G30 cancel the tool length (Haas).
    bool home_cancels_length = false;
    /// G70 and G71 without other words select inch and millimetre; false: G70 and G71 are cycles.
    bool g70_is_units = true;
    /// G70, G71 and G72 with I, J, K, L are holes on a circle, an arc and a line (Haas). Fanuc has
    /// the same value because a program without signs of Haas is read as a program for Fanuc; on
    /// Fanuc all words must be present.
    bool hole_patterns = false;
    /// G12 and G13 mill circular pockets (Haas). On Fanuc, I and D must be present.
    bool circular_pockets = false;
    /// ,R and ,C round and chamfer the corner to the next line (Fanuc, Haas, Mazak).
    bool corner_words = false;
    /// RND rounds corners at arcs, too.
    bool rounds_arcs = false;
    /// With `corner_words`: a C word may be a corner whose comma is missing, because no C word of
    /// the program looks like a position of a rotary axis.
    bool c_may_be_corner = false;
    /// The user specified grbl, so codes that grbl 1.1 lacks are errors.
    bool only_grbl = false;
    CompensationStart compensation_start = CompensationStart::SquareToItself;
    /// K is the number of repeats of a cycle, and 0 means "define only" (Fanuc; on Haas: L).
    bool k_repeats = false;
    /// I, J and K of G83 and G73 are decreasing pecks (Haas).
    bool pecks_shrink = false;
    /// R alone drills again under a modal cycle, and Q and P count only in a block that drills
    /// (Fanuc).
    bool drills_by_r = false;
    /// The manual promises a hole for a block with X or Y only; Z alone is a doubt (Haas).
    bool holes_need_place = false;
    /// The pole of G16 is the position of the tool at G16 (Mach3); otherwise the origin.
    bool pole_is_position = false;
    /// G68.2 and similar codes follow the remaps of LinuxCNC; otherwise Fanuc. True only if the
    /// program has a sign of LinuxCNC or the user specified the dialect.
    bool linuxcnc_planes = false;
    /// Calls save the local variables #1 … #33 (Fanuc), not #1 … #30 of an O-word call.
    bool macro_b = false;

    /// True if the program is for LinuxCNC: by the rules, by the user, or by a sign in the program.
    /// A program without a sign counts as RS274/NGC and may be for another control.
    bool is_linuxcnc() const { return strict || linuxcnc_planes; }

    /// True if G10 L50 opens lines of data up to G11: on Fanuc, and on an unnamed control.
    bool has_data_lines() const {
        return !is_linuxcnc() && (dialect == Dialect::Fanuc || dialect == Dialect::Rs274);
    }

    /// Returns the rules of `dialect`; `strict`: the rules of LinuxCNC.
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
        rules.drills_by_r = !strict && dialect == Dialect::Fanuc;
        rules.holes_need_place = !strict && dialect == Dialect::Haas;
        const bool has_language =
            !strict && (dialect == Dialect::Heidenhain || dialect == Dialect::Sinumerik);
        rules.corner_words = fanuc || has_language;
        rules.rounds_arcs = has_language;
        if (fanuc || has_language) rules.compensation_start = CompensationStart::SquareToNext;
        rules.pole_is_position = !strict && dialect == Dialect::Mach3;
        rules.hole_patterns = fanuc;
        rules.circular_pockets = fanuc;
        rules.macro_b = fanuc;
        rules.g70_is_units = !strict && !fanuc;
        return rules;
    }
};

}  // namespace ncsim::gcode
