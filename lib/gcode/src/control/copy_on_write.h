// SPDX-License-Identifier: GPL-3.0-or-later
//
// CopyOnWrite, a value with cheap copies.
#pragma once

#include <memory>
#include <utility>

namespace ncsim::gcode {

/// A large value that copies share until a copy is changed. For a single thread.
template <typename Value>
class CopyOnWrite {
public:
    CopyOnWrite() : value_(std::make_shared<Value>()) {}

    const Value& operator*() const { return *value_; }
    const Value* operator->() const { return value_.get(); }

    /// Returns the value for writing, unshared. Valid until this object is copied.
    Value& change() {
        if (value_.use_count() > 1) value_ = std::make_shared<Value>(*value_);
        return *value_;
    }

    bool operator==(const CopyOnWrite& other) const {
        return value_ == other.value_ || *value_ == *other.value_;
    }

private:
    std::shared_ptr<Value> value_;  // Never null.
};

}  // namespace ncsim::gcode
