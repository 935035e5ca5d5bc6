// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of variables.
#include "sinumerik/variables.h"

#include "text/message.h"

#include <cmath>
#include <utility>

namespace ncsim::gcode::sinumerik {

std::shared_ptr<Variable> Variables::find(std::string_view name) const {
    const auto found = scopes_.back().find(name);
    return found == scopes_.back().end() ? nullptr : found->second;
}

void Variables::define(std::string name, std::shared_ptr<Variable> variable) {
    scopes_.back().insert_or_assign(std::move(name), std::move(variable));
}

double Variables::r(std::uint32_t index, SourceSpan span, DiagnosticLog& log) {
    const auto found = r_.find(index);
    if (found != r_.end()) return found->second;
    if (reported_.size() < 50 && reported_.insert(index).second)
        log.add(Message::ParameterWithoutValue, span, {"R" + std::to_string(index)});
    return 0.0;
}

Value Variables::get(const Target& target, SourceSpan span, DiagnosticLog& log) {
    if (!target.variable) return Value::of(r(target.index, span, log));
    return target.variable->elements[target.index];
}

bool Variables::set(const Target& target, const Value& value, SourceSpan span, DiagnosticLog& log) {
    const Type type = target.variable ? target.variable->type : Type::Real;
    const bool is_text = type == Type::String;
    if (value.is_text != is_text && !(type == Type::Char && value.text.size() == 1)) {
        log.add(Message::ValueType, span, {is_text ? "a text" : "a number"});
        return false;
    }
    Value converted = value;
    if (type == Type::Char && value.is_text)
        converted = Value::of(static_cast<double>(static_cast<unsigned char>(value.text[0])));
    if (type == Type::Int || type == Type::Char) converted.number = std::round(converted.number);
    if (type == Type::Bool) converted.number = converted.number != 0.0 ? 1.0 : 0.0;
    if (target.variable) {
        target.variable->elements[target.index] = std::move(converted);
    } else {
        set_r(target.index, converted.number);
    }
    return true;
}

}  // namespace ncsim::gcode::sinumerik
