// How an IO7 board is stopped: by its program, and in its guard's words.
#include "io7_stop.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include "eyebridge/bridges/guard/line_guard.hpp"
#include "io7_session.hpp"
#include "opcodes.h"

namespace eyebridge::bridges {
namespace {

// Nothing answers a command: on a line that spoils one the next one counts.
constexpr int kStops = 2;
// One that is known to flip bits may turn the last 0 into a 1: then the encoders have the last
// word.
constexpr int kNoisyStops = 10;
constexpr Time kBetweenLooks = std::chrono::milliseconds(100);
constexpr int kMostQuestions = 30;
constexpr int kWheels = 2;  // that encoders are at

bool has_non_zero(const io7::Request& request, std::size_t first) {
  return std::any_of(request.arguments.begin() + static_cast<std::ptrdiff_t>(first),
                     request.arguments.begin() + request.count,
                     [](int argument) { return argument != 0; });
}

/// Whether wheels may turn once the board has `request`.
bool may_turn(const io7::Request& request) {
  switch (request.letter) {
    case IO7_MOTOR:
    case IO7_MOTOR_SPEED:
      return has_non_zero(request, 1);
    case IO7_VW_SET_SPEED:
      return has_non_zero(request, 0);
    default:
      return is_movement(request.letter);
  }
}

/// What makes all motors of a board stand, in this order.
std::vector<io7::Request> stop_requests(const io7::Profile& profile) {
  std::vector<io7::Request> requests;
  // First: a board that drives by itself would go down its ramp.
  if (profile.vw_letters && profile.letters.has(IO7_VW_SET_SPEED)) {
    requests.push_back(io7::request(IO7_VW_SET_SPEED, 0, 0));
  }
  const bool plain = profile.letters.has(IO7_MOTOR);
  if (!plain && !profile.letters.has(IO7_MOTOR_SPEED)) return requests;
  for (int motor = IO7_MOTOR_FIRST; motor <= IO7_MOTOR_LAST; ++motor) {
    requests.push_back(plain ? io7::motor(motor, 0) : io7::motor_speed(motor, 0));
  }
  return requests;
}

}  // namespace

StopOrders stop_orders(const io7::ProbeReport& report) {
  StopOrders orders;
  orders.count = 1;
  StopOrders::Bytes& bytes = orders.writes[0];
  const io7::Profile& profile = report.profile;
  // Ends what the program may have sent in part.
  const bool speaks_lines = profile.request_form == io7::RequestForm::Ascii;
  if (speaks_lines) {
    (void)bytes.add(io7::bytes_of(profile.terminator));
  } else {
    (void)orders.completion.add(kIo7Completion);
  }
  const auto add = [&](const io7::Request& request) {
    if (const auto encoded = io7::encode(request, profile)) (void)bytes.add(encoded->view());
  };
  for (const io7::Request& request : stop_requests(profile)) add(request);
  add(io7::request(IO7_VERSION));
  if (speaks_lines) (void)orders.question.add(io7::bytes_of(profile.terminator));
  if (const auto version = io7::encode(io7::request(IO7_VERSION), profile)) {
    (void)orders.question.add(version->view());
  }
  for (const char character : report.version) {
    const auto byte = static_cast<std::uint8_t>(character);
    (void)orders.answer.add({&byte, 1});
  }
  orders.mask = orders.answer;
  orders.mask.bytes.fill(0xFF);
  return orders;
}

void Io7Session::note_turning(const io7::Request& request) {
  turning_ = turning_ || may_turn(request);
}

void Io7Session::tell_guard(Time now) {
  if (guard_ == nullptr || !turning_) return;
  if (!guard_->turning(now)) guard_ = nullptr;
}

Result<void> Io7Session::stop_motors() {
  for (const io7::Request& request : stop_requests(report_.profile)) {
    if (const auto done = exchange(request); !done) return tl::unexpected(done.error());
  }
  return {};
}

bool Io7Session::wheels_stand() {
  if (!report_.profile.letters.has(IO7_ENCODER)) return false;
  std::array<int, kWheels> before{};
  for (int look = 0; look < 2; ++look) {
    // By asking, not by waiting: in virtual time a wait steps the world, and that asks us.
    const Time until = clock_.now() + kBetweenLooks;
    for (int i = 0; look > 0 && i < kMostQuestions && clock_.now() < until; ++i) {
      if (!exchange(io7::request(IO7_VERSION))) return false;
    }
    for (int wheel = 0; wheel < kWheels; ++wheel) {
      const auto count = exchange(io7::encoder(wheel + 1));
      if (!count) return false;
      const auto i = static_cast<std::size_t>(wheel);
      if (look > 0 && count->values[0] != before[i]) return false;
      before[i] = count->values[0];
    }
  }
  return true;
}

Result<void> Io7Session::confirm_stop() {
  for (int i = 0; i < (noisy() ? kNoisyStops : kStops); ++i) {
    if (auto stopped = stop_motors(); !stopped) return stopped;
    if (const auto heard = exchange(io7::request(IO7_VERSION)); !heard) {
      return tl::unexpected(heard.error());
    }
    if (i + 1 >= kStops && noisy() && wheels_stand()) break;
  }
  turning_ = false;
  if (guard_ != nullptr && !guard_->still()) guard_ = nullptr;
  return {};
}

}  // namespace eyebridge::bridges
