// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text of STEP files (ISO 10303-21): numbered entities, and values in their notation.
#pragma once

#include "ncsim/base/vec3.h"

#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::exporter {

/// A written entity, by the number after #; none by default.
struct Entity {
    std::uint64_t number = 0;
    explicit operator bool() const { return number != 0; }
};

/// Text of a value in an entity.
struct StepValue {
    StepValue(Entity entity);                        ///< #12
    StepValue(double number);                        ///< 2.5; always with a decimal point
    StepValue(Vec3 v);                               ///< (1.,0.,0.)
    StepValue(const std::vector<Entity>& entities);  ///< (#12,#13)
    StepValue(std::string written) : text(std::move(written)) {}
    StepValue(std::string_view written) : text(written) {}
    StepValue(const char* written) : text(written) {}

    std::string text;
};

/// Returns a STEP string: ASCII in quotes, other characters by number.
std::string step_string(std::string_view words);

/// List of numbered entities. Each refers only to earlier entities.
class StepFile {
public:
    /// Requires: `out` outlives this object.
    explicit StepFile(std::ostream& out) : out_(out) {}

    /// Adds an entity: `form` with the values in place of {}. The values are evaluated from left to
    /// right, so they may be new entities.
    Entity add(std::string_view form, std::initializer_list<StepValue> values = {});
    /// Adds text that is no entity.
    void add_text(std::string_view text) { text_ += text; }
    /// Writes the rest. Throws: std::runtime_error if the stream fails.
    void finish();

private:
    void flush();

    std::ostream& out_;
    Entity last_;
    std::string text_;
};

}  // namespace ncsim::exporter
