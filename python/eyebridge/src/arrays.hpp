#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>

namespace eyebridge::python {

/// Numbers in an array of any shape, or what numpy makes one of: lists, single ones, other types.
using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// A base for numpy arrays that keeps `owner` alive as long as they live.
template <class Owner>
pybind11::capsule keep(std::shared_ptr<Owner> owner) {
  return {new std::shared_ptr<Owner>(std::move(owner)),
          [](void* held) { delete static_cast<std::shared_ptr<Owner>*>(held); }};
}

/// A numpy array that looks at memory of ours, read-only; `owner` lives as long as the array.
template <class Value, class Owner>
pybind11::array_t<Value> view_of(const Value* data, std::vector<pybind11::ssize_t> shape,
                                 std::shared_ptr<Owner> owner) {
  pybind11::array_t<Value> array(std::move(shape), data, keep(std::move(owner)));
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

/// A numpy array of that shape that owns `values`, without copying them.
inline pybind11::array_t<double> array_of(std::vector<double> values,
                                          std::vector<pybind11::ssize_t> shape) {
  const auto owner = std::make_shared<std::vector<double>>(std::move(values));
  return pybind11::array_t<double>(std::move(shape), owner->data(), keep(owner));
}
/// One row of them.
inline pybind11::array_t<double> array_of(std::vector<double> values) {
  const auto count = static_cast<pybind11::ssize_t>(values.size());
  return array_of(std::move(values), {count});
}

}  // namespace eyebridge::python
