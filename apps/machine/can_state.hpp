#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "can_links.hpp"
#include "finding.hpp"

namespace eyebridge::apps {

/// A CAN interface of this machine.
struct CanInterface {
  std::string name;
  bool up = false;
  long queue = 0;         ///< Frames that wait to be sent before programs are told "no room".
  bool takes_fd = false;  ///< Set up for CAN FD: its MTU is 72.
  std::optional<CanLink> link = {};  ///< What its driver says, where that could be asked.
};

/// What the kernel says to whoever wants CAN: error numbers of opening sockets, 0 where it works.
struct CanState {
  int raw_error = 0;
  int isotp_error = 0;
  std::vector<CanInterface> interfaces;
};

/// Asks the kernel; changes nothing.
CanState look_at_can();

/// The CAN interfaces that /sys/class/net below `root` lists, by name, each with the one of `links`
/// that has its name.
std::vector<CanInterface> can_interfaces(const std::filesystem::path& root,
                                         const std::vector<CanLink>& links);

/// One finding each for CAN itself, ISO-TP and the interfaces, with what to do, and one more for
/// each interface whose driver told something; what cannot be there without something above it is
/// left out.
std::vector<Finding> judge_can(const CanState& state);

/// One line about an interface: "500 kbit/s, error-active, …".
std::string described(const CanInterface& interface);

/// What stands in the way of a program that wants to use the interface `name`: found and expected,
/// with what to do; "" when nothing does. A missing kernel part comes first: 97 (no CAN), 93 (no
/// raw sockets), then 19 (no such interface), then one that is down.
std::string why_no_can(const CanState& state, const std::string& name);

}  // namespace eyebridge::apps
