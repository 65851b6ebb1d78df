#include "remote_robot/remote_robot.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "calls/absent_robot.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/hal/passing_backend.hpp"
#include "remote_robot/remote_clock.hpp"
#include "remote_robot/remote_view.hpp"
#include "remote_robot/remote_world.hpp"
#include "remote_robot/robot_line.hpp"

namespace eyebridge::hal {
namespace {

/// Asks the server in every call of a device.
class RemoteCalls final : public CallInterceptor {
 public:
  explicit RemoteCalls(RobotLine& line) : line_(line) {}
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
  RobotLine& line_;
};

class RemoteRobot final : public PassingBackend {
 public:
  RemoteRobot(std::unique_ptr<RobotLine> line, RobotWelcome welcome, WorldLoader world,
              double factor)
      : PassingBackend(
            with_interceptor(make_absent_robot(welcome.devices),
                             [&](Backend&) { return std::make_unique<RemoteCalls>(*line); })),
        line_(std::move(line)),
        welcome_(std::move(welcome)),
        clock_(make_remote_clock(*line_, welcome_.is_virtual, factor)),
        world_(*line_) {
    if (welcome_.has_view) {
      view_.emplace(*line_, std::move(world), welcome_.carrier, welcome_.texture_directory);
    }
  }

  Clock& clock() override { return *clock_; }
  void arrive() override {
    // In real time the server did not welcome it before.
    if (welcome_.is_virtual) static_cast<void>(line_->ask({"robot", 1, "arrive", true, {}}));
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
    // Where the server is gone, who has it stops the robot, a simulated one.
    static_cast<void>(line_->ask({"robot", 1, "stop", true, {}}));
    return {};
  }

 private:
  std::unique_ptr<RobotLine> line_;
  const RobotWelcome welcome_;
  std::unique_ptr<Clock> clock_;
  RemoteWorld world_;
  std::optional<RemoteView> view_;
};

}  // namespace

std::unique_ptr<Backend> make_remote_robot(UniqueFd socket, WorldLoader world, double factor) {
  auto line = std::make_unique<RobotLine>(std::move(socket));
  Result<RobotWelcome> welcome = line->hello();
  if (!welcome) throw ConfigError({}, welcome.error().what);
  return std::make_unique<RemoteRobot>(std::move(line), std::move(*welcome), std::move(world),
                                       factor);
}

}  // namespace eyebridge::hal
