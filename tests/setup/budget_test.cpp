// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/setup/budget.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <stop_token>

namespace ncsim::setup {
namespace {

TEST(Budget, IsUsedUpWhenWorkIsToStop) {
    std::stop_source stop;
    Budget budget;
    budget.stop_with(stop.get_token());
    EXPECT_NO_THROW(budget.check("a.nc", 3));
    stop.request_stop();
    EXPECT_THROW(budget.check("a.nc", 3), std::runtime_error);
    EXPECT_THROW(budget.check("a.nc"), std::runtime_error);
}

}  // namespace
}  // namespace ncsim::setup
