#pragma once

#include <memory>
#include <vector>

#include <pybind11/numpy.h>

namespace eyebridge::python {

/// A numpy array that looks at memory of ours, read-only; `owner` lives as long as the array.
template <class Value, class Owner>
pybind11::array_t<Value> view_of(const Value* data, std::vector<pybind11::ssize_t> shape,
                                 std::shared_ptr<Owner> owner) {
  auto* held = new std::shared_ptr<Owner>(std::move(owner));
  const pybind11::capsule base(
      held, [](void* pointer) { delete static_cast<std::shared_ptr<Owner>*>(pointer); });
  pybind11::array_t<Value> array(std::move(shape), data, base);
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

/// A numpy array that owns `values`, without copying them.
inline pybind11::array_t<double> array_of(std::vector<double> values) {
  auto owner = std::make_shared<std::vector<double>>(std::move(values));
  auto* held = new std::shared_ptr<std::vector<double>>(owner);
  const pybind11::capsule base(held, [](void* pointer) {
    delete static_cast<std::shared_ptr<std::vector<double>>*>(pointer);
  });
  return pybind11::array_t<double>(static_cast<pybind11::ssize_t>(owner->size()), owner->data(),
                                   base);
}

}  // namespace eyebridge::python
