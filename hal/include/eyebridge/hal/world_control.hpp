#pragma once

#include <string>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"

namespace eyebridge::world {
struct ObjectSpec;
}

namespace eyebridge::hal {

/// The hand of God: what only a simulated world can do. Behind the SIM* calls, tests and windows;
/// robot programs that use it do not run on a real robot.
///
/// Poses are in the world, metres and radians. The backend owns it; any thread.
class WorldControl {
 public:
  virtual ~WorldControl() = default;

  /// With those that were removed, whose ids are not there any more.
  [[nodiscard]] virtual int robot_count() const = 0;
  /// Of balls, cans, boxes and polygons, with those that were removed.
  [[nodiscard]] virtual int object_count() const = 0;
  // Ids from 1, in the order of the scenario; robot 0 is the caller's own. An id that is not there
  // and a pose that is not finite are OutOfRange.
  virtual Result<Pose> robot_pose(int id) const = 0;
  virtual Result<void> set_robot_pose(int id, const Pose& pose) = 0;
  /// How far the underside of a submarine is above the floor, metres; 0 of other robots.
  virtual Result<double> robot_altitude(int id) const = 0;
  /// Moves a submarine up or down, clamped to the water; other robots stay on the floor. Metres;
  /// what is not finite is OutOfRange.
  virtual Result<void> set_robot_altitude(int id, double altitude) = 0;
  virtual Result<Pose> object_pose(int id) const = 0;
  virtual Result<void> set_object_pose(int id, const Pose& pose) = 0;
  /// Adds an object to the world as it is now; its id, the next one. OutOfRange, in words, for one
  /// that cannot be or would stand in something.
  virtual Result<int> add_object(const world::ObjectSpec& object) = 0;
  /// Takes an object away for good: its id is not there any more.
  virtual Result<void> remove_object(int id) = 0;
  /// Metres per second, of what rolls or slides by itself: OutOfRange for others.
  virtual Result<void> set_object_velocity(int id, Vec2 velocity) = 0;
  /// Whether nothing pushes it away from now on. OutOfRange for what moves by itself.
  virtual Result<void> set_object_fixed(int id, bool fixed) = 0;
  /// Changes how an object behaves: `lines` are those that may follow its line in a `.sim` file
  /// ("mass 2", "path 100 loop 500 500"). OutOfRange, in words, for what cannot be.
  virtual Result<void> change_object(int id, const std::string& lines) = 0;
  /// Does to the errors that robot `id` has now what `rules` say, written as the setting `errors`
  /// ("realistic", "psd:1 dropout=5%"; robot:N not), then scales them by `share`, 0 … 1. Rules
  /// that are wrong are OutOfRange, too, and change nothing.
  virtual Result<void> set_errors(int id, const std::string& rules, double share) = 0;
};

}  // namespace eyebridge::hal
