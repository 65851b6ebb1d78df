#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "eyebridge/base/log.hpp"
#include "eyebridge/files/scenario.hpp"
#include "eyebridge/hal/backend.hpp"
#include "eyebridge/hal/config.hpp"
#include "rig_traits.hpp"

namespace eyebridge::hal {

/// The value; throws the error's text where there is none.
template <class Value>
Value must(Result<Value> result) {
  if (!result) throw std::runtime_error(result.error().what);
  return std::move(*result);
}

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

/// Where the robot stands that faces a wall `wall` metres ahead of its front sensor, looking
/// along +x.
Pose facing(double wall);
/// The robot at `start` in a room with a wall across it; another robot and a ball lie behind that
/// wall, out of sight.
files::Scenario rig_scenario(const Pose& start);
inline files::Scenario rig_scenario(double wall) { return rig_scenario(facing(wall)); }

/// The configuration "key=value" by "key=value".
Config rig_config(const std::map<std::string, std::string>& flags);

/// Where a robot and the camera on it truly are.
struct Truth {
  Pose pose;
  double pan = 0.0;   ///< Of the camera in the robot, radians, left positive.
  double tilt = 0.0;  ///< Radians, up positive.
};

/// A backend with a robot at a known place.
struct Rig {
  std::unique_ptr<KeepingLog> log;  ///< Outlives the backend.
  std::shared_ptr<void> other_end;  ///< Of a board's line; likewise.
  std::unique_ptr<Backend> backend;
  std::function<Truth()> truth;  ///< Nothing where nobody knows.
  std::function<void()> unplug;  ///< Takes the robot's line away; nothing where there is none.

  /// Lets `seconds` of the robot's clock pass.
  void wait(double seconds) const;
  /// Waits until the movement has ended, or a minute; what the drive says then.
  DriveStatus wait_for_drive() const;
};

/// What a simulated robot's own devices tell; `robot` must outlive it.
std::function<Truth()> truth_of(Backend& robot);
/// The simulation, configured by `flags`.
Rig sim_rig(const Pose& start, const std::map<std::string, std::string>& flags);
/// In virtual time.
Rig lockstep_rig(const Pose& start);

/// One row of the contract.
struct RigCase {
  std::string name;
  std::function<Rig(const Pose& start)> make;
  RigTraits traits;
  /// Each test runs twice: on `make`, recorded, then on the recordings.
  bool replayed = false;
};
void PrintTo(const RigCase& rig, std::ostream* out);

/// The rows of this test program: sim_rows.cpp, memory_rows.cpp, line_rows.cpp. A backend without
/// one does not exist.
std::vector<RigCase> contract_rows();

}  // namespace eyebridge::hal
