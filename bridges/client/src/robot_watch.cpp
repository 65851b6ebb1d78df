#include "eyebridge/bridges/client/robot_watch.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <utility>

#include "opcodes.h"

namespace eyebridge::bridges {
namespace {

constexpr std::uint32_t kUptimeMask = 0xFFFFFF;
constexpr std::uint32_t kWindow = 20;  // 2 s of uptime: 20 heartbeats of one robot, 40 of two
constexpr int kTooMany = 34;
constexpr unsigned kRecentSteps = 0x3FF;
// Two clocks, and frames that wait in a queue, may differ by 1 s, and by 2 % of a long silence.
constexpr std::uint32_t kBirthSlack = 10;  // in 0.1 s
constexpr std::uint32_t kSilencePerSlack = 50;
// Heartbeat and uptime both tell of a restart, one after the other.
constexpr Time kOneRestart = std::chrono::seconds(1);
constexpr Time kTick = std::chrono::milliseconds(100);
constexpr int kTooOftenBack = 3;  // of the recent steps; one is a restart

constexpr const char* kTwice =
    "two robots have this number; expected one, and a start of the program after that";

const char* name_of(std::uint8_t state) {
  switch (state) {
    case EYECAN_STATE_BOOT:
      return "has restarted";
    case EYECAN_STATE_STOPPED:
      return "was stopped";
    case EYECAN_STATE_STANDBY:
      return "went into standby";
    default:
      return "is not operational";
  }
}

}  // namespace

void RobotWatch::enter(Phase phase, Errc code, const std::string& what) {
  if (phase_ == Phase::Ready && phase != Phase::Ready) ++generation_;
  if (phase == Phase::Waking) {
    enabled_ = false;
    knows_restart_ = !born_;
  }
  phase_ = phase;
  error_ = {code, name_ + ": " + what};
  news_ = error_.what;
}

void RobotWatch::heartbeat(std::uint8_t state, Time now) {
  last_heartbeat_ = now;
  ++window_heartbeats_;
  const bool boots = state == EYECAN_STATE_BOOT && last_state_ && last_state_ != state;
  last_state_ = state;
  if (boots) restarted(now);
  switch (phase_) {
    case Phase::Unheard:
      enable_from_ = now + kListening;
      return enter(Phase::Waking, Errc::Disconnected, "heard; is being enabled");
    case Phase::Lost:
      enable_from_ = now;
      return enter(Phase::Waking, Errc::Disconnected,
                   "is back; is being enabled again, at speed 0");
    case Phase::Waking:
      if (state == EYECAN_STATE_OPERATIONAL && enabled_ && knows_restart_) {
        enter(Phase::Ready, Errc::Disconnected, "is ready");
      }
      return;
    case Phase::Ready:
      if (state == EYECAN_STATE_OPERATIONAL) return;
      enable_from_ = now;
      return enter(Phase::Waking, Errc::Disconnected,
                   std::string(name_of(state)) + "; is being enabled again, at speed 0");
    case Phase::EmergencyStopped:
    case Phase::Twice:
      return;
  }
}

void RobotWatch::restarted(Time now) {
  knows_restart_ = true;
  born_.reset();
  if (restarted_at_ && now - *restarted_at_ < kOneRestart) return;
  restarted_at_ = now;
  ++restarts_;
}

// A frame that was read late does not tell when the robot started. Two frames do that came as far
// apart as the robot sent them.
void RobotWatch::look_at_birth(std::uint32_t step, Time now) {
  const Time apart = uptime_at_ ? now - *uptime_at_ : Time{0};
  uptime_at_ = now;
  if (apart < kTick / 2 || std::chrono::abs(apart - step * kTick) > kTick) return;
  if (born_) {
    const auto alive = static_cast<std::uint32_t>((now - *born_) / kTick);
    const std::uint32_t late = (alive - *uptime_) & kUptimeMask;
    const std::uint32_t off = std::min(late, kUptimeMask + 1 - late);
    if (off >
        kBirthSlack + static_cast<std::uint32_t>((now - born_seen_) / kTick) / kSilencePerSlack) {
      restarted(now);
    }
  }
  knows_restart_ = true;
  born_ = now - *uptime_ * kTick;
  born_seen_ = now;
}

// The checks go by the robot's own time, so that frames which were read late do not matter.
void RobotWatch::uptime(std::uint32_t ds, Time now) {
  if (!uptime_) {
    window_start_ = ds;
    window_heartbeats_ = 0;
  }
  const std::uint32_t step = (ds - uptime_.value_or(ds)) & kUptimeMask;
  const bool back = step > kUptimeMask / 2;
  uptime_ = ds;
  steps_back_ = (steps_back_ << 1U | (back ? 1U : 0U)) & kRecentSteps;
  const std::uint32_t span = (ds - window_start_) & kUptimeMask;
  const bool crowded = span < 2 * kWindow && span >= kWindow && window_heartbeats_ >= kTooMany;
  if (back || span >= kWindow) {
    window_start_ = ds;
    window_heartbeats_ = 0;
  }
  look_at_birth(step, now);
  if (phase_ == Phase::Twice || phase_ == Phase::Unheard) return;
  if (back) restarted(now);
  if (crowded || std::popcount(steps_back_) >= kTooOftenBack) {
    return enter(Phase::Twice, Errc::Corrupt, kTwice);
  }
  if (back && phase_ == Phase::Ready) {
    enable_from_ = now;
    enter(Phase::Waking, Errc::Disconnected, "has restarted; is being enabled again, at speed 0");
  }
}

void RobotWatch::fault(std::uint16_t code) {
  if (code == EYECAN_FAULT_DUPLICATE_NODE && phase_ != Phase::Twice) {
    return enter(Phase::Twice, Errc::Corrupt, kTwice);
  }
  if (code != EYECAN_FAULT_ESTOP || (phase_ != Phase::Ready && phase_ != Phase::Waking)) return;
  // What another one stopped before we came is released by starting: that is what a person means.
  if (phase_ == Phase::Waking && generation_ == 0) return;
  enter(Phase::EmergencyStopped, Errc::Disconnected,
        "emergency stop; expected that it is released and the program started again");
}

void RobotWatch::emergency_stop() {
  if (phase_ == Phase::Twice) return;
  enter(Phase::EmergencyStopped, Errc::Disconnected, "emergency stop is active");
}

void RobotWatch::restart(Time enable_from) {
  steps_back_ = 0;
  uptime_.reset();
  born_.reset();
  enable_from_ = enable_from;
  enter(Phase::Waking, Errc::Disconnected, "is being enabled");
}

void RobotWatch::not_alone(const std::string& what) {
  if (phase_ != Phase::Twice) enter(Phase::Twice, Errc::Corrupt, what);
}

void RobotWatch::bus_lost(const std::string& why) {
  if (phase_ == Phase::Ready || phase_ == Phase::Waking) {
    return enter(Phase::Lost, Errc::Disconnected, why);
  }
  if (phase_ == Phase::Unheard) error_ = {Errc::Disconnected, name_ + ": " + why};
}

void RobotWatch::check(Time now) {
  if (phase_ != Phase::Ready && phase_ != Phase::Waking) return;
  if (now - last_heartbeat_ <= kHeartbeatLimit) return;
  enter(Phase::Lost, Errc::Disconnected, "lost: no heartbeat for 300 ms");
}

void RobotWatch::enabled() { enabled_ = true; }

std::string RobotWatch::take_news() { return std::exchange(news_, {}); }

}  // namespace eyebridge::bridges
