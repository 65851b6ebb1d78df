#include <memory>

#include "arrays.hpp"
#include "bindings.hpp"
#include "robot_camera.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;

/// Looks at the frame's own memory: height x width x 3 bytes.
py::array_t<std::uint8_t> frame_of(RobotCamera& camera) {
  camera::FramePtr frame;
  {
    const py::gil_scoped_release others_run;
    frame = camera.frame();
  }
  // Rgb24 frames of the renderer have no gaps between rows.
  return view_of(frame->bytes.data(), {frame->height, frame->width, 3}, frame);
}

}  // namespace

void bind_camera(py::module_& module) {
  py::class_<RobotCamera>(module, "Camera")
      .def("frame", &frame_of)
      .def_property_readonly("size", [](const RobotCamera& camera) {
        return py::make_tuple(camera.width(), camera.height());
      });
}

}  // namespace eyebridge::python
