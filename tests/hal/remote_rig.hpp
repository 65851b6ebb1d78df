#pragma once

#include <memory>
#include <thread>
#include <utility>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/hal/robot_server.hpp"
#include "remote_robot/remote_robot.hpp"
#include "rigs.hpp"

namespace eyebridge::hal {

/// Both ends of a line between two processes; here in one.
std::pair<UniqueFd, UniqueFd> socket_pair();

/// For robots whose camera nobody asks.
std::shared_ptr<const world::WorldModel> no_world();

/// A robot at its server, which a thread of its own answers for.
class ServedRobot {
 public:
  ServedRobot(Rig rig, UniqueFd line);
  ~ServedRobot();
  ServedRobot(const ServedRobot&) = delete;
  ServedRobot& operator=(const ServedRobot&) = delete;
  /// Closes the line.
  void end();

 private:
  Rig rig_;
  UniqueFd line_;
  std::thread thread_;
};

/// A server and its program's end.
struct RemoteRig {
  std::unique_ptr<ServedRobot> server;
  std::unique_ptr<Backend> robot;

  void end() const { server->end(); }
};

RemoteRig remote_rig(const Pose& start,
                     const std::map<std::string, std::string>& flags = {{"fast", "true"}});

}  // namespace eyebridge::hal
