#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::bridges {

/// Finds out that somebody besides the robot sends under its identifiers. Pure: is told what came,
/// in the order of the bus; no I/O.
///
/// A robot sends every message of one period once in a period, so between two of a kind there are
/// the others. A frame of another sender lies somewhere between two true ones: on one side of it
/// others are missing, wherever it lies and whatever is in it. That goes by order alone: frames
/// that are read late, all at once, do not look like a second sender.
class SenderWatch {
 public:
  /// A message of this function (EYECAN_S_…) came. False: this one or the one before it is foreign,
  /// and neither must be used. (An earlier one of which is_followed() was true may be.) Always true
  /// of messages that are not cyclic. `may_answer`: it can be the answer that
  /// expect_another() announced.
  bool heard(int function, Time now, bool may_answer = true);
  /// Whether enough others came after the last one of this function: it is the robot's own.
  [[nodiscard]] bool is_followed(int function, Time now) const;
  /// The robot will send one more of this function than it does by itself.
  void expect_another(int function, Time now);
  /// Whether this function was doubled within the last second.
  [[nodiscard]] bool is_doubled(int function, Time now) const;

  /// A command to the robot came that this program did not send. True for the second one within a
  /// second: a single one may be left over from a program that has just ended.
  bool other_host(Time now);
  /// The last command that other_host() was told of came from no program.
  void forget_other_host() { other_host_at_.reset(); }

  /// A function that has a second sender, told once in ten seconds; none: there is no news.
  std::optional<int> take_found();

 private:
  struct Kind {
    int function = 0;
    int period_ms = 0;
    bool counts = true;   ///< Sent once in a period, and not on other occasions.
    unsigned since = 0;   ///< Bit n: kind n came after the last one of this.
    unsigned before = 0;  ///< `since` when the last one came.
    int missed = 0;       ///< How often another of its period came twice while this did not come.
    std::optional<Time> at;
    std::optional<Time> another_until;
    bool answered = false;  ///< The last one was such an answer.
    std::optional<Time> doubled_at;
    std::optional<Time> named_at;
    int doubled = 0;  ///< How often, each within a second of the one before.
  };

  [[nodiscard]] std::optional<std::size_t> find(int function) const;
  /// The other kinds of its period that are being sent.
  [[nodiscard]] unsigned others(const Kind& kind, Time now) const;
  [[nodiscard]] bool enough(const Kind& kind, Time now) const;
  void note_doubled(Kind& kind, Time now);

  static constexpr std::size_t kKinds = 10;
  std::array<Kind, kKinds> kinds_ = first_kinds();
  static std::array<Kind, kKinds> first_kinds();
  std::optional<int> found_;
  std::optional<Time> other_host_at_;
};

}  // namespace eyebridge::bridges
