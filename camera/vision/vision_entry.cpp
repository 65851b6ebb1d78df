#include "vision/vision_parts.hpp"

// What fiducials/vision.cpp looks for.
extern "C" __attribute__((visibility("default"))) const eyebridge::camera::Vision*
eyebridge_vision() {
  return &eyebridge::camera::opencv_vision();
}
