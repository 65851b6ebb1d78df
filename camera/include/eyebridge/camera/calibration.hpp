#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// How a camera's lens maps rays to pixels, as `eyebridge camera calibrate` measures it.
///
/// The pinhole model with radial and tangential distortion (Brown 1966; the names and the order of
/// OpenCV): x right, y down, z along the axis; pixel (0, 0) is the centre of the top left pixel.
struct Calibration {
  Size size;                           ///< Of the pictures that it was measured with, pixels.
  double fx = 0.0, fy = 0.0;           ///< Focal lengths, pixels; > 0.
  double cx = 0.0, cy = 0.0;           ///< Where the axis meets the picture, pixels.
  std::array<double, 5> distortion{};  ///< k1, k2, p1, p2, k3.
  double error = 0.0;  ///< Root mean square of the reprojection error when it was measured, pixels.

  friend bool operator==(const Calibration&, const Calibration&) = default;
};

/// A lens without distortion, square pixels, the axis in the middle; field of view in radians.
Calibration pinhole(Size size, double horizontal_field_of_view);

/// The same lens with pictures of another size of the same aspect, or cut about their middle to
/// another aspect as fit() does it. Throws std::invalid_argument for an empty size.
Calibration scaled(const Calibration& calibration, Size size);

/// Reads to_toml()'s text, or a calibration as ROS (`ost.yaml`) or OpenCV writes it in YAML or
/// XML, named `file` in messages. Throws ConfigError with line and column (of XML: where it is not
/// well-formed).
Calibration parse_calibration(std::string_view text, const std::string& file);

/// `calibration` as TOML; parse_calibration() gives the same back.
std::string to_toml(const Calibration& calibration);

/// The same of a file. Throws ConfigError with line and column.
Calibration read_calibration(const std::filesystem::path& path);

/// That write_calibration() may write there: nothing, or an earlier calibration of ours. Throws
/// ConfigError without a place.
void check_calibration_place(const std::filesystem::path& path);

/// Throws std::runtime_error naming the file and the reason.
void write_calibration(const Calibration& calibration, const std::filesystem::path& path);

}  // namespace eyebridge::camera
