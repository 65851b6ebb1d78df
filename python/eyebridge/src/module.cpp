// eyebridge._core: worlds and robots for Python. What it offers is documented in __init__.pyi.

#include <pybind11/pybind11.h>

#include "bindings.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/prepare_process.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "Worlds and robots; use it as `eyebridge`.";
  eyebridge::camera::prepare_process();
  pybind11::register_exception<eyebridge::ConfigError>(module, "ConfigError", PyExc_ValueError);
  eyebridge::python::bind_scenario(module);
  eyebridge::python::bind_camera(module);
  eyebridge::python::bind_robot(module);
  eyebridge::python::bind_chassis(module);
  eyebridge::python::bind_likelihood(module);
  eyebridge::python::bind_simulation(module);
  eyebridge::python::bind_batch(module);
  eyebridge::python::bind_mapping(module);
  eyebridge::python::bind_planning(module);
  eyebridge::python::bind_dstar_lite(module);
  eyebridge::python::bind_dynamic_window(module);
  eyebridge::python::bind_localisation(module);
  eyebridge::python::bind_estimation(module);
}
