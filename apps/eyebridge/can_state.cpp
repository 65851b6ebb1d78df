#include "can_state.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <linux/can.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

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

Finding judge_interfaces(const std::vector<CanInterface>& interfaces) {
  if (interfaces.empty()) {
    return {kInterfaces, false, false, "there is none: " + numbered(ENODEV),
            "plug an adapter in, or as root: ip link add vcan0 type vcan && ip link set vcan0 up"};
  }
  std::string names;
  std::string down;
  for (const CanInterface& interface : interfaces) {
    names += (names.empty() ? "" : " ") + interface.name + (interface.up ? "" : " (down)");
    if (!interface.up && down.empty()) down = interface.name;
  }
  const bool any_up = std::any_of(interfaces.begin(), interfaces.end(),
                                  [](const CanInterface& interface) { return interface.up; });
  std::string remedy;
  if (!any_up) {
    remedy = "as root: ip link set " + down + " up";
    if (!down.starts_with("v")) remedy += " type can bitrate 500000";
  }
  return {kInterfaces, false, any_up, names, remedy};
}

}  // namespace

CanState look_at_can() {
  namespace fs = std::filesystem;
  constexpr int kIsoTpProtocol = 6;  // CAN_ISOTP; older headers lack it
  constexpr int kCanHardware = 280;  // ARPHRD_CAN of linux/if_arp.h
  CanState out;
  out.raw_error = error_of_socket(SOCK_RAW, CAN_RAW);
  out.isotp_error = error_of_socket(SOCK_DGRAM, kIsoTpProtocol);
  std::error_code error;
  for (fs::directory_iterator at("/sys/class/net", error), end; !error && at != end;
       at.increment(error)) {
    int type = 0;
    std::ifstream(at->path() / "type") >> type;
    if (type != kCanHardware) continue;
    std::string flags;
    std::ifstream(at->path() / "flags") >> flags;
    out.interfaces.push_back(
        {at->path().filename(), (std::strtoul(flags.c_str(), nullptr, 16) & IFF_UP) != 0});
  }
  std::sort(out.interfaces.begin(), out.interfaces.end(),
            [](const CanInterface& a, const CanInterface& b) { return a.name < b.name; });
  return out;
}

std::vector<Finding> judge_can(const CanState& state) {
  std::vector<Finding> out = {judge_raw(state.raw_error)};
  if (state.raw_error != 0) return out;
  out.push_back(judge_isotp(state.isotp_error));
  out.push_back(judge_interfaces(state.interfaces));
  return out;
}

}  // namespace eyebridge::apps
