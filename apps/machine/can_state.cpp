#include "can_state.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>
#include <linux/can.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include "system_files.hpp"

namespace eyebridge::apps {
namespace {

int error_of_socket(int type, int protocol) {
  const int descriptor = socket(PF_CAN, type | SOCK_CLOEXEC, protocol);
  if (descriptor < 0) return errno;
  close(descriptor);
  return 0;
}

std::string numbered(int error) {
  return std::string(std::strerror(error)) + " (errno " + std::to_string(error) + ")";
}

constexpr const char* kCan = "CAN";
constexpr const char* kIsoTp = "CAN ISO-TP";
constexpr const char* kInterfaces = "CAN interfaces";

Finding judge_raw(int error) {
  if (error == 0) return {kCan, false, true, "SocketCAN", ""};
  if (error == EAFNOSUPPORT) {
    return {kCan, false, false, "this kernel has no CAN: " + numbered(error),
            "as root: modprobe can_raw; where the kernel has none: eyebridge lab -- PROGRAM"};
  }
  if (error == EPROTONOSUPPORT) {
    return {kCan, false, false, "this kernel has CAN, but no raw sockets: " + numbered(error),
            "as root: modprobe can_raw"};
  }
  return {kCan, false, false, "sockets cannot be opened: " + numbered(error),
          "a container may forbid it: try outside of it"};
}

Finding judge_isotp(int error) {
  if (error == 0) return {kIsoTp, false, true, "for long messages", ""};
  return {kIsoTp, false, false, "this kernel has CAN, but no ISO-TP: " + numbered(error),
          "as root: modprobe can_isotp (Linux 5.10 or newer); driving needs none"};
}

/// As root: how to get `name` up.
std::string how_to_set_up(const std::string& name, bool is_virtual) {
  return "ip link set " + name + " up" + (is_virtual ? "" : " type can bitrate 500000");
}

bool is_virtual(const CanInterface& interface) {
  return interface.link ? interface.link->kind != "can" : interface.name.starts_with("v");
}

Finding judge_interfaces(const std::vector<CanInterface>& interfaces) {
  if (interfaces.empty()) {
    return {kInterfaces, false, false, "there is none: " + numbered(ENODEV),
            "plug an adapter in, or as root: ip link add vcan0 type vcan && ip link set vcan0 up"};
  }
  std::string names;
  for (const CanInterface& interface : interfaces) {
    names += (names.empty() ? "" : " ") + interface.name + (interface.up ? "" : " (down)");
  }
  const bool any_up = std::any_of(interfaces.begin(), interfaces.end(),
                                  [](const CanInterface& interface) { return interface.up; });
  const CanInterface& first = interfaces.front();
  return {kInterfaces, false, any_up, names,
          any_up ? "" : "as root: " + how_to_set_up(first.name, is_virtual(first))};
}

constexpr const char* kSettle =
    "expected the same bit rate at all nodes, one 120 ohm resistor at each end of the bus, CAN-H "
    "and CAN-L not swapped, and at least one other node that is switched on";

void advise_on_state(const std::string& name, const CanLink& link, Finding& out) {
  switch (link.state.value_or(BusState::ErrorActive)) {
    case BusState::ErrorActive:
    case BusState::Stopped:
    case BusState::Sleeping:
      break;
    case BusState::ErrorWarning:
    case BusState::ErrorPassive:
      out.advice.push_back(fmt::format("frames get damaged: {}", kSettle));
      break;
    case BusState::BusOff:
      out.found = false;
      out.remedy = "as root, once the bus is in order: ip link set " + name + " type can restart";
      out.advice.push_back(fmt::format("it gave up: {}", kSettle));
      break;
  }
}

Finding judge_link(const CanInterface& interface) {
  const std::string& name = interface.name;
  const CanLink& link = *interface.link;
  Finding out{"  " + name, false, interface.up, described(interface), ""};
  if (!interface.up) out.remedy = "as root: " + how_to_set_up(name, is_virtual(interface));
  advise_on_state(name, link, out);
  if (link.listen_only) {
    out.advice.emplace_back("it only listens: nothing can be sent; as root: ip link set " + name +
                            " type can listen-only off (while it is down)");
  }
  if (link.termination_ohm == 0) {
    out.advice.emplace_back(
        "its own termination is off: right only if it is not at an end of the bus");
  }
  if (is_virtual(interface)) return out;
  if (link.restart_ms == 0) {
    out.advice.push_back("it stays away after a bus-off; as root: ip link set " + name +
                         " type can restart-ms 100 (while it is down)");
  }
  constexpr long kSmallQueue = 100;
  if (interface.queue < kSmallQueue) {
    out.advice.push_back(
        fmt::format("its queue holds {} frames only; as root: ip link set {} "
                    "txqueuelen 1000",
                    interface.queue, name));
  }
  return out;
}

}  // namespace

std::string described(const CanInterface& interface) {
  const CanLink link = interface.link.value_or(CanLink{});
  std::string out = is_virtual(interface) ? "virtual, no wire" : "";
  const auto add = [&out](const std::string& part) { out += (out.empty() ? "" : ", ") + part; };
  if (link.bit_rate && *link.bit_rate > 0) {
    std::string rate = fmt::format("{:g} kbit/s", *link.bit_rate / 1000.0);
    if (link.data_bit_rate && *link.data_bit_rate > 0) {
      rate += fmt::format(" (data {:g})", *link.data_bit_rate / 1000.0);
    }
    add(rate);
  } else if (!is_virtual(interface)) {
    add("no bit rate yet");
  }
  if (link.state) add(name_of(*link.state));
  if (link.send_errors && *link.send_errors + *link.receive_errors > 0) {
    add(fmt::format("error counters {} out, {} in", *link.send_errors, *link.receive_errors));
  }
  if (link.bus_offs && *link.bus_offs > 0) add(fmt::format("{} times bus-off", *link.bus_offs));
  if (link.termination_ohm) add(fmt::format("termination {} ohm", *link.termination_ohm));
  add(interface.takes_fd ? "CAN FD" : "classic CAN");
  add(fmt::format("queue of {}", interface.queue));
  if (!interface.up) add("down");
  return out;
}

std::vector<CanInterface> can_interfaces(const std::filesystem::path& root,
                                         const std::vector<CanLink>& links) {
  constexpr long kCanHardware = 280;  // ARPHRD_CAN of linux/if_arp.h
  const std::filesystem::path net = below(root, "/sys/class/net");
  std::vector<CanInterface> out;
  for (const std::string& name : names_in(net)) {
    if (number_of(net / name / "type") != kCanHardware) continue;
    CanInterface& interface = out.emplace_back();
    interface.name = name;
    const std::string flags = line_of(net / name / "flags").value_or("");
    interface.up = (std::strtoul(flags.c_str(), nullptr, 16) & IFF_UP) != 0;
    interface.queue = number_of(net / name / "tx_queue_len").value_or(0);
    interface.takes_fd = number_of(net / name / "mtu").value_or(0) >= long{CANFD_MTU};
    for (const CanLink& link : links) {
      if (link.name == name) interface.link = link;
    }
  }
  return out;
}

CanState look_at_can() {
  constexpr int kIsoTpProtocol = 6;  // CAN_ISOTP; older headers lack it
  return {error_of_socket(SOCK_RAW, CAN_RAW), error_of_socket(SOCK_DGRAM, kIsoTpProtocol),
          can_interfaces("/", ask_can_links())};
}

std::vector<Finding> judge_can(const CanState& state) {
  std::vector<Finding> out = {judge_raw(state.raw_error)};
  if (state.raw_error != 0) return out;
  out.push_back(judge_isotp(state.isotp_error));
  out.push_back(judge_interfaces(state.interfaces));
  for (const CanInterface& interface : state.interfaces) {
    if (interface.link) out.push_back(judge_link(interface));
  }
  return out;
}

std::string why_no_can(const CanState& state, const std::string& name) {
  if (state.raw_error != 0) {
    const Finding finding = judge_raw(state.raw_error);
    return finding.detail + "; " + finding.remedy;
  }
  std::string others;
  for (const CanInterface& interface : state.interfaces) {
    if (interface.name != name) {
      others += (others.empty() ? "" : ", ") + interface.name;
      continue;
    }
    if (interface.up) return "";
    return "the interface is down; as root: " + how_to_set_up(name, is_virtual(interface));
  }
  return "no such CAN interface: " + numbered(ENODEV) + "; expected " +
         (others.empty() ? "an adapter that is plugged in, or as root: ip link add vcan0 type vcan"
                         : "one of " + others);
}

}  // namespace eyebridge::apps
