#include "board/io7_link.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "board/io7_drive.hpp"
#include "opcodes.h"

namespace eyebridge::hal {
namespace {

namespace io7 = bridges::io7;
using namespace std::chrono_literals;

// At 127 ticks in 10 ms a 16-bit counter needs 2.5 s for half its range.
constexpr Time kCountPeriod = 1s;
constexpr Time kUsualGap =
    25ms;  // after a longer one, which is a line in trouble, all is asked twice
constexpr double kFastest = 3.0;  // metres per second
constexpr int kSlackTicks = 16;   // ticks
constexpr int kCounts = 4;        // that are asked for before none is believed
constexpr std::string_view kVwLetters = "xXqQyYCZ";

}  // namespace

Io7Link::Io7Link(std::unique_ptr<bridges::Io7Client> client, Clock& clock,
                 const BoardTables& tables)
    : client_(std::move(client)),
      clock_(clock),
      tables_(tables),
      letters_(client_->report()->profile.letters) {
  const io7::Profile profile = client_->report()->profile;
  vw_letters_ = profile.vw_letters &&
                std::ranges::all_of(kVwLetters, [&](char letter) { return letters_.has(letter); });
  fastest_ =
      kFastest * std::max(tables.drive.left_ticks_per_metre, tables.drive.right_ticks_per_metre);
  for (int id = IO7_ENCODER_FIRST; id <= IO7_ENCODER_LAST; ++id) {
    if (has_encoder(id)) (void)encoder(id);  // Counts from here; a failure counts from later.
  }
  tell_parameters();
}

bool Io7Link::has_motor(int id) const {
  return id >= IO7_MOTOR_FIRST && id <= IO7_MOTOR_LAST && letters_.has(IO7_MOTOR);
}
bool Io7Link::has_encoder(int id) const {
  return id >= IO7_ENCODER_FIRST && id <= IO7_ENCODER_LAST && letters_.has(IO7_ENCODER);
}
bool Io7Link::has_servo(int id) const {
  return id >= IO7_SERVO_FIRST && id <= IO7_SERVO_LAST && letters_.has(IO7_SERVO);
}
bool Io7Link::has_psd(int id) const {
  return id >= IO7_PSD_FIRST && id <= IO7_PSD_LAST && letters_.has(IO7_PSD);
}

Result<int> Io7Link::ask(const io7::Request& request, Time* asked) {
  return client_->exchange(request, asked).map([](const io7::Reply& reply) {
    return reply.values[0];
  });
}

Result<void> Io7Link::tell(const io7::Request& request) {
  return client_->exchange(request).map([](const io7::Reply&) {});
}

Result<void> Io7Link::motor_duty(int id, int percent) { return tell(io7::motor(id, percent)); }
Result<void> Io7Link::motor_speed(int id, int ticks_per_10ms) {
  return tell(io7::motor_speed(id, ticks_per_10ms));
}
Result<void> Io7Link::motor_pid(int id, int p, int i, int d) {
  {
    const std::lock_guard lock(parameters_);
    if (has_motor(id)) gains_[static_cast<std::size_t>(id) - 1] = Gains{p, i, d};
  }
  return tell(io7::pid(id, p, i, d));
}
Result<void> Io7Link::servo(int id, int position) { return tell(io7::servo(id, position)); }
Result<int> Io7Link::psd_raw(int id) { return ask(io7::psd(id)); }
Result<double> Io7Link::psd_metres(int) {
  return fail(Errc::Unsupported, "an IO7 board gives raw readings only; expected a PSD table");
}

// A board counts when it is asked. The answer may lie in a USB adapter for many milliseconds; where
// the question takes as long as the answer, a command does, too, and the one makes up for the
// other.
Result<BoardCount> Io7Link::encoder(int id) {
  if (!has_encoder(id)) return fail(Errc::Unsupported, "no encoder " + std::to_string(id));
  const std::lock_guard lock(counting_);
  const auto reading = plausible_count(id, clock_.now());
  if (!reading) return tl::unexpected(reading.error());
  const std::size_t index = static_cast<std::size_t>(id) - 1;
  counted_[index] = reading->asked;
  return BoardCount{counters_[index].feed16(reading->count, client_->generation()), reading->asked,
                    clock_.now() - reading->asked};
}

// Raw replies have no checksum: a flipped bit would be a jump of the robot. What the wheel can
// hardly have done is asked again, and believed when the board insists.
Result<Io7Link::Reading> Io7Link::plausible_count(int id, Time now) {
  const std::size_t index = static_cast<std::size_t>(id) - 1;
  const auto reach = [this](Time gap) {
    return static_cast<int>(fastest_ * to_seconds(gap)) + kSlackTicks;
  };
  const int most = reach(std::min<Time>(now - counted_[index], kUsualGap));
  std::optional<Reading> before;
  for (int attempt = 0; attempt < kCounts; ++attempt) {
    Time asked{0};
    const auto count = ask(io7::encoder(id), &asked);
    if (!count) return tl::unexpected(count.error());
    const auto bits = static_cast<std::uint16_t>(*count);
    const bool near = std::abs(counters_[index].step_to(bits, client_->generation())) <= most;
    const bool insists = before && std::abs(static_cast<std::int16_t>(static_cast<std::uint16_t>(
                                       bits - before->count))) <= reach(clock_.now() - asked);
    if (near || insists) return Reading{bits, asked};
    before = Reading{bits, asked};
  }
  return fail(Errc::Corrupt, "encoder " + std::to_string(id) + ": counts that do not fit");
}

std::unique_ptr<DriveController> Io7Link::make_drive(const BoardDriveShape& shape) {
  if (!vw_letters_) return nullptr;
  return std::make_unique<Io7Drive>(*client_, shape);
}

void Io7Link::tell_parameters() {
  told_generation_ = client_->generation();
  for (const BoardServoTable& servo : tables_.servos) {
    if (servo.lower_10us < 0 || !has_servo(servo.id) || !letters_.has(IO7_SERVO_LIMITS)) continue;
    if (!tell(io7::servo_limits(servo.id, servo.lower_10us, servo.upper_10us))) return;
  }
  const std::lock_guard lock(parameters_);
  for (std::size_t i = 0; i < gains_.size(); ++i) {
    if (!gains_[i]) continue;
    if (!tell(io7::pid(static_cast<int>(i) + 1, gains_[i]->p, gains_[i]->i, gains_[i]->d))) return;
  }
}

void Io7Link::look_after() {
  client_->look_after();
  if (client_->generation() != told_generation_) tell_parameters();
  if (const int id = longest_unread(); id != 0) (void)encoder(id);
}

// One at a time: over a slow line each question is one that the drive has to wait for.
int Io7Link::longest_unread() {
  const std::lock_guard lock(counting_);
  int unread = 0;
  Time before = clock_.now() - kCountPeriod;
  for (const int id : tables_.encoders) {
    if (!has_encoder(id)) continue;
    Time& tried = tried_[static_cast<std::size_t>(id) - 1];
    tried = std::max(tried, counted_[static_cast<std::size_t>(id) - 1]);
    if (tried > before) continue;
    before = tried;
    unread = id;
  }
  if (unread != 0) tried_[static_cast<std::size_t>(unread) - 1] = clock_.now();
  return unread;
}

}  // namespace eyebridge::hal
