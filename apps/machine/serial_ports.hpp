#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "device_access.hpp"
#include "finding.hpp"
#include "system_files.hpp"

namespace eyebridge::apps {

/// A serial port that a board may be on, and who may use it.
struct SerialPort {
  std::string device;              ///< "/dev/ttyACM0"
  std::string by_id;               ///< "/dev/serial/by-id/usb-…", which stays the same; or "".
  std::string driver;              ///< "cdc_acm"; "" when it is not known.
  std::string product;             ///< "Interface Board (03eb:2404)"; or "".
  DeviceAccess access;             ///< Who may use it.
  std::optional<long> latency_ms;  ///< What an FTDI adapter waits before it passes bytes on.
  std::vector<Process> holders;    ///< Who has it open, or locked.
  bool hidden_from_modem_manager = false;  ///< By a udev rule.
};

/// Everything about serial ports on this machine.
struct SerialState {
  std::vector<SerialPort> ports;
  std::optional<Process> modem_manager;  ///< It opens new ports and sends AT commands to them.
};

/// Looks at ttyACM*, ttyUSB* and ttyAMA* of /dev, and what /sys, /proc, /run/udev and /etc/group
/// below `root` say about them. Changes nothing, opens no port.
SerialState look_at_serial(const std::filesystem::path& root = "/");

/// One such port, or another terminal, whatever its name. Its device must exist.
SerialPort look_at_port(const std::string& device, const std::filesystem::path& root = "/");

/// One finding for all ports and one more for each.
std::vector<Finding> judge_serial(const SerialState& state);

/// The one for `port`.
Finding judge_port(const SerialPort& port, const SerialState& state);

/// One line about a port: "Interface Board (03eb:2404), driver cdc_acm".
std::string described(const SerialPort& port);

/// How to be allowed to open `port`: one sentence.
std::string how_to_be_permitted(const SerialPort& port);

}  // namespace eyebridge::apps
