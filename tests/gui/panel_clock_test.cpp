// When something was read or written, as the panel tells it, though time went otherwise since.
#include <gtest/gtest.h>

#include "eyebridge/hal/device_notes.hpp"
#include "keys.hpp"
#include "panel/inspector.hpp"
#include "panel/stamp_times.hpp"

namespace eyebridge::gui {
namespace {

using namespace std::chrono_literals;

/// Shows what the test says. Of moments that have been it knows nothing, as a clock whose pace has
/// changed since.
class ScriptedClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override { return now_; }
  [[nodiscard]] Time at(Time /*moment*/) const override { return now_ - 1000s; }
  void wait_until(Time deadline) override { now_ = deadline; }
  void spend(Time /*cost*/) override {}
  [[nodiscard]] bool is_virtual() const override { return false; }

 private:
  Time now_{0};
};

TEST(PanelClock, ANoteFromAPauseIsShownWithTheTimeAtWhichItStood) {
  ScriptedClock clock;
  hal::DeviceNotes notes(clock);
  hal::NoteCell& cell = notes.add("psd", 1, "FRONT", hal::Quantity::Distance);
  robios::Keys keys(clock, {}, nullptr);
  clock.wait_until(2s);
  Inspector inspector(notes, keys, nullptr);
  const auto time = [&] {
    return inspector.find("Distance sensors (PSD)/FRONT (1)")->text(Inspector::kTime);
  };
  cell.put(notes.stamp(), {0.5});
  inspector.look();  // paused: its clock stands at two seconds …
  clock.wait_until(90s);
  inspector.look();  // … and a moment later, much faster, it shows another time
  inspector.refresh();
  EXPECT_EQ(time(), "2.00 s");
}

TEST(PanelClock, BetweenTwoLooksTimeIsTakenToGoEvenly) {
  ScriptedClock clock;
  hal::DeviceNotes notes(clock);
  clock.wait_until(10s);
  StampTimes times(notes);
  const Time first = notes.stamp();
  while (notes.stamp() == first) {
  }  // a tick of the computer's coarse clock
  const Time second = notes.stamp();
  clock.wait_until(20s);
  times.look();
  EXPECT_GT(times.time_of(second), times.time_of(first));
  EXPECT_LE(times.time_of(second), 20s);
  EXPECT_GE(times.time_of(first), 10s);
  EXPECT_EQ(times.time_of(first - 1s), 20s - 1000s) << "older ones as the clock says";
}

}  // namespace
}  // namespace eyebridge::gui
