#include "can_links.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include <linux/can/netlink.h>
#include <linux/if_arp.h>
#include <linux/rtnetlink.h>
#include <sys/socket.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::apps {
namespace {

using Bytes = std::span<const std::byte>;

/// A value of a C struct from the first bytes; nothing when there are too few.
template <class T>
std::optional<T> as(Bytes bytes) {
  T value{};
  if (bytes.size() < sizeof value) return std::nullopt;
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

std::string text_in(Bytes bytes) {
  const auto* begin = reinterpret_cast<const char*>(bytes.data());
  return {begin, ::strnlen(begin, bytes.size())};
}

/// Calls `take(type, payload)` for each attribute.
template <class Take>
void for_attributes(Bytes bytes, Take&& take) {
  while (const auto head = as<rtattr>(bytes)) {
    if (head->rta_len < sizeof *head || head->rta_len > bytes.size()) return;
    take(head->rta_type & NLA_TYPE_MASK, bytes.subspan(sizeof *head, head->rta_len - sizeof *head));
    bytes = bytes.subspan(std::min<std::size_t>(RTA_ALIGN(head->rta_len), bytes.size()));
  }
}

/// Calls `take(type, payload)` for each message.
template <class Take>
void for_messages(Bytes bytes, Take&& take) {
  while (const auto head = as<nlmsghdr>(bytes)) {
    if (head->nlmsg_len < sizeof *head || head->nlmsg_len > bytes.size()) return;
    take(head->nlmsg_type, bytes.subspan(sizeof *head, head->nlmsg_len - sizeof *head));
    bytes = bytes.subspan(std::min<std::size_t>(NLMSG_ALIGN(head->nlmsg_len), bytes.size()));
  }
}

void read_details(Bytes bytes, CanLink& link) {
  for_attributes(bytes, [&](int type, Bytes value) {
    switch (type) {
      case IFLA_CAN_STATE:
        if (const auto state = as<std::uint32_t>(value);
            state && *state <= static_cast<std::uint32_t>(BusState::Sleeping)) {
          link.state = static_cast<BusState>(*state);
        }
        break;
      case IFLA_CAN_BITTIMING:
        if (const auto timing = as<can_bittiming>(value)) link.bit_rate = timing->bitrate;
        break;
      case IFLA_CAN_DATA_BITTIMING:
        if (const auto timing = as<can_bittiming>(value)) link.data_bit_rate = timing->bitrate;
        break;
      case IFLA_CAN_RESTART_MS:
        link.restart_ms = as<std::uint32_t>(value);
        break;
      case IFLA_CAN_TERMINATION:
        link.termination_ohm = as<std::uint16_t>(value);
        break;
      case IFLA_CAN_BERR_COUNTER:
        if (const auto counter = as<can_berr_counter>(value)) {
          link.send_errors = counter->txerr;
          link.receive_errors = counter->rxerr;
        }
        break;
      case IFLA_CAN_CTRLMODE:
        if (const auto mode = as<can_ctrlmode>(value)) {
          link.listen_only = (mode->flags & CAN_CTRLMODE_LISTENONLY) != 0;
          link.fd_on = (mode->flags & CAN_CTRLMODE_FD) != 0;
        }
        break;
      default:
        break;
    }
  });
}

void read_info(Bytes bytes, CanLink& link) {
  for_attributes(bytes, [&](int type, Bytes value) {
    if (type == IFLA_INFO_KIND) link.kind = text_in(value);
    if (type == IFLA_INFO_DATA) read_details(value, link);
    if (type != IFLA_INFO_XSTATS) return;
    if (const auto counts = as<can_device_stats>(value)) {
      link.bus_errors = counts->bus_error;
      link.bus_offs = counts->bus_off;
    }
  });
}

}  // namespace

std::vector<CanLink> read_can_links(Bytes answer) {
  std::vector<CanLink> out;
  for_messages(answer, [&](int type, Bytes message) {
    const auto info = as<ifinfomsg>(message);
    if (type != RTM_NEWLINK || !info || info->ifi_type != ARPHRD_CAN) return;
    CanLink link;
    for_attributes(message.subspan(sizeof *info), [&](int attribute, Bytes value) {
      if (attribute == IFLA_IFNAME) link.name = text_in(value);
      if (attribute == IFLA_LINKINFO) read_info(value, link);
    });
    if (!link.name.empty()) out.push_back(std::move(link));
  });
  return out;
}

std::vector<CanLink> ask_can_links() {
  const UniqueFd socket(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE));
  struct {
    nlmsghdr head;
    ifinfomsg info;
  } request{};
  request.head.nlmsg_len = sizeof request;
  request.head.nlmsg_type = RTM_GETLINK;
  request.head.nlmsg_flags = NLM_F_REQUEST | NLM_F_DUMP;
  if (!socket.valid() || ::send(socket.get(), &request, sizeof request, 0) < 0) return {};
  std::vector<CanLink> out;
  std::array<std::byte, 65536> buffer;
  while (true) {
    const ssize_t count = ::recv(socket.get(), buffer.data(), buffer.size(), 0);
    if (count <= 0) return out;
    const Bytes answer(buffer.data(), static_cast<std::size_t>(count));
    for (CanLink& link : read_can_links(answer)) out.push_back(std::move(link));
    bool last = false;
    for_messages(
        answer, [&](int type, Bytes) { last = last || type == NLMSG_DONE || type == NLMSG_ERROR; });
    if (last) return out;
  }
}

const char* name_of(BusState state) {
  switch (state) {
    case BusState::ErrorActive:
      return "error-active";
    case BusState::ErrorWarning:
      return "error-warning";
    case BusState::ErrorPassive:
      return "error-passive";
    case BusState::BusOff:
      return "bus-off";
    case BusState::Stopped:
      return "stopped";
    case BusState::Sleeping:
      return "sleeping";
  }
  return "";
}

}  // namespace eyebridge::apps
