#include "eyebridge/bridges/client/sender_watch.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "eyebridge/bridges/can/table.hpp"
#include "opcodes.h"

namespace eyebridge::bridges {
namespace {

using namespace std::chrono_literals;

constexpr Time kWindow = 1s;
constexpr Time kNameAgain = 10s;
constexpr Time kAnswerTime = 200ms;
constexpr int kFoundAfter = 2;    // a lost frame or a late one may double another once
constexpr int kEnoughOthers = 2;  // one may lie on either side of a foreign frame
// A kind that no longer comes is not waited for. Both must be true: after a pause of the program
// the time alone would say so of every kind, and a flood of foreign frames reaches the number at
// once.
constexpr int kSilentPeriods = 5;
constexpr int kMissed = 50;

}  // namespace

std::array<SenderWatch::Kind, SenderWatch::kKinds> SenderWatch::first_kinds() {
  // Not Heartbeat and S_Status: RobotWatch finds a second sender of those.
  constexpr int kSent[kKinds] = {
      EYECAN_S_POSE,    EYECAN_S_SPEED,   EYECAN_S_ENC12, EYECAN_S_PSD_A,    EYECAN_S_PSD_B,
      EYECAN_S_PSD_RAW, EYECAN_S_DIGITAL, EYECAN_S_ENC34, EYECAN_S_ANALOG_A, EYECAN_S_ANALOG_B};
  std::array<Kind, kKinds> kinds{};
  for (std::size_t i = 0; i < kKinds; ++i) {
    kinds[i].function = kSent[i];
    kinds[i].period_ms = can::find_message(kSent[i], false)->period_ms;
    kinds[i].counts = kinds[i].function != EYECAN_S_DIGITAL;  // on change, too
  }
  return kinds;
}

std::optional<std::size_t> SenderWatch::find(int function) const {
  const auto found = std::ranges::find(kinds_, function, &Kind::function);
  if (found == kinds_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kinds_.begin());
}

unsigned SenderWatch::others(const Kind& kind, Time now) const {
  unsigned mask = 0;
  for (std::size_t i = 0; i < kKinds; ++i) {
    const Kind& other = kinds_[i];
    const Time silent = kSilentPeriods * std::chrono::milliseconds(other.period_ms);
    const bool is_sent = other.at && (other.missed < kMissed || now - *other.at <= silent);
    if (&other != &kind && other.period_ms == kind.period_ms && is_sent) mask |= 1U << i;
  }
  return mask;
}

bool SenderWatch::enough(const Kind& kind, Time now) const {
  return std::popcount(kind.since) >= std::min(kEnoughOthers, std::popcount(others(kind, now)));
}

bool SenderWatch::heard(int function, Time now, bool may_answer) {
  const auto index = find(function);
  if (!index) return true;
  Kind& kind = kinds_[*index];
  bool is_usable = true;
  bool is_answer = false;
  if (kind.at && kind.counts && !enough(kind, now)) {
    is_answer = may_answer && kind.another_until && now <= *kind.another_until;
    // Some of the others came before a foreign frame, the rest behind it. A frame that was lost
    // came on neither side; an answer splits them as a foreign frame does.
    const bool is_split = kind.since != 0 && (kind.since & kind.before) == 0 &&
                          (kind.since | kind.before) == others(kind, now) && !kind.answered;
    is_usable = is_answer || kind.since != 0;
    if (is_answer) {
      kind.another_until.reset();
    } else if (kind.since == 0 || is_split) {
      note_doubled(kind, now);
    }
  }
  kind.answered = is_answer;
  for (std::size_t i = 0; i < kKinds; ++i) {
    Kind& other = kinds_[i];
    if (i == *index || other.period_ms != kind.period_ms) continue;
    other.since |= 1U << *index;
    if ((kind.since & 1U << i) == 0) ++other.missed;
  }
  kind.before = kind.since;
  kind.since = 0;
  kind.missed = 0;
  kind.at = now;
  return is_usable;
}

bool SenderWatch::is_followed(int function, Time now) const {
  const auto index = find(function);
  return !index || enough(kinds_[*index], now);
}

void SenderWatch::expect_another(int function, Time now) {
  if (const auto index = find(function)) kinds_[*index].another_until = now + kAnswerTime;
}

bool SenderWatch::is_doubled(int function, Time now) const {
  const auto index = find(function);
  if (!index) return false;
  const std::optional<Time>& at = kinds_[*index].doubled_at;
  return at && now - *at <= kWindow;
}

void SenderWatch::note_doubled(Kind& kind, Time now) {
  const bool again = kind.doubled_at && now - *kind.doubled_at <= kWindow;
  kind.doubled = again ? kind.doubled + 1 : 1;
  kind.doubled_at = now;
  if (kind.doubled < kFoundAfter || (kind.named_at && now - *kind.named_at < kNameAgain)) return;
  kind.named_at = now;
  found_ = kind.function;
}

bool SenderWatch::other_host(Time now) {
  const bool again = other_host_at_ && now - *other_host_at_ <= kWindow;
  other_host_at_ = now;
  return again;
}

std::optional<int> SenderWatch::take_found() { return std::exchange(found_, std::nullopt); }

}  // namespace eyebridge::bridges
