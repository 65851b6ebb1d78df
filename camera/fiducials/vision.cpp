#include "fiducials/vision.hpp"

#include "sources/own_library.hpp"

namespace eyebridge::camera {

const Vision& vision() {
  static const Vision* const kVision = reinterpret_cast<VisionEntry*>(
      own_library_entry("libeyebridge_vision.so", "eyebridge_vision"))();
  return *kVision;
}

FiducialBits fiducial_bits(FiducialFamily family, int id) {
  return vision().fiducial_bits(family, id);
}

}  // namespace eyebridge::camera
