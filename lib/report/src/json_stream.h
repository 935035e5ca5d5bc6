// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON that is written while it is made: the same bytes as to_text() of all of it.
#pragma once

#include "json.h"

#include <iosfwd>
#include <string_view>
#include <vector>

namespace ncsim::report {

class JsonStream {
public:
    explicit JsonStream(std::ostream& out) : out_(out) {}

    /// In an object each with its key, in an array and at the beginning without.
    void begin_object(std::string_view key = {}) { begin(key, '{'); }
    void begin_array(std::string_view key = {}) { begin(key, '['); }
    void value(std::string_view key, const Json& value);
    void element(const Json& value) { this->value({}, value); }
    /// The object or array that was begun last; after the outermost comes the end of the line.
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
