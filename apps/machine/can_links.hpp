#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace eyebridge::apps {

/// How the controller of a CAN interface stands (linux/can/netlink.h).
enum class BusState { ErrorActive, ErrorWarning, ErrorPassive, BusOff, Stopped, Sleeping };

/// What the kernel's driver says about one CAN interface: empty where it says nothing, as vcan,
/// which has no bus.
struct CanLink {
  std::string name;
  std::string kind;  ///< "can" for adapters and controllers, "vcan", "vxcan".
  std::optional<BusState> state;
  std::optional<std::uint32_t> bit_rate;         ///< Bits per second.
  std::optional<std::uint32_t> data_bit_rate;    ///< Of the data of CAN FD frames.
  std::optional<std::uint32_t> restart_ms;       ///< After a bus-off; 0: never by itself.
  std::optional<std::uint16_t> termination_ohm;  ///< That the adapter can switch; 0: off.
  std::optional<std::uint16_t> send_errors;      ///< Error counters of the controller, 0 … 255.
  std::optional<std::uint16_t> receive_errors;
  std::optional<std::uint32_t> bus_errors;  ///< Since the interface is there …
  std::optional<std::uint32_t> bus_offs;    ///< … and so many of these.
  bool listen_only = false;
  bool fd_on = false;  ///< CAN FD is switched on.

  friend bool operator==(const CanLink&, const CanLink&) = default;
};

/// The CAN interfaces in the kernel's answer to a dump of all links: netlink messages RTM_NEWLINK
/// (rtnetlink(7)). What is cut off or odd is skipped. Pure.
std::vector<CanLink> read_can_links(std::span<const std::byte> answer);

/// Asks this machine's kernel. Empty when it does not answer. Needs no privilege.
std::vector<CanLink> ask_can_links();

/// "error-passive"
const char* name_of(BusState state);

}  // namespace eyebridge::apps
