// SPDX-License-Identifier: GPL-3.0-or-later
//
// Balance of a ledger.
#include "ncsim/verify/ledger.h"

#include <cmath>

namespace ncsim::verify {

double Ledger::imbalance() const {
    return stock_mm3 > 0.0 ? std::abs(removed_mm3 + rest_mm3 - stock_mm3) / stock_mm3 : 0.0;
}

}  // namespace ncsim::verify
