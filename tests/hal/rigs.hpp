#pragma once

#include <memory>
#include <mutex>
#include <ostream>
#include <string>
#include <vector>

#include "eyebridge/base/log.hpp"
#include "eyebridge/files/scenario.hpp"
#include "eyebridge/hal/backend.hpp"
#include "eyebridge/hal/config.hpp"

namespace eyebridge::hal {

/// Keeps what was logged.
class KeepingLog final : public LogSink {
 public:
  void write(Severity severity, std::string_view message) override;
  /// Messages of `severity` so far.
  std::vector<std::string> messages(Severity severity) const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::pair<Severity, std::string>> messages_;
};

/// The robot of all rigs: every kind of device, no errors.
///
/// Range sensors: 1 front, 2 left, 3 right, 4 front with a reach of kShortReach.
robot::RobotModel rig_model();
inline constexpr double kShortReach = 0.3;    ///< Metres.
inline constexpr double kThreshold = 0.15;    ///< Of the proximity switch, metres.
inline constexpr double kSideWall = 1.0;      ///< From the robot's centre to either side, metres.
inline constexpr double kFrontOffset = 0.08;  ///< From the robot's centre to the front sensor.

/// A robot that faces a wall `wall` metres ahead of its front sensor, looking along +x; another
/// robot and a ball lie behind that wall, out of sight.
files::Scenario rig_scenario(double wall);

/// The configuration "key=value" by "key=value".
Config rig_config(const std::map<std::string, std::string>& flags);

/// A backend with a robot that faces a wall at a known distance.
struct Rig {
  std::unique_ptr<KeepingLog> log;  ///< Outlives the backend.
  std::unique_ptr<Backend> backend;

  /// Lets `seconds` of the robot's clock pass.
  void wait(double seconds) const;
  /// Waits until the movement has ended, or a minute; what the drive says then.
  DriveStatus wait_for_drive() const;
};

/// One row of the contract.
struct RigCase {
  std::string name;
  Rig (*make)(double wall);
  double range_tolerance;  ///< Of a range sensor, metres.
  double drive_tolerance;  ///< Of a finished movement, metres and radians.
};
void PrintTo(const RigCase& rig, std::ostream* out);

/// All rows: a backend without one does not exist.
std::vector<RigCase> all_rigs();

}  // namespace eyebridge::hal
