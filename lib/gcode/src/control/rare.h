// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rare, an optional value for large, mostly absent data.
#pragma once

#include <memory>
#include <utility>

namespace ncsim::gcode {

/// An optional value that is large and mostly absent: a copy without a value costs a pointer.
template <typename Value>
class Rare {
public:
    Rare() = default;
    Rare(const Rare& other) : value_(other ? std::make_unique<Value>(*other) : nullptr) {}
    Rare(Rare&&) noexcept = default;
    Rare& operator=(const Rare& other) {
        if (this != &other) value_ = other ? std::make_unique<Value>(*other) : nullptr;
        return *this;
    }
    Rare& operator=(Rare&&) noexcept = default;
    Rare& operator=(Value value) {
        value_ = std::make_unique<Value>(std::move(value));
        return *this;
    }
    ~Rare() = default;

    explicit operator bool() const { return value_ != nullptr; }
    Value& operator*() { return *value_; }
    const Value& operator*() const { return *value_; }
    Value* operator->() { return value_.get(); }
    const Value* operator->() const { return value_.get(); }
    void reset() { value_.reset(); }

    bool operator==(const Rare& other) const {
        return value_ && other.value_ ? *value_ == *other.value_ : !value_ && !other.value_;
    }

private:
    std::unique_ptr<Value> value_;
};

}  // namespace ncsim::gcode
