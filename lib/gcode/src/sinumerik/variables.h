// SPDX-License-Identifier: GPL-3.0-or-later
//
// R parameters and variables of a program (DEF), with values of the types of the language.
#pragma once

#include "ncsim/gcode/diagnostic.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::sinumerik {

/// Type of a variable.
enum class Type : std::uint8_t { Real, Int, Bool, Char, String };

/// A number or a text.
struct Value {
    double number = 0.0;
    std::string text;
    bool is_text = false;
    static Value of(double number) { return {number, {}, false}; }
    static Value of(std::string text) { return {0.0, std::move(text), true}; }
};

/// A variable; an array has several elements.
struct Variable {
    Type type = Type::Real;
    std::array<std::uint32_t, 3> size{};  ///< Number of elements per index; 0: no index.
    std::vector<Value> elements{Value{}};
    bool is_array() const { return size[0] != 0; }
};

/// A variable, or an R parameter, that a value is assigned to.
struct Target {
    std::shared_ptr<Variable> variable;  ///< Null: the R parameter `index`.
    std::uint32_t index = 0;
};

/// Variables of the running programs. Each program sees only variables of its own.
class Variables {
public:
    static constexpr std::uint32_t kMostR = 100'000;
    static constexpr std::size_t kMostElements = 100'000;

    Variables() { begin_program(); }
    void begin_program() { scopes_.emplace_back(); }
    void end_program() { scopes_.pop_back(); }

    /// Returns the variable `name` (upper case) of the running program, or nullptr.
    std::shared_ptr<Variable> find(std::string_view name) const;
    /// Defines `name` in the running program.
    void define(std::string name, std::shared_ptr<Variable> variable);

    /// Returns the value of R`index`. Reports a parameter that was never set, which counts as 0.
    double r(std::uint32_t index, SourceSpan span, DiagnosticLog& log);
    void set_r(std::uint32_t index, double value) { r_[index] = value; }

    Value get(const Target& target, SourceSpan span, DiagnosticLog& log);
    /// Sets `target`, converted to its type.
    /// Returns: false after reporting an error.
    bool set(const Target& target, const Value& value, SourceSpan span, DiagnosticLog& log);

private:
    std::vector<std::map<std::string, std::shared_ptr<Variable>, std::less<>>> scopes_;
    std::map<std::uint32_t, double> r_;
    std::set<std::uint32_t> reported_;
};

}  // namespace ncsim::gcode::sinumerik
