// SPDX-License-Identifier: GPL-3.0-or-later
//
// GrowingList, a list with cheap copies.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace ncsim::gcode {

/// A list that grows at the end. Copies share their common beginning, so saving and restoring a
/// copy costs O(1), whatever the length. For a single thread.
template <typename Value>
class GrowingList {
public:
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const Value& operator[](std::size_t i) const { return (*values_)[i]; }
    const Value& front() const { return values_->front(); }
    const Value& back() const { return (*values_)[size_ - 1]; }
    const Value* begin() const { return values_ ? values_->data() : nullptr; }
    const Value* end() const { return begin() + size_; }

    void push_back(Value value) {
        if (!values_) values_ = std::make_shared<std::vector<Value>>();
        // Elements beyond size_ were added by a copy.
        if (values_->size() > size_) {
            if (values_.use_count() > 1) {
                values_ = std::make_shared<std::vector<Value>>(begin(), end());
            } else {
                values_->erase(values_->begin() + static_cast<std::ptrdiff_t>(size_),
                               values_->end());
            }
        }
        values_->push_back(std::move(value));
        ++size_;
    }

    bool operator==(const GrowingList& other) const {
        return std::equal(begin(), end(), other.begin(), other.end());
    }

private:
    std::shared_ptr<std::vector<Value>> values_;  // Null while empty.
    std::size_t size_ = 0;                        // Number of elements of this list.
};

}  // namespace ncsim::gcode
