#include "room.hpp"

#include "eyebridge/hal/registry.hpp"

namespace eyebridge::gui::testing {

Room::Room(const std::string& lines) {
  folder_.write(
      "room.wld",
      std::string("floor 2000 1000\n0 0 2000 0\n2000 0 2000 1000\n2000 1000 0 1000\n0 1000 0 0\n") +
          lines);
  const std::string sim =
      folder_.write("room.sim", "world room.wld\nS4 500 500 0\nS4 1500 500 180\nCan 1000 200 0\n");
  const hal::Config config = hal::Config::load({{{"world", sim}, {"fast", "true"}}, {}, {}});
  backend_ = hal::open_backend({config, log_});
}

Pose Room::pose(int robot) { return environment().control().robot_pose(robot).value(); }

void Room::pass(double seconds) {
  backend_->clock().wait_until(backend_->clock().now() + from_seconds(seconds));
}

}  // namespace eyebridge::gui::testing
