#include "seat/seat_robot.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/hal/passing_backend.hpp"
#include "seat/seat_clock.hpp"
#include "seat/seat_line.hpp"
#include "seat/seat_view.hpp"
#include "seat/seat_world.hpp"
#include "tap/absent_robot.hpp"

namespace eyebridge::hal {
namespace {

/// Asks the seat in every call of a device.
class SeatTap final : public Tap {
 public:
  explicit SeatTap(SeatLine& line) : line_(line) {}
  Result<Values> exchange(const Call& call,
                          const std::function<Result<Values>()>& device) override {
    if (call.device == "lidar" && !call.is_command) {
      Result<Values> fits = device();
      if (!fits && fits.error().code == Errc::OutOfRange) return fits;
    }
    Result<Values> reply = line_.ask(call);
    // There is nothing behind it, but a lidar that keeps the shape of its scans.
    if (call.is_command && reply) (void)device();
    return reply;
  }

 private:
  SeatLine& line_;
};

class SeatRobot final : public PassingBackend {
 public:
  SeatRobot(std::unique_ptr<SeatLine> line, SeatWelcome welcome, WorldLoader world, double factor)
      : PassingBackend(make_tapped(make_absent_robot(welcome.devices),
                                   [&](Backend&) { return std::make_unique<SeatTap>(*line); })),
        line_(std::move(line)),
        welcome_(std::move(welcome)),
        clock_(make_seat_clock(*line_, welcome_.is_virtual, factor)),
        world_(*line_) {
    if (welcome_.has_view) {
      view_.emplace(*line_, std::move(world), welcome_.carrier, welcome_.texture_directory);
    }
  }

  Clock& clock() override { return *clock_; }
  void arrive() override {
    // In real time the seat did not welcome it before.
    if (welcome_.is_virtual) static_cast<void>(line_->ask({"seat", 1, "arrive", true, {}}));
  }
  [[nodiscard]] int robot_id() const override { return welcome_.robot_id; }
  [[nodiscard]] RadioConditions radio_conditions() const override { return welcome_.radio; }
  WorldControl* world() override { return welcome_.has_world ? &world_ : nullptr; }
  camera::View* camera_view() override { return view_ ? &*view_ : nullptr; }
  std::vector<DeviceFacts> facts_of(std::string_view kind) override {
    const auto found = std::ranges::find_if(
        welcome_.facts, [&](const auto& of_kind) { return of_kind.first == kind; });
    return found == welcome_.facts.end() ? std::vector<DeviceFacts>{} : found->second;
  }
  void trace_to(TraceSink* sink) override { line_->trace_to(sink); }
  Result<void> stop() noexcept override {
    // Where the seat is gone, who has it stops the robot, a simulated one.
    static_cast<void>(line_->ask({"seat", 1, "stop", true, {}}));
    return {};
  }

 private:
  std::unique_ptr<SeatLine> line_;
  const SeatWelcome welcome_;
  std::unique_ptr<Clock> clock_;
  SeatWorld world_;
  std::optional<SeatView> view_;
};

}  // namespace

std::unique_ptr<Backend> make_seat_robot(UniqueFd socket, WorldLoader world, double factor) {
  auto line = std::make_unique<SeatLine>(std::move(socket));
  Result<SeatWelcome> welcome = line->hello();
  if (!welcome) throw ConfigError({}, welcome.error().what);
  return std::make_unique<SeatRobot>(std::move(line), std::move(*welcome), std::move(world),
                                     factor);
}

}  // namespace eyebridge::hal
