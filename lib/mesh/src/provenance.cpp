// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lookup of origins in a Provenance.
#include "ncsim/mesh/provenance.h"

namespace ncsim::mesh {

Provenance::Entry Provenance::of(cda::Origin origin) const {
    const auto index = static_cast<std::size_t>(origin);
    return index < entries.size() ? entries[index] : Entry{};
}

}  // namespace ncsim::mesh
