#include "can_census.hpp"

#include <algorithm>

#include "eyebridge/bridges/can/table.hpp"
#include "opcodes.h"

namespace eyebridge::apps {
namespace {

using namespace bridges;

template <std::size_t N>
void note_psds(HeardRobot& robot, int first, const std::array<std::uint16_t, N>& ranges) {
  for (std::size_t i = 0; i < N; ++i) {
    const int number = first + static_cast<int>(i);
    const bool known = std::ranges::find(robot.psds, number) != robot.psds.end();
    if (ranges[i] != EYECAN_ABSENT && !known) robot.psds.push_back(number);
  }
}

CanFrame version_request(int node) {
  CanFrame frame;
  frame.id = static_cast<std::uint32_t>(EYECAN_S_VERSION << EYECAN_NODE_BITS | node);
  frame.length = CanFrame::kMaxClassic;
  frame.remote = true;
  return frame;
}

}  // namespace

void CensusTaker::take(const CanFrame& frame, Time now) {
  ++counts_.frames;
  const auto received = can::decode_any(frame);
  if (!received) {
    ++(received.error().code == Errc::Corrupt ? counts_.corrupt : counts_.foreign);
    return;
  }
  const int node = received->node;
  if (node == EYECAN_NODE_HOST) counts_.has_host = true;
  const auto* message = can::find_message(can::function_of(frame.id), frame.fd);
  const bool is_command = message->direction == can::Direction::HostToRobot;
  if (is_command) counts_.has_host = true;
  if (is_command || node < EYECAN_NODE_FIRST || node > EYECAN_NODE_LAST) return;
  take_message(seen_[node], received->message, now);
}

void CensusTaker::take_message(Seen& seen, const can::AnyMessage& message, Time now) {
  HeardRobot& robot = seen.robot;
  if (const auto* heartbeat = std::get_if<can::Heartbeat>(&message)) {
    ++robot.heartbeats;
    ++seen.heartbeats_since;
    robot.state = heartbeat->state;
    seen.watch.heartbeat(heartbeat->state, now);
  } else if (const auto* board = std::get_if<can::BoardStatus>(&message)) {
    if (!seen.first_uptime) {
      seen.first_uptime = board->uptime_ds;
      seen.heartbeats_since = 0;
    }
    seen.heartbeats_until = seen.heartbeats_since;
    robot.board = *board;
    seen.watch.uptime(board->uptime_ds, now);
  } else if (const auto* fault = std::get_if<can::FaultStatus>(&message)) {
    robot.fault = *fault;
    seen.watch.fault(fault->code);
  } else if (const auto* version = std::get_if<can::VersionStatus>(&message)) {
    robot.version = *version;
  } else if (const auto* psd_a = std::get_if<can::PsdAStatus>(&message)) {
    note_psds(robot, 1, psd_a->range_mm);
  } else if (const auto* psd_b = std::get_if<can::PsdBStatus>(&message)) {
    note_psds(robot, 5, psd_b->range_mm);
  } else if (const auto* header = std::get_if<can::LidarHeader>(&message)) {
    robot.lidar_points = header->points;
  } else if (std::holds_alternative<can::LidarChunkFd>(message)) {
    robot.sends_fd = true;
  } else if (std::holds_alternative<can::SpeedStatus>(message)) {
    robot.drives = true;
  } else if (std::holds_alternative<can::Encoder12Status>(message)) {
    robot.has_encoders = true;
  }
}

// By the robot's own time, so that a busy computer does not matter: one heartbeat in 0.1 s is one
// robot's, two are two robots'. RobotWatch needs 2 s for the same when both started together.
bool CensusTaker::is_twice(const Seen& seen) {
  constexpr std::uint32_t kMask = 0xFFFFFF;
  constexpr std::uint32_t kLeast_ds = 8;
  if (seen.watch.phase() == RobotWatch::Phase::Twice) return true;
  if (!seen.first_uptime || !seen.robot.board) return false;
  const std::uint32_t span = (seen.robot.board->uptime_ds - *seen.first_uptime) & kMask;
  const bool sound = span >= kLeast_ds && span <= kMask / 2;
  return sound && static_cast<std::uint32_t>(seen.heartbeats_until) * 10 >= span * 17;
}

std::vector<int> CensusTaker::without_version() const {
  std::vector<int> out;
  for (const auto& [node, seen] : seen_) {
    if (!seen.robot.version) out.push_back(node);
  }
  return out;
}

CanCensus CensusTaker::census() const {
  CanCensus out = counts_;
  for (const auto& [node, seen] : seen_) {
    HeardRobot robot = seen.robot;
    robot.twice = is_twice(seen);
    std::ranges::sort(robot.psds);
    out.robots.emplace(node, std::move(robot));
  }
  return out;
}

Result<CanCensus> listen_to(CanBus& bus, Clock& clock, Time span) {
  CensusTaker taker;
  constexpr Time kSlice = std::chrono::milliseconds(10);  // virtual clocks wake at deadlines only
  const Time half = clock.now() + span / 2;
  const Time end = clock.now() + span;
  bool asked = false;
  while (true) {
    const Time now = clock.now();
    if (now >= end) break;
    if (now >= half && !asked) {
      asked = true;
      for (const int node : taker.without_version()) {
        // Whoever does not get the question tells its version within 5 s all the same.
        (void)bus.send(version_request(node), end);
      }
    }
    const auto frame = bus.receive(std::min(now + kSlice, asked ? end : half));
    if (frame) {
      taker.take(*frame, clock.now());
    } else if (frame.error().code != Errc::Timeout) {
      return tl::unexpected(frame.error());
    }
  }
  CanCensus census = taker.census();
  census.bus = bus.statistics();
  return census;
}

}  // namespace eyebridge::apps
