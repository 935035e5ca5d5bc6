// SPDX-License-Identifier: GPL-3.0-or-later
//
// Choice of a mutant at run time; included before each source with mutants.
//
// Environment: NCSIM_MUTANT is the number of the mutant that is on; NCSIM_MUTANTS_REACHED is a file
// with a byte for each mutant, which becomes 1 when the place of the mutant is evaluated.
#pragma once

namespace ncsim_mutants {

extern int chosen;
extern unsigned char* reached;

}  // namespace ncsim_mutants

// True if the mutant `number` is on.
inline bool ncsim_mutant(int number) {
    if (ncsim_mutants::reached) ncsim_mutants::reached[number] = 1;
    return number == ncsim_mutants::chosen;
}
