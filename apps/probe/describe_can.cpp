// Who is on a CAN bus, in plain words.
#include <fmt/format.h>

#include "can_census.hpp"
#include "opcodes.h"

namespace eyebridge::apps {
namespace {

using namespace bridges;

std::string row(std::string_view name, const std::string& text) {
  return fmt::format("  {:<12} {}\n", name, text);
}

const char* state_text(const HeardRobot& robot, bool has_host) {
  switch (robot.state) {
    case EYECAN_STATE_BOOT:
      return "has just started";
    case EYECAN_STATE_STOPPED:
      return "stopped";
    case EYECAN_STATE_OPERATIONAL:
      return has_host ? "operational: a program drives it" : "operational";
    case EYECAN_STATE_STANDBY:
      return "standby: it waits for a program";
    default:
      return "unknown";
  }
}

std::string fault_text(const can::FaultStatus& fault) {
  switch (fault.code) {
    case EYECAN_FAULT_NONE:
      return "none";
    case EYECAN_FAULT_LOW_BATTERY:
      return "the battery is low";
    case EYECAN_FAULT_MOTOR_BLOCKED:
      return "a motor is blocked";
    case EYECAN_FAULT_HOST_LOST:
      return "its program is gone";
    case EYECAN_FAULT_BUS_OFF_RECOVERED:
      return "it had left the bus after too many errors";
    case EYECAN_FAULT_DUPLICATE_NODE:
      return "it hears another robot with its number";
    case EYECAN_FAULT_FRAME_LENGTH:
      return "it got a frame that is too short";
    case EYECAN_FAULT_BAD_VALUE:
      return "it got a value that it cannot take";
    case EYECAN_FAULT_ESTOP:
      return "emergency stop";
    case EYECAN_FAULT_COMMAND_TIMEOUT:
      return "commands stopped coming while it drove";
    default:
      return fmt::format("code {:04X}", fault.code);
  }
}

std::string devices(const HeardRobot& robot) {
  std::string out = robot.drives ? "v-omega drive" : "no drive";
  if (robot.has_encoders) out += ", encoders";
  if (!robot.psds.empty()) {
    out += ", PSD";
    for (const int number : robot.psds) out += fmt::format(" {}", number);
  }
  if (robot.lidar_points > 0) {
    out += fmt::format(", LIDAR of {} points{}", robot.lidar_points,
                       robot.sends_fd ? " (in CAN FD frames)" : "");
  }
  return out;
}

std::string version_text(const HeardRobot& robot) {
  if (!robot.version) return "not told (it is told every 5 s: --listen 6s)";
  const auto& v = *robot.version;
  std::string out = fmt::format("{}, protocol {}",
                                std::string_view(v.firmware.data(), v.firmware.size()), v.protocol);
  if (v.protocol != EYECAN_PROTOCOL_VERSION) {
    out += fmt::format(" (expected {}: what it says may be misread)", EYECAN_PROTOCOL_VERSION);
  }
  return out;
}

std::string robot_text(int node, const HeardRobot& robot, bool has_host,
                       const std::string& interface) {
  std::string out = fmt::format("robot {}\n", node);
  if (robot.twice) {
    out += row("TWICE", "two robots have this number; expected one: give one of them another");
  }
  out += row("state", state_text(robot, has_host));
  out += row("firmware", version_text(robot));
  if (robot.board && robot.board->battery_cv != EYECAN_ABSENT) {
    out += row("supply", fmt::format("{:.2f} V", robot.board->battery_cv / 100.0));
  }
  if (robot.board) {
    out += row("on for", fmt::format("{:.1f} s", robot.board->uptime_ds / 10.0));
  }
  out += row("fault", fault_text(robot.fault));
  out += row("devices", devices(robot));
  if (!robot.twice) {
    const char* fd = robot.sends_fd ? "&fd=1" : "";
    out += row("run",
               fmt::format("eyebridge run --hal 'can:{}?node={}{}' PROGRAM", interface, node, fd));
  }
  return out;
}

const char* state_name(bridges::CanState state) {
  switch (state) {
    case bridges::CanState::Active:
      return "error-active";
    case bridges::CanState::Warning:
      return "error-warning";
    case bridges::CanState::Passive:
      return "error-passive";
    case bridges::CanState::BusOff:
      return "bus-off";
  }
  return "";
}

}  // namespace

std::string described(const CanCensus& census, const std::string& interface) {
  const bool one = census.robots.size() == 1;
  std::string out = fmt::format("{} {} heard; {} frames, {} of them no EyeBot's, {} damaged\n",
                                census.robots.size(), one ? "robot" : "robots", census.frames,
                                census.foreign, census.corrupt);
  if (census.bus.error_frames > 0) {
    out += fmt::format(
        "the controller reports {} errors, {} of them frames that nobody "
        "acknowledged; it is {}\n",
        census.bus.error_frames, census.bus.no_ack, state_name(census.bus.state));
  }
  if (census.bus.dropped > 0) out += fmt::format("{} frames were lost here\n", census.bus.dropped);
  if (census.has_host) out += "another program commands robots on this bus\n";
  for (const auto& [node, robot] : census.robots) {
    out += robot_text(node, robot, census.has_host, interface);
  }
  return out;
}

}  // namespace eyebridge::apps
