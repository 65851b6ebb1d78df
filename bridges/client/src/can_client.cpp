// What a program asks of its robot. What happens by itself is in can_life.cpp.
#include "eyebridge/bridges/client/can_client.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace eyebridge::bridges {
namespace {

using namespace std::chrono_literals;

constexpr Time kPoseTimeout = 200ms;
// Without a jump, what comes sooner may have been said before the robot heard us: it tells its pose
// every 20 ms.
constexpr Time kPoseSettles = 25ms;
// What no robot drives or turns within a period of its pose is a jump.
constexpr double kJumpMm = 60;
constexpr double kJumpCdeg = 2000;
constexpr Time kScanAge = 1s;
constexpr Time kReleaseTime = 550ms;  // the robot wants 500 ms without an emergency stop
constexpr Time kLeastAge = 300ms;
constexpr std::uint8_t kMiddle = 128;
// How far a pose may be from the one that was set, for a robot that drives on meanwhile.
constexpr int kNearMm = 150;
constexpr int kNearCdeg = 4500;

/// Difference of two headings, 0 … 18000.
int apart_cdeg(const can::PoseStatus& status, const can::PoseCommand& wanted) {
  const int turn = std::abs(status.phi_cdeg - wanted.phi_cdeg) % 36000;
  return std::min(turn, 36000 - turn);
}

/// How far apart, in jumps.
double jumps(const can::PoseStatus& status, const can::PoseCommand& wanted) {
  return std::max({std::abs(status.x_mm - wanted.x_mm) / kJumpMm,
                   std::abs(status.y_mm - wanted.y_mm) / kJumpMm,
                   apart_cdeg(status, wanted) / kJumpCdeg});
}

bool is_near(const can::PoseStatus& status, const can::PoseCommand& wanted) {
  return std::abs(status.x_mm - wanted.x_mm) <= kNearMm &&
         std::abs(status.y_mm - wanted.y_mm) <= kNearMm && apart_cdeg(status, wanted) <= kNearCdeg;
}

}  // namespace

CanClient::CanClient(std::unique_ptr<CanBus> bus, int node, Clock& clock, LogSink& log)
    : bus_(std::move(bus)),
      node_(node),
      who_(std::string(bus_->name()) + ": robot " + std::to_string(node)),
      clock_(clock),
      log_(log),
      watch_("robot " + std::to_string(node) + " on " + std::string(bus_->name())),
      lidar_(std::make_unique<can::LidarAssembler>()) {
  assert(node >= EYECAN_NODE_FIRST && node <= EYECAN_NODE_LAST);
  // Refused only by buses that cannot filter: then take() does it.
  const CanFilter own{.id = static_cast<std::uint32_t>(node), .mask = EYECAN_NODE_MASK};
  (void)bus_->set_filters({&own, 1});
}

CanClient::~CanClient() {
  (void)stop();
  {
    const std::lock_guard sending(sending_);
    Outbox out;
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
      if (statistics_.enables > 0) {
        out.add(
            can::encode(0, can::NmtCommand{EYECAN_NMT_STANDBY, static_cast<std::uint8_t>(node_)}));
      }
    }
    (void)send_all(out);
  }
  if (thread_.joinable()) thread_.join();
}

Result<void> CanClient::check_ready() const {
  if (watch_.phase() == RobotWatch::Phase::Ready) return {};
  return tl::unexpected(watch_.error());
}

Result<void> CanClient::check_age(const can::MessageSpec& spec, std::optional<Time> at) const {
  if (auto ready = check_ready(); !ready) return ready;
  const Time limit = std::max<Time>(kLeastAge, 4 * std::chrono::milliseconds(spec.period_ms));
  if (at && clock_.now() - *at <= limit) return {};
  return fail(Errc::Timeout, who_ + " sends no " + std::string(spec.name));
}

Result<void> CanClient::send_ready(const Result<CanFrame>& frame) {
  if (!frame) return tl::unexpected(frame.error());
  const std::lock_guard sending(sending_);
  {
    const std::lock_guard lock(mutex_);
    if (auto ready = check_ready(); !ready) return ready;
  }
  return send(*frame);
}

