// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings that the user accepted before.
#pragma once

#include "ncsim/simulation/checked.h"
#include "ncsim/verify/selection.h"

namespace ncsim::simulation {

/// Findings that the user has accepted, in the form that check() needs.
class KnownFindings {
public:
    virtual ~KnownFindings() = default;

    /// Marks the known findings of `checked`, and lists known findings that were not found again.
    virtual void accept(Checked& checked, const verify::Selection& selection) const = 0;

protected:
    KnownFindings() = default;
    KnownFindings(const KnownFindings&) = default;
    KnownFindings(KnownFindings&&) = default;
    KnownFindings& operator=(const KnownFindings&) = default;
    KnownFindings& operator=(KnownFindings&&) = default;
};

}  // namespace ncsim::simulation
