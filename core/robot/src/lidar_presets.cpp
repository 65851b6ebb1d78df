#include "eyebridge/robot/lidar_presets.hpp"

#include "eyebridge/base/units.hpp"

namespace eyebridge::robot {
namespace {

LidarModel scanner(int points, double degrees, double max_range, double sigma, double relative) {
  LidarModel model;
  model.points = points;
  model.field_of_view = deg_to_rad(degrees);
  model.max_range = max_range;
  model.error.sigma = sigma;
  model.error.sigma_relative = relative;
  return model;
}

}  // namespace

std::optional<LidarModel> lidar_preset(std::string_view name) {
  if (name == "LMS200") return scanner(361, 180, 8.0, 0.005, 0.0);
  if (name == "LMS200-1") return scanner(181, 180, 8.0, 0.005, 0.0);
  // Three sigma are some 10 mm near by and 1 % of 4 m.
  if (name == "URG-04LX") return scanner(683, 682 * 360.0 / 1024, 4.0, 0.003, 0.0025);
  if (name == "RPLIDAR-A1") return scanner(360, 360, 12.0, 0.0, 0.0033);
  return std::nullopt;
}

}  // namespace eyebridge::robot