Result<void> CanClient::drive(std::int16_t v_mm_s, std::int16_t w_cdeg_s) {
  const std::lock_guard sending(sending_);
  Outbox out;
  {
    const std::lock_guard lock(mutex_);
    if (auto ready = check_ready(); !ready) return ready;
    command_ = {};
    command_.mode = Mode::Speed;
    command_.speed = {.v_mm_s = v_mm_s, .w_cdeg_s = w_cdeg_s};
    add_set_points(out);
  }
  return send_all(out);
}

Result<void> CanClient::move(can::MoveCommand command) {
  const std::lock_guard sending(sending_);
  Outbox out;
  {
    const std::lock_guard lock(mutex_);
    if (auto ready = check_ready(); !ready) return ready;
    // Not the number of the move before, which the robot still echoes.
    command.seq = next_seq() == std::get<Latest<can::SpeedStatus>>(latest_).value.last_move_seq
                      ? next_seq()
                      : seq_;
    if (auto frame = can::encode(node_, command); !frame) {
      return tl::unexpected(std::move(frame.error()));
    }
    command_ = {};
    command_.mode = Mode::Move;
    command_.move = command;
    command_.move_sent = clock_.now();
    add_set_points(out);
  }
  return send_all(out);
}

Result<MoveProgress> CanClient::move_progress() const {
  const std::lock_guard lock(mutex_);
  if (auto ready = check_ready(); !ready) return tl::unexpected(std::move(ready.error()));
  if (command_.mode != Mode::Move) return MoveProgress::Done;
  if (command_.move_failed) return MoveProgress::Failed;
  if (!command_.move_echoed) return MoveProgress::Sent;
  switch (std::get<Latest<can::SpeedStatus>>(latest_).value.move_state) {
    case EYECAN_MOVE_RUNNING:
      return MoveProgress::Running;
    case EYECAN_MOVE_ABORTED:
      return MoveProgress::Failed;
    default:
      return MoveProgress::Done;
  }
}

Result<void> CanClient::motor(int motor, std::int8_t value, std::uint8_t mode) {
  if (motor < 1 || motor > 4) return fail(Errc::OutOfRange, "no motor " + std::to_string(motor));
  const std::lock_guard sending(sending_);
  Outbox out;
  {
    const std::lock_guard lock(mutex_);
    if (auto ready = check_ready(); !ready) return ready;
    if (command_.mode != Mode::Motors) command_ = {};
    command_.mode = Mode::Motors;
    command_.motors[static_cast<std::size_t>(motor) - 1] = {true, mode, value};
    add_set_points(out);
  }
  return send_all(out);
}

Result<void> CanClient::pid(const can::PidCommand& gains) {
  const auto frame = can::encode(node_, gains);
  if (!frame) return tl::unexpected(frame.error());
  {
    const std::lock_guard lock(mutex_);
    gains_[gains.motor - 1U] = gains;
  }
  return send_ready(frame);
}

Result<void> CanClient::servo(int servo, std::uint8_t position) {
  if (servo < 1 || servo > 14) return fail(Errc::OutOfRange, "no servo " + std::to_string(servo));
  const std::size_t index = static_cast<std::size_t>(servo) - 1;
  can::ServoCommand command;
  {
    const std::lock_guard lock(mutex_);
    auto& bank = servos_[index / 7];
    if (!bank) {
      bank.emplace();
      bank->bank = static_cast<std::uint8_t>(index / 7);
      bank->position.fill(kMiddle);
    }
    bank->position[index % 7] = position;
    command = *bank;
  }
  return send_ready(can::encode(node_, command));
}

Result<void> CanClient::set_pose(const can::PoseCommand& pose) {
  const auto frame = can::encode(node_, pose);
  if (!frame) return tl::unexpected(frame.error());
  const Time start = clock_.now();
  const bool is_jump = [&] {
    const std::lock_guard lock(mutex_);
    const auto& before = std::get<Latest<can::PoseStatus>>(latest_);
    return before.at && jumps(before.value, pose) >= 1.0;
  }();
  // One repetition, for a frame that got lost.
  for (const Time until : {start + kPoseTimeout / 2, start + kPoseTimeout}) {
    const Time sent = clock_.now();
    {
      const std::lock_guard lock(mutex_);
      senders_.expect_another(EYECAN_S_POSE, sent);
    }
    if (auto said = send_ready(frame); !said) return said;
    const bool taken = wait_for(
        [&] {
          const auto& now = std::get<Latest<can::PoseStatus>>(latest_);
          if (is_jump && now.at >= sent && jumps(now.value, pose) <= 0.5) return true;
          return now.at >= sent + kPoseSettles && is_near(now.value, pose);
        },
        until);
    if (taken) return {};
  }
  return fail(Errc::Timeout, who_ + " does not take the pose that it was told");
}

