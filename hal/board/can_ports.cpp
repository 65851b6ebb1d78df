// C_Digital, C_DigitalCfg, S_Digital, S_Analog…, S_Status and S_Version: a robot's ports on CAN.
#include <string>

#include "board/can_link.hpp"

namespace eyebridge::hal {
namespace {

namespace can = bridges::can;

constexpr double kCanCentivolts = 100;

std::uint8_t code_of(LineMode mode) {
  switch (mode) {
    case LineMode::Input:
      return EYECAN_PORT_INPUT;
    case LineMode::Output:
      return EYECAN_PORT_OUTPUT;
    case LineMode::PullUp:
      return EYECAN_PORT_PULL_UP;
    case LineMode::PullDown:
      return EYECAN_PORT_PULL_DOWN;
  }
  return EYECAN_PORT_INPUT;
}

Result<int> measured(std::uint16_t value, const char* what) {
  if (value != EYECAN_ABSENT) return value;
  return fail(Errc::Unsupported, std::string("the robot does not measure ") + what);
}

}  // namespace

Result<void> CanLink::digital_setup(int port, LineMode mode) {
  return client_->say(can::PortCommand{static_cast<std::uint8_t>(port), code_of(mode)});
}

Result<bool> CanLink::digital_in(int port) {
  return digital_in_all().map([&](unsigned bits) { return (bits >> port & 1U) != 0; });
}

Result<std::uint16_t> CanLink::digital_in_all() {
  return client_->latest<can::DigitalStatus>().map(
      [](const can::DigitalStatus& status) { return status.in; });
}

Result<void> CanLink::digital_out(int port, bool high) {
  const auto bit = static_cast<std::uint16_t>(1U << port);
  return client_->say(can::DigitalCommand{bit, high ? bit : std::uint16_t{0}});
}

Result<int> CanLink::analog(int channel) {
  const auto index = static_cast<std::size_t>(channel);
  const std::string what = "analog channel " + std::to_string(channel);
  if (channel < 4) {
    return client_->latest<can::AnalogAStatus>().and_then([&](const can::AnalogAStatus& status) {
      return measured(status.raw[index], what.c_str());
    });
  }
  if (channel < 8) {
    return client_->latest<can::AnalogBStatus>().and_then([&](const can::AnalogBStatus& status) {
      return measured(status.raw[index - 4], what.c_str());
    });
  }
  return client_->latest<can::BoardStatus>().and_then(
      [](const can::BoardStatus& status) { return measured(status.microphone, "a microphone"); });
}

Result<double> CanLink::supply_voltage() {
  return client_->latest<can::BoardStatus>()
      .and_then([](const can::BoardStatus& status) {
        return measured(status.battery_cv, "its supply voltage");
      })
      .map([](int value) { return value / kCanCentivolts; });
}

Result<std::string> CanLink::version() {
  return client_->latest<can::VersionStatus>().map([](const can::VersionStatus& status) {
    return std::string(status.firmware.data(), status.firmware.size());
  });
}

Result<int> CanLink::remote_key() {
  return client_->latest<can::BoardStatus>().map(
      [](const can::BoardStatus& status) -> int { return status.ir_key; });
}

}  // namespace eyebridge::hal
