#pragma once

#include <vector>

#include "eyebridge/camera/devices.hpp"
#include "v4l2/video_handle.hpp"

namespace eyebridge::camera {

/// All formats of an open camera with their sizes and rates, as the driver lists them.
std::vector<OfferedFormat> offers_of(const VideoHandle& camera);

/// The rates of one size, frames a second, highest first; empty where the driver is silent.
std::vector<double> rates_of(const VideoHandle& camera, std::uint32_t fourcc, Size size);

}  // namespace eyebridge::camera
