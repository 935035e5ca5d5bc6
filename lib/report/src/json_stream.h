// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON written piece by piece, with the same bytes as to_text() of the whole value.
#pragma once

#include "json.h"

#include <iosfwd>
#include <string_view>
#include <vector>

namespace ncsim::report {

/// Writer of nested objects and arrays.
class JsonStream {
public:
    explicit JsonStream(std::ostream& out) : out_(out) {}

    /// Begins an object or array, or writes a value. Inside an object, `key` is required; inside an
    /// array and at the top level, `key` is empty.
    void begin_object(std::string_view key = {}) { begin(key, '{'); }
    void begin_array(std::string_view key = {}) { begin(key, '['); }
    void value(std::string_view key, const Json& value);
    void element(const Json& value) { this->value({}, value); }
    /// Ends the innermost object or array; the outermost is followed by a line end.
    void end();

private:
    void begin(std::string_view key, char bracket);
    void next(std::string_view key);

    struct Open {
        char end;
        bool is_empty = true;
    };
    std::ostream& out_;
    std::vector<Open> open_;
};

}  // namespace ncsim::report
