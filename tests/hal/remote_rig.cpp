#include "remote_rig.hpp"

#include <array>
#include <stdexcept>

#include <sys/socket.h>

namespace eyebridge::hal {

std::pair<UniqueFd, UniqueFd> socket_pair() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw std::runtime_error("no pair of sockets");
  }
  return {UniqueFd(ends[0]), UniqueFd(ends[1])};
}

std::shared_ptr<const world::WorldModel> no_world() { return nullptr; }

ServedRobot::ServedRobot(Rig rig, UniqueFd line)
    : rig_(std::move(rig)), line_(std::move(line)), thread_([this] {
        RobotServer server(*rig_.backend, nullptr, line_.get());
        while (server.receive() && server.answer()) {
        }
      }) {}

ServedRobot::~ServedRobot() { end(); }

void ServedRobot::end() {
  if (!thread_.joinable()) return;
  shutdown(line_.get(), SHUT_RDWR);
  thread_.join();
}

RemoteRig remote_rig(const Pose& start, const std::map<std::string, std::string>& flags) {
  auto [program, server] = socket_pair();
  RemoteRig rig;
  rig.server = std::make_unique<ServedRobot>(sim_rig(start, flags), std::move(server));
  const auto world = [model = rig_scenario(start).world] {
    return std::make_shared<const world::WorldModel>(model);
  };
  const auto factor = flags.find("factor");
  rig.robot = make_remote_robot(std::move(program), world,
                                factor == flags.end() ? 1.0 : std::stod(factor->second));
  return rig;
}

}  // namespace eyebridge::hal
