#pragma once

#include <pybind11/pybind11.h>

#include "control_world.hpp"

namespace eyebridge::python {

/// Adds what concerns objects to the class World of eyebridge._control.
void bind_things(pybind11::class_<ControlWorld>& world);

}  // namespace eyebridge::python
