// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of operations: sums by tool and name, of a run and of a ledger.
#include "ncsim/simulation/facts.h"

#include "ledger_operations.h"
#include "operation_rows.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::report {
namespace {

simulation::ProgramFacts::Operation operation(const std::string& name, int tool, double feed_mm) {
    simulation::ProgramFacts::Operation made;
    made.name = name;
    made.tool = tool;
    made.distances.feed_mm = feed_mm;
    made.distances.feed_seconds = 2.0 * feed_mm;
    return made;
}

TEST(OperationRows, SumWhatAToolDoesUnderAName) {
    simulation::ProgramFacts program;
    program.operations = {operation("FACE", 1, 10), operation("", 2, 20), operation("FACE", 1, 3),
                          operation("FACE", 2, 7), operation("AIR", 1, 0)};
    const auto rows = operation_rows(program, {100, 200, 30, 70, 5});
    ASSERT_EQ(rows.size(), 3U) << "an operation without a feed move is no row";
    EXPECT_EQ(rows[0].operation.name, "FACE");
    EXPECT_EQ(rows[0].operation.tool, 1);
    EXPECT_EQ(rows[0].operation.distances.feed_mm, 13.0);
    EXPECT_EQ(rows[0].operation.distances.feed_seconds, 26.0);
    EXPECT_EQ(rows[0].removed_mm3, 130.0);
    EXPECT_EQ(rows[1].operation.tool, 2);
    EXPECT_EQ(rows[1].removed_mm3, 200.0);
    EXPECT_EQ(rows[2].removed_mm3, 70.0);
    EXPECT_EQ(operation_rows(program, {100}).at(1).removed_mm3, 0.0) << "not known";
}

TEST(OperationRows, AreNoneForOneRowOrWithoutNames) {
    simulation::ProgramFacts program;
    EXPECT_TRUE(operation_rows(program).empty());
    program.operations = {operation("FACE", 1, 10), operation("FACE", 1, 3)};
    EXPECT_TRUE(operation_rows(program).empty());
    program.operations = {operation("", 1, 10), operation("", 2, 3)};
    EXPECT_TRUE(operation_rows(program).empty());
    program.operations.push_back(operation("SLOT", 2, 1));
    EXPECT_EQ(operation_rows(program).size(), 3U);
    EXPECT_EQ(operation_rows(program, {}, 2).size(), 2U) << "of a tool alone";
    EXPECT_TRUE(operation_rows(program, {}, 1).empty());
}

verify::LedgerRow row(std::uint64_t motion, double removed, double length, double seconds) {
    verify::LedgerRow made;
    made.first_motion = made.last_motion = motion;
    made.removed_mm3 = removed;
    made.length_mm = length;
    made.seconds = seconds;
    return made;
}

/// FACE by T1 from motion 3, SLOT by T2 from motion 6, FACE again from motion 9.
Checked checked() {
    Checked all;
    all.operations = {{"FACE", 4, 1, 3}, {"SLOT", 8, 2, 6}, {"FACE", 12, 1, 9}};
    return all;
}

TEST(LedgerOperations, BelongToTheLastNameBefore) {
    const Checked all = checked();
    EXPECT_EQ(operation_of(all, 2), nullptr);
    EXPECT_EQ(operation_of(all, 3)->name, "FACE");
    EXPECT_EQ(operation_of(all, 5)->name, "FACE");
    EXPECT_EQ(operation_of(all, 6)->name, "SLOT");
    EXPECT_EQ(operation_of(all, 99)->line, 12U);
    EXPECT_EQ(operation_of({}, 1), nullptr);
}

TEST(LedgerOperations, SumRowsAndForgetUnknownTimes) {
    Checked all = checked();
    auto& rows = all.verdict.ledger.rows;
    rows = {row(1, 9, 9, 9), row(3, 100, 10, 1), row(5, 5, 50, 3), row(6, 200, 20, 4),
            row(9, 1, 2, 6)};
    rows[2].kind = gcode::MoveKind::Rapid;
    auto sums = ledger_operations(all);
    ASSERT_EQ(sums.size(), 2U);
    EXPECT_EQ(sums[0].removed_mm3, 106.0) << "rapids remove, too";
    EXPECT_EQ(sums[0].feed_mm, 12.0);
    EXPECT_EQ(sums[0].seconds, 7.0);
    EXPECT_EQ(sums[1].operation.name, "SLOT");
    rows[1].seconds.reset();
    sums = ledger_operations(all);
    EXPECT_FALSE(sums[0].seconds) << "unknown for good";
    EXPECT_EQ(sums[1].seconds, 4.0);
    rows[3].length_mm = 0.0;
    EXPECT_TRUE(ledger_operations(all).empty()) << "one operation alone cuts";
    rows[3].length_mm = 20.0;
    for (simulation::CheckedOperation& operation : all.operations)
        operation.name.clear();
    EXPECT_TRUE(ledger_operations(all).empty()) << "without a name";
}

}  // namespace
}  // namespace ncsim::report
