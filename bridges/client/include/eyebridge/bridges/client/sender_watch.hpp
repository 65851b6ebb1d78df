#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

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
  /// A message of this function (EYECAN_S_…) came. False: it or the one before it is another's, and
  /// neither is to be used unless is_followed() was true of it. True for all that are not cyclic.
  bool heard(int function, Time now);
  /// Whether enough others came after the last one of this function: it is the robot's own.
  [[nodiscard]] bool is_followed(int function, Time now) const;
  /// The robot will send one more of this function than it does by itself.
  void expect_another(int function, Time now);
  /// Whether this function was doubled within the last second.
  [[nodiscard]] bool is_doubled(int function, Time now) const;

  /// A command to the robot came that this program did not send; true when it is one too many.
  bool other_host(Time now);

  /// The function whose second sender nobody knows of yet, each once in ten seconds.
  std::optional<int> take_found();

 private:
  struct Kind {
    int function = 0;
    int period_ms = 0;
    bool counts = true;   ///< Sent once in a period and never besides.
    unsigned since = 0;   ///< Bit n: kind n came after the last one of this.
    unsigned before = 0;  ///< `since` when the last one came.
    int missed = 0;       ///< So often did another of its period come twice without it.
    std::optional<Time> at;
    std::optional<Time> another_until;
    std::optional<Time> doubled_at;
    std::optional<Time> named_at;
    int doubled = 0;  ///< Within a second of each other.
  };

  [[nodiscard]] const Kind* find(int function) const;
  Kind* find(int function) { return const_cast<Kind*>(std::as_const(*this).find(function)); }
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
