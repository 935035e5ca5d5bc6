// SPDX-License-Identifier: GPL-3.0-or-later
//
// NumPy arrays over memory of C++ objects, without copies.
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <utility>
#include <vector>

namespace ncsim::python {

/// Returns a Python object that keeps `owner` alive.
template <class Owner>
pybind11::capsule keeper_of(std::shared_ptr<const Owner> owner) {
    auto* kept = new std::shared_ptr<const Owner>(std::move(owner));
    return {kept, [](void* p) { delete static_cast<std::shared_ptr<const Owner>*>(p); }};
}

/// Returns a read-only array of the values at `first`, with the dimensions `shape`, without a copy.
/// The array keeps `owner`, which has the memory, alive.
template <class Value, class Owner>
pybind11::array_t<Value> view_of(const Value* first, std::vector<pybind11::ssize_t> shape,
                                 std::shared_ptr<const Owner> owner) {
    pybind11::array_t<Value> array(std::move(shape), first, keeper_of(std::move(owner)));
    array.attr("setflags")(pybind11::arg("write") = false);
    return array;
}

/// Returns a read-only array of the values of `list`, a member of `owner`, without a copy.
template <class Value, class Owner>
pybind11::array_t<Value> view_of(const std::vector<Value>& list,
                                 std::shared_ptr<const Owner> owner) {
    return view_of(list.data(), {static_cast<pybind11::ssize_t>(list.size())}, std::move(owner));
}

}  // namespace ncsim::python
