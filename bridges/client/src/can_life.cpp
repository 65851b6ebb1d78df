// What happens between a client and its robot without being asked for.
#include <algorithm>
#include <cstdio>
#include <utility>

#include <pthread.h>

#include "eyebridge/bridges/client/can_client.hpp"
#include "pump_bus.hpp"

namespace eyebridge::bridges {
namespace {

using namespace std::chrono_literals;

constexpr Time kHeartbeatPeriod = 100ms;
constexpr Time kPointPeriod = 50ms;
constexpr Time kServoPeriod = 100ms;
constexpr Time kReportPeriod = 1s;
// Longer would let the next heartbeat be late; what does not go out now is old by then.
constexpr Time kSendTime = 5ms;
constexpr Time kEchoLimit = 500ms;
constexpr Time kLongestGap = 200ms;  ///< Between frames of a reading of a range matrix.
constexpr std::array<std::uint8_t, 2> kMotorModes = {EYECAN_MOTOR_PERCENT, EYECAN_MOTOR_TICKS};

std::string fault_text(const can::FaultStatus& fault) {
  switch (fault.code) {
    case EYECAN_FAULT_LOW_BATTERY:
      return "its battery is low";
    case EYECAN_FAULT_MOTOR_BLOCKED:
      return "a motor is blocked";
    case EYECAN_FAULT_HOST_LOST:
      return "it did not hear this program";
    case EYECAN_FAULT_BUS_OFF_RECOVERED:
      return "it was off the bus, and is back";
    case EYECAN_FAULT_DUPLICATE_NODE:
      return "it hears another robot with its number";
    case EYECAN_FAULT_FRAME_LENGTH:
      return "it received a frame that is too short";
    case EYECAN_FAULT_BAD_VALUE:
      return "it received an impossible value";
    case EYECAN_FAULT_ESTOP:
      return "emergency stop";
    case EYECAN_FAULT_COMMAND_TIMEOUT:
      return "commands did not come in time";
    default: {
      char text[32];
      std::snprintf(text, sizeof text, "fault 0x%04X", static_cast<unsigned>(fault.code));
      return text;
    }
  }
}

}  // namespace

void CanClient::start() {
  thread_ = std::thread([this] { run(); });
  // By this name robios knows that it is none of the program's own threads.
  pthread_setname_np(thread_.native_handle(), "eb:can");
}

void CanClient::run() {
  while (true) {
    {
      const std::lock_guard lock(mutex_);
      if (ending_) return;
    }
    pump(clock_.now() + kPointPeriod);
  }
}

void CanClient::pump(Time until) {
  pump_bus(
      *bus_, clock_, until, [this] { return tick(); },
      [this](const CanFrame& frame) { take(frame); },
      [this](const std::string& why) {
        const std::lock_guard lock(mutex_);
        const std::uint32_t before = watch_.generation();
        watch_.bus_lost(why);
        follow_watch(before);
      });
}

Time CanClient::tick() {
  const std::lock_guard sending(sending_);
  Outbox out;
  Time next{0};
  bool turning = false;
  {
    const std::lock_guard lock(mutex_);
    const Time now = clock_.now();
    const std::uint32_t before = watch_.generation();
    watch_.check(now);
    follow_watch(before);
    if (now >= next_heartbeat_) {
      next_heartbeat_ = now + kHeartbeatPeriod;
      out.add(can::encode(EYECAN_NODE_HOST, can::Heartbeat{EYECAN_STATE_OPERATIONAL}));
      const bool is_known = std::get<Latest<can::VersionStatus>>(latest_).at.has_value();
      if (!is_known && watch_.phase() != RobotWatch::Phase::Unheard) out.add(version_request());
      if (emergency_) out.add(can::encode(node_, can::EmergencyStop{*emergency_, next_seq()}));
      if (watch_.wants_enable(now)) {
        add_zero(out);
        out.add(
            can::encode(0, can::NmtCommand{EYECAN_NMT_ENABLE, static_cast<std::uint8_t>(node_)}));
        ++statistics_.enables;
        watch_.enabled();
      }
    }
    if (now >= next_point_) {
      next_point_ = now + kPointPeriod;
      if (check_ready()) add_set_points(out);
    }
    if (now >= next_servo_) {
      next_servo_ = now + kServoPeriod;
      for (const auto& bank : servos_) {
        if (bank && check_ready()) out.add(can::encode(node_, *bank));
      }
    }
    next = std::min({next_heartbeat_, next_point_, next_servo_});
    turning = command_.mode != Mode::Idle && command_.mode != Mode::Standing;
  }
  if (turning) tell_guard(true);
  (void)send_all(out);  // That the bus does not work, receive() says too.
  return next;
}

CanFrame CanClient::version_request() const {
  CanFrame frame;
  frame.id = EYECAN_S_VERSION << EYECAN_NODE_BITS | static_cast<std::uint32_t>(node_);
  frame.remote = true;
  frame.length = static_cast<std::uint8_t>(can::spec_of<can::VersionStatus>().length);
  return frame;
}

void CanClient::add_zero(Outbox& out) {
  command_ = {};
  command_.mode = Mode::Standing;
  out.add(can::encode(node_, can::SpeedCommand{.seq = next_seq()}));
  add_set_points(out);
}

void CanClient::add_set_points(Outbox& out) {
  switch (command_.mode) {
    case Mode::Idle:
      return;
    case Mode::Standing:
      // No speed of 0: to that the robot would go down its ramp.
      return out.add(can::encode(node_, can::MotorCommand{.mask = 0xF, .seq = next_seq()}));
    case Mode::Speed:
      command_.speed.seq = next_seq();
      return out.add(can::encode(node_, command_.speed));
    case Mode::Move: {
      if (command_.move_echoed || command_.move_failed) return;
      const Time waited = clock_.now() - command_.move_sent;
      command_.move_failed = waited > kEchoLimit;
      statistics_.move_repeats += waited > Time{0} ? 1 : 0;
      if (command_.move_failed) return;
      senders_.expect_another(EYECAN_S_SPEED, clock_.now());  // the echo
      out.add(can::encode(node_, command_.move));
      return;
    }
    case Mode::Motors:
      for (const std::uint8_t mode : kMotorModes) {
        can::MotorCommand message;
        message.mode = mode;
        message.seq = next_seq();
        for (std::size_t i = 0; i < command_.motors.size(); ++i) {
          const MotorPoint& point = command_.motors[i];
          if (!point.used || point.mode != mode) continue;
          message.value[i] = point.value;
          message.mask = static_cast<std::uint8_t>(message.mask | 1U << i);
        }
        if (message.mask != 0) out.add(can::encode(node_, message));
      }
      return;
  }
}

void CanClient::add_parameters(Outbox& out) const {
  for (const auto& gains : gains_) {
    if (gains) out.add(can::encode(node_, *gains));
  }
  for (const auto& bank : servos_) {
    if (bank) out.add(can::encode(node_, *bank));
  }
}

void CanClient::follow_watch(std::uint32_t before) {
  if (watch_.generation() != before) command_ = {};
  if (const std::string news = watch_.take_news(); !news.empty()) {
    const bool good = watch_.phase() == RobotWatch::Phase::Ready ||
                      (watch_.phase() == RobotWatch::Phase::Waking && watch_.generation() == 0);
    log_.write(good ? Severity::Info : Severity::Error, news);
  }
  changed_.notify_all();
}

void CanClient::take(const CanFrame& frame) {
  const auto message = can::decode_any(frame);
  Outbox out;
  {
    const std::lock_guard lock(mutex_);
    const Time now = clock_.now();
    if (!message) {
      if (message.error().code != Errc::Corrupt) return;  // none of the protocol
      ++statistics_.corrupt;
      if (can::node_of(frame.id) == node_) keep_nothing(can::function_of(frame.id), now);
      if (now < next_report_) return;
      next_report_ = now + kReportPeriod;
      log_.write(Severity::Warning,
                 std::string(bus_->name()) + ": ignored a frame: " + message.error().what);
      return;
    }
    if (message->node != node_) return;
    const bool ready = check_ready().has_value();
    const std::uint32_t before = watch_.generation();
    take_message(message->message, now);
    follow_watch(before);
    if (!ready && check_ready()) add_parameters(out);
  }
  if (out.count == 0) return;
  const std::lock_guard sending(sending_);
  (void)send_all(out);
}

void CanClient::take_message(const can::AnyMessage& message, Time now) {
  keep_status(message, now);
  if (const auto* beat = std::get_if<can::Heartbeat>(&message)) watch_.heartbeat(beat->state, now);
  if (const auto* board = std::get_if<can::BoardStatus>(&message)) {
    watch_.uptime(board->uptime_ds, now);
  }
  if (const auto* fault = std::get_if<can::FaultStatus>(&message)) note_fault(*fault);
  const auto* const stop = std::get_if<can::EmergencyStop>(&message);
  // The guard of a program that is gone: the motor command that it sends, too, is no second
  // program's.
  if (stop != nullptr && stop->reason == EYECAN_ESTOP_HOST_FAULT) senders_.forget_other_host();

  const can::LidarScan* scan = nullptr;
  if (const auto* header = std::get_if<can::LidarHeader>(&message)) {
    has_lidar_ = true;
    scan = lidar_->push(*header);
  } else if (const auto* chunk = std::get_if<can::LidarChunk>(&message)) {
    scan = lidar_->push(*chunk);
  } else if (const auto* chunk_fd = std::get_if<can::LidarChunkFd>(&message)) {
    scan = lidar_->push(*chunk_fd);
  } else if (const auto* zones = std::get_if<can::ZoneChunk>(&message)) {
    take_zones(*zones, now);
  }
  // One with gaps is none: a range is never invented.
  if (scan != nullptr && scan->missing == 0) {
    scan_ = *scan;
    scan_at_ = now;
  }
}

void CanClient::take_zones(const can::ZoneChunk& chunk, Time now) {
  RangeMatrix& matrix = range_matrices_.at(chunk.matrix - 1U);
  // The frames of a reading follow each other: an old one's, of the same number, are not added.
  if (now - matrix.chunk_at > kLongestGap) matrix.assembler.reset();
  matrix.chunk_at = now;
  if (const can::Zones* const whole = matrix.assembler.push(chunk); whole != nullptr) {
    matrix.zones = *whole;
    matrix.at = now;
  }
}

void CanClient::note_fault(const can::FaultStatus& fault) {
  watch_.fault(fault.code);
  const Time now = clock_.now();
  if (fault.code == EYECAN_FAULT_NONE || now < next_report_) return;
  next_report_ = now + kReportPeriod;
  log_.write(Severity::Warning, who_ + " reports: " + fault_text(fault));
}

Result<void> CanClient::send(const CanFrame& frame) {
  return bus_->send(frame, clock_.now() + kSendTime);
}

Result<void> CanClient::send_all(const Outbox& out) {
  for (std::size_t i = 0; i < out.count; ++i) {
    if (auto sent = send(out.frames[i]); !sent) return sent;
  }
  return {};
}

bool CanClient::wait_for(const std::function<bool()>& done, Time deadline) {
  if (!thread_.joinable()) {
    while (clock_.now() < deadline) {
      pump(std::min(deadline, clock_.now() + 5ms));
      const std::lock_guard lock(mutex_);
      if (done()) return true;
    }
    return false;
  }
  std::unique_lock lock(mutex_);
  while (!done()) {
    const Time left = deadline - clock_.now();
    if (left <= Time{0}) return false;
    changed_.wait_for(lock, left);
  }
  return true;
}

std::string CanClient::missing() const {
  constexpr int kCyclic = 100;  // ms; what comes less often comes on events, too
  if (auto ready = check_ready(); !ready) return ready.error().what;
  std::string names;
  const auto add = [&](std::string_view name) {
    names += (names.empty() ? "" : ", ") + std::string(name);
  };
  const auto look = [&]<class Status>(const Latest<Status>& entry) {
    const can::MessageSpec& spec = can::spec_of<Status>();
    if (!entry.at && spec.period_ms > 0 && spec.period_ms <= kCyclic) add(spec.name);
  };
  std::apply([&](const auto&... entries) { (look(entries), ...); }, latest_);
  const auto& version = std::get<Latest<can::VersionStatus>>(latest_);
  if (!version.at) add(can::spec_of<can::VersionStatus>().name);
  if (is_capable_of(EYECAN_CAPABLE_OF_SCANS) && !scan_at_) add("a whole scan of its LIDAR");
  for (unsigned i = 0; i < range_matrices_.size(); ++i) {
    if (is_capable_of(unsigned{EYECAN_CAPABLE_OF_ZONES} << i) && !range_matrices_[i].at) {
      add("a whole reading of range matrix " + std::to_string(i + 1));
    }
  }
  return names.empty() ? "" : who_ + " does not send " + names;
}

Result<void> CanClient::wait_ready(Time patience) {
  std::string left;
  const bool ready = wait_for([&] { return (left = missing()).empty(); }, clock_.now() + patience);
  if (ready) return {};
  const std::lock_guard lock(mutex_);
  if (auto not_ready = check_ready(); !not_ready) return not_ready;
  return fail(Errc::Timeout, left);
}

}  // namespace eyebridge::bridges