Result<void> CanClient::stop() {
  const std::lock_guard sending(sending_);
  Outbox out;
  bool is_lost = false;
  {
    const std::lock_guard lock(mutex_);
    // A robot that was never ours is none of our business.
    if (statistics_.enables == 0) return {};
    add_zero(out);
    is_lost = watch_.phase() == RobotWatch::Phase::Lost;
  }
  if (auto sent = send_all(out); !sent) return sent;
  if (!is_lost) {
    tell_guard(false);
    return {};
  }
  const std::lock_guard lock(mutex_);
  return check_ready();
}

void CanClient::emergency_stop(std::uint8_t reason) {
  const std::lock_guard sending(sending_);
  Outbox out;
  {
    const std::lock_guard lock(mutex_);
    const std::uint32_t before = watch_.generation();
    watch_.emergency_stop();
    follow_watch(before);
    emergency_ = reason;
    out.add(can::encode(node_, can::EmergencyStop{reason, next_seq()}));
  }
  (void)send_all(out);
}

void CanClient::release() {
  const std::lock_guard lock(mutex_);
  if (!emergency_) return;
  emergency_.reset();
  watch_.restart(clock_.now() + kReleaseTime);
}

Result<void> CanClient::latest_scan(can::LidarScan& out) const {
  const std::lock_guard lock(mutex_);
  if (auto ready = check_ready(); !ready) return ready;
  if (!scan_at_ || clock_.now() - *scan_at_ > kScanAge) {
    return fail(Errc::Timeout, who_ + " sends no LIDAR scans");
  }
  out = scan_;
  return {};
}

bool CanClient::has_lidar() const {
  const std::lock_guard lock(mutex_);
  return has_lidar_ || is_capable_of(EYECAN_CAPABLE_OF_SCANS);
}

Result<can::Zones> CanClient::latest_zones(int id) const {
  const std::lock_guard lock(mutex_);
  if (auto ready = check_ready(); !ready) return tl::unexpected(ready.error());
  if (id < 1 || id > can::kMostMatrices) {
    return fail(Errc::NoDevice, "no range matrix " + std::to_string(id) + ", expected 1 to " +
                                    std::to_string(can::kMostMatrices));
  }
  const RangeMatrix& matrix = range_matrices_[static_cast<std::size_t>(id) - 1];
  if (!matrix.at || clock_.now() - *matrix.at > kScanAge) {
    return fail(Errc::Timeout, who_ + " sends no readings of range matrix " + std::to_string(id));
  }
  return matrix.zones;
}

bool CanClient::has_range_matrix(int id) const {
  const std::lock_guard lock(mutex_);
  if (id < 1 || id > can::kMostMatrices) return false;
  return range_matrices_[static_cast<std::size_t>(id) - 1].at ||
         is_capable_of(unsigned{EYECAN_CAPABLE_OF_ZONES} << static_cast<unsigned>(id - 1));
}

bool CanClient::is_capable_of(unsigned capability) const {
  const auto& version = std::get<Latest<can::VersionStatus>>(latest_);
  return version.at && (version.value.capabilities & capability) != 0;
}

RobotWatch::Phase CanClient::phase() const {
  const std::lock_guard lock(mutex_);
  return watch_.phase();
}

std::uint32_t CanClient::generation() const {
  const std::lock_guard lock(mutex_);
  return watch_.generation();
}

std::uint32_t CanClient::restarts() const {
  const std::lock_guard lock(mutex_);
  return watch_.restarts();
}

CanClientStatistics CanClient::statistics() const {
  const std::lock_guard lock(mutex_);
  CanClientStatistics out = statistics_;
  out.bus = bus_->statistics();
  return out;
}

}  // namespace eyebridge::bridges
