// What a robot tells, and whether it was the robot that told it.
#include <algorithm>
#include <cstdio>
#include <tuple>

#include "eyebridge/bridges/client/can_client.hpp"

namespace eyebridge::bridges {
namespace {

using namespace std::chrono_literals;

constexpr Time kUnusable = 300ms;

std::string in_hex(int function, int node) {
  char text[16];
  std::snprintf(text, sizeof text, "%03X",
                static_cast<unsigned>(function << EYECAN_NODE_BITS | node));
  return text;
}

/// Whether only one program may send it. Everybody may stop a robot.
bool is_only_ours(const can::MessageSpec& spec) {
  return spec.direction == can::Direction::HostToRobot && spec.function != EYECAN_C_NMT &&
         spec.function != EYECAN_C_ESTOP;
}

}  // namespace

template <class Status>
void CanClient::keep(const Status& status, Time now) {
  const can::MessageSpec& spec = can::spec_of<Status>();
  if (is_only_ours(spec)) return note_other_host(spec.name, now);
  bool may_answer = true;
  if constexpr (std::is_same_v<Status, can::SpeedStatus>) may_answer = echoes(status);
  const bool is_usable = senders_.heard(Status::kFunction, now, may_answer);
  if constexpr (IsKept<Status, Pending>::value) {
    auto& pending = std::get<Latest<Status>>(pending_);
    pending.at.reset();
    if (is_usable) pending = {status, now};
  } else if constexpr (IsKept<Status, Statuses>::value) {
    std::get<Latest<Status>>(latest_) = {status, now};
  }
}

void CanClient::keep_status(const can::AnyMessage& message, Time now) {
  std::visit([&](const auto& status) { keep(status, now); }, message);
  keep_followed(now);
  name_other_senders(now);
}

void CanClient::keep_nothing(int function, Time now) {
  static_cast<void>(senders_.heard(function, now));
  const auto forget = [&]<class Status>(Latest<Status>& pending) {
    if (Status::kFunction == function) pending.at.reset();
  };
  std::apply([&](auto&... pending) { (forget(pending), ...); }, pending_);
  name_other_senders(now);
}

void CanClient::keep_followed(Time now) {
  const auto look = [&]<class Status>(Latest<Status>& pending) {
    if (!pending.at || !senders_.is_followed(Status::kFunction, now)) return;
    std::get<Latest<Status>>(latest_) = pending;
    pending.at.reset();
    if constexpr (std::is_same_v<Status, can::SpeedStatus>) note_speed(pending.value);
  };
  std::apply([&](auto&... pending) { (look(pending), ...); }, pending_);
}

bool CanClient::echoes(const can::SpeedStatus& status) const {
  return command_.mode == Mode::Move && status.last_move_seq == command_.move.seq;
}

void CanClient::note_speed(const can::SpeedStatus& status) {
  if (echoes(status)) command_.move_echoed = true;
}

void CanClient::name_other_senders(Time now) {
  if (const auto found = senders_.take_found()) {
    log_.write(Severity::Warning, who_ + ": somebody else sends " + in_hex(*found, node_) +
                                      ", too (" +
                                      std::string(can::find_message(*found, false)->name) +
                                      "); expected that each identifier has one sender");
  }
  const auto look = [&]<class Status>(const Latest<Status>&) {
    const auto& kept = std::get<Latest<Status>>(latest_);
    if (!senders_.is_doubled(Status::kFunction, now) || !kept.at) return;
    if (now - *kept.at <= kUnusable) return;
    watch_.not_alone("somebody else sends " + in_hex(Status::kFunction, node_) + " all the time (" +
                     std::string(can::spec_of<Status>().name) +
                     "); expected the robot alone, and a start of the program after that");
  };
  std::apply([&](const auto&... pending) { (look(pending), ...); }, pending_);
}

void CanClient::note_other_host(std::string_view message, Time now) {
  if (!senders_.other_host(now)) return;
  watch_.not_alone("another program commands it (" + std::string(message) +
                   "); expected one, and a start of this one after that");
}

}  // namespace eyebridge::bridges
