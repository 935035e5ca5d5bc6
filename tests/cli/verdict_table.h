// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of tests/verdicts/index.json as parameters of tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace ncsim::cli_test {

inline const nlohmann::json& verdict_rows() {
    static const nlohmann::json rows = nlohmann::json::parse(std::ifstream(
        std::filesystem::path(NCSIM_SOURCE_DIR) / "tests" / "verdicts" / "index.json"));
    return rows;
}

/// Returns the test name of a row: the program, with a number if several rows have the program.
inline std::string name_of_row(const testing::TestParamInfo<std::size_t>& test) {
    const auto program = verdict_rows()[test.param]["program"].get<std::string>();
    std::string name = std::filesystem::path(program).stem().string();
    std::ranges::replace(name, '-', '_');
    std::size_t before = 0;
    for (std::size_t i = 0; i < test.param; ++i)
        before += verdict_rows()[i]["program"] == program ? 1 : 0;
    return before == 0 ? name : name + "_" + std::to_string(before + 1);
}

}  // namespace ncsim::cli_test
