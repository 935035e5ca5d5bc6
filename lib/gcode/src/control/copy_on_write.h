// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

namespace ncsim::gcode {

/// A large value that is copied when it is changed, not when it is kept: copies share it until
/// then. For one thread.
template <typename Value>
class CopyOnWrite {
public:
    CopyOnWrite() : value_(std::make_shared<Value>()) {}

    const Value& operator*() const { return *value_; }
    const Value* operator->() const { return value_.get(); }

    /// To write into; no other copy sees it. Valid until this one is copied.
    Value& change() {
        if (value_.use_count() > 1) value_ = std::make_shared<Value>(*value_);
        return *value_;
    }

    bool operator==(const CopyOnWrite& other) const {
        return value_ == other.value_ || *value_ == *other.value_;
    }

private:
    std::shared_ptr<Value> value_;  // never null
};

}  // namespace ncsim::gcode
