#include "board/host_controller.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "eyebridge/hal/slow_line.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;

// What did not change is repeated: boards have watchdogs, and nothing says that it has arrived, or
// arrived as it was sent.
constexpr Time kRepeat = 20ms;
// A reply that is lost costs some 100 ms, and the line goes on: what was read before is the truth
// for so long.
constexpr Time kPatience = 500ms;
// A board samples its counters and obeys its motors every 10 ms: counts are half a period old, and
// a speed holds until the period after the one in which it came.
constexpr double kDeadTime = 0.015;  // seconds

constexpr Time kPrompt = 3ms;
constexpr Time kLongestUsual = 200ms;  // beyond, a reply says nothing of what is usual
constexpr int kAttempts = 3;

HostDriveSettings settings_of(const BoardDriveShape& shape) {
  HostDriveSettings settings{shape};
  settings.motor_lag = kDeadTime;
  return settings;
}

}  // namespace

HostController::HostController(BoardLink& link, Clock& clock, const BoardDriveShape& shape)
    : link_(link), clock_(clock), drive_(settings_of(shape)), heard_(clock.now()) {}

Result<BoardCount> HostController::prompt_count(int encoder) {
  for (int attempt = 1;; ++attempt) {
    auto count = link_.encoder(encoder);
    if (!count) return count;
    if (usual_answer_ == Time{0}) usual_answer_ = count->within;
    const bool prompt = count->within <= std::max<Time>(kPrompt, 2 * usual_answer_);
    usual_answer_ += (std::min(count->within, kLongestUsual) - usual_answer_) / 8;
    if (prompt || attempt == kAttempts) return count;
  }
}

// The right wheel is asked a reply later than the left one, and a robot that drives on meanwhile
// would look as if it had turned. Where it was at the left one's time lies between its last counts.
Result<HostController::TimedCounts> HostController::read_counts() {
  const std::optional<BoardCount> before = std::exchange(right_, std::nullopt);
  const auto left = prompt_count(1);
  if (!left) return tl::unexpected(left.error());
  const auto right = prompt_count(2);
  if (!right) return tl::unexpected(right.error());
  right_ = *right;
  TimedCounts counts{{left->ticks, right->ticks}, left->at};
  if (before && before->at < left->at && left->at < right->at) {
    const double share = to_seconds(right->at - left->at) / to_seconds(right->at - before->at);
    const auto moved = static_cast<std::int32_t>(static_cast<std::uint32_t>(right->ticks) -
                                                 static_cast<std::uint32_t>(before->ticks));
    const auto back = static_cast<std::uint32_t>(std::lround(share * moved));
    counts.wheels.right =
        static_cast<std::int32_t>(static_cast<std::uint32_t>(right->ticks) - back);
  }
  return counts;
}

void HostController::step() {
  const auto counts = read_counts();
  const Time now = clock_.now();
  const std::lock_guard sending(sending_);
  WheelSpeeds speeds;
  {
    const std::lock_guard lock(mutex_);
    note(counts, now);
    if (counts) {
      speeds = drive_.step(counts->wheels, counts->at, now - counts->at).value_or(WheelSpeeds{});
    } else if (const auto unheard = speeds_unheard(counts.error(), now)) {
      speeds = *unheard;
    } else {
      return;
    }
    if (!drive_.engaged()) return;
  }
  send(speeds, now);
}

void HostController::note(const Result<TimedCounts>& counts, Time now) {
  if (counts) {
    trouble_.reset();
    heard_ = now;
  } else if (counts.error().code == Errc::Disconnected || now - heard_ > kPatience) {
    trouble_ = counts.error();
  }
}

// Nobody knows where a robot goes that drives on without its encoders; a stop needs none.
std::optional<WheelSpeeds> HostController::speeds_unheard(const Error& why, Time now) {
  if (why.code == Errc::Disconnected) return std::nullopt;
  if (now - heard_ > kPatience) stand();
  if (standing_) return WheelSpeeds{};
  return sent_;  // what spoiled the counts may have spoiled the speeds
}

/// Ends what the drive does, until the next command.
void HostController::stand() {
  goal_lost_ = goal_lost_ || drive_.status().progress == DriveProgress::Driving;
  standing_ = true;
  drive_.halt();
}

// Asked at each call, too: whoever reads the encoders may be waiting for a board that is silent.
Result<void> HostController::check() const {
  if (trouble_) return tl::unexpected(*trouble_);
  if (clock_.now() - heard_ <= kPatience) return {};
  return fail(Errc::Timeout, "drive: the board has not told its encoders for half a second");
}

Result<void> HostController::check_line() const {
  const double longest = to_seconds(kLongestCycle);
  if (drive_.cycle() <= longest) return {};
  return fail(Errc::Timeout,
              fmt::format("drive: the board tells both its encoders only every {:.0f} ms; expected "
                          "at most {:.0f} ms to drive by them: a faster line, or profile=io7vw "
                          "where the board can drive by itself",
                          drive_.cycle() * 1e3, longest * 1e3));
}

void HostController::send(const WheelSpeeds& speeds, Time now) {
  if (sent_ == speeds && now - sent_at_ < kRepeat) return;
  sent_.reset();
  if (!link_.motor_speed(1, speeds.left) || !link_.motor_speed(2, speeds.right)) return;
  sent_ = speeds;
  sent_at_ = now;
}

Result<void> HostController::set_speed(const Twist& twist) {
  const std::lock_guard lock(mutex_);
  const bool stop = twist.linear == 0.0 && twist.angular == 0.0;
  auto checked = check();
  if (checked && !stop) checked = check_line();
  // A stop is obeyed as soon as anything is, though it cannot be promised.
  if (checked || stop) {
    goal_lost_ = false;
    standing_ = stop;
    drive_.set_speed(twist);
  }
  return checked;
}

Result<void> HostController::start(const DriveGoal& goal) {
  const std::lock_guard lock(mutex_);
  return check().and_then([this] { return check_line(); }).map([&] {
    goal_lost_ = false;
    standing_ = false;
    drive_.start(goal);
  });
}

Result<DriveStatus> HostController::status() {
  const std::lock_guard lock(mutex_);
  return check().map([this] {
    DriveStatus status = drive_.status();
    if (goal_lost_) status.progress = DriveProgress::Failed;
    return status;
  });
}

Result<Twist> HostController::measured_twist() {
  const std::lock_guard lock(mutex_);
  return check().map([this] { return drive_.measured_twist(); });
}

Result<Pose> HostController::odometry() {
  const std::lock_guard lock(mutex_);
  return check().map([this] { return drive_.odometry(); });
}

Result<void> HostController::set_odometry(const Pose& pose) {
  const std::lock_guard lock(mutex_);
  return check().map([&] { drive_.set_odometry(pose); });
}

void HostController::release() {
  const std::lock_guard sending(sending_);
  const std::lock_guard lock(mutex_);
  goal_lost_ = false;
  drive_.release();
  sent_.reset();
}

void HostController::restarted() {
  const std::lock_guard sending(sending_);
  const std::lock_guard lock(mutex_);
  goal_lost_ = goal_lost_ || drive_.status().progress == DriveProgress::Driving;
  drive_.restart();
  sent_.reset();
}

}  // namespace eyebridge::hal
