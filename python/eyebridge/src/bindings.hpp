#pragma once

#include <memory>

#include <pybind11/pybind11.h>

#include "shared_simulation.hpp"

namespace eyebridge::python {

/// Parts of the module; in this order, because later ones name the types of earlier ones.
void bind_scenario(pybind11::module_& module);
void bind_camera(pybind11::module_& module);
void bind_mapping(pybind11::module_& module);
void bind_planning(pybind11::module_& module);
void bind_dstar_lite(pybind11::module_& module);
void bind_dynamic_window(pybind11::module_& module);
void bind_localisation(pybind11::module_& module);
void bind_estimation(pybind11::module_& module);
void bind_robot(pybind11::module_& module);
void bind_chassis(pybind11::module_& module);
void bind_likelihood(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);
void bind_batch(pybind11::module_& module);
/// What the class Simulation has of objects.
void bind_objects(
    pybind11::class_<SharedSimulation, std::shared_ptr<SharedSimulation>>& simulation);

}  // namespace eyebridge::python
