// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operations of a program in the order of execution, with the operation of each motion.
#pragma once

#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/operation_name.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::simulation {

/// Follows the operations of a program. A name begins an operation if the next move starts above
/// the cuts of the previous operation, at the greatest height since the first of these cuts; so a
/// comment between cuts is not a name. A tool change begins an operation, too. Motions before the
/// first cut belong to the operation of this cut. In a loop, a name begins an operation only in the
/// first pass.
class OperationCourse {
public:
    /// Requires: the lines of `names` rise; `names` outlives the object.
    explicit OperationCourse(std::span<const toolpath::OperationName> names)
        : names_(names), has_begun_(names.size()) {}

    /// Takes the next motion. Returns true if the motion begins an operation.
    bool take(const gcode::Motion& motion);

    /// Number of the current operation, counted from 0. Requires: a motion was taken.
    std::size_t number() const { return count_ - 1; }
    /// Name of the current operation; null if unnamed. May change until the first cut.
    const toolpath::OperationName* name() const { return name_; }
    int tool() const { return tool_; }

private:
    void read_names(const gcode::Motion& motion);
    void begin(const toolpath::OperationName* name);
    void set_name(const toolpath::OperationName* name);

    std::span<const toolpath::OperationName> names_;
    std::vector<bool> has_begun_;  // by index in names_
    const toolpath::OperationName* name_ = nullptr;
    const toolpath::OperationName* waiting_ = nullptr;  // of the next move
    std::size_t count_ = 0;
    std::uint32_t line_ = 0;  // of the program itself
    int tool_ = 0;
    bool has_cut_ = true;
    double highest_mm_ = 0.0, lowest_mm_ = 0.0;  // tip since the first cut began
};

}  // namespace ncsim::simulation
