#pragma once

#include "eyebridge/hal/device_notes.hpp"

namespace eyebridge::gui {

/// What the program's clock showed when a note was made, however time was paused, stepped or made
/// faster since: a clock knows its present pace only, so it is looked at often.
class StampTimes {
 public:
  /// `notes` is lent.
  explicit StampTimes(const hal::DeviceNotes& notes);

  /// Some ten times a second at least: the pace between two looks is taken to be even.
  void look();
  /// Exact in virtual time. Else of a stamp from before the last look and after the one before
  /// that; of an older one as the clock itself says.
  [[nodiscard]] Time time_of(Time stamp) const;

 private:
  struct Moment {
    Time stamp;
    Time time;
  };
  [[nodiscard]] Moment now() const { return {notes_.stamp(), notes_.now()}; }

  const hal::DeviceNotes& notes_;
  Moment last_;
  Moment before_;
};

}  // namespace eyebridge::gui
