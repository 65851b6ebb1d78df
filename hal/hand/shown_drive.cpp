#include "hand/shown_drive.hpp"

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "calls/interceptor.hpp"
#include "calls/values.hpp"
#include "eyebridge/hal/hand_guide.hpp"
#include "eyebridge/hal/passing_backend.hpp"
#include "hand/movement.hpp"

namespace eyebridge::hal {
namespace {

/// Passes instructions on, and keeps the last one for a window.
class KeptInstruction final : public InstructionSink, public HandGuide {
 public:
  explicit KeptInstruction(std::unique_ptr<InstructionSink> display)
      : display_(std::move(display)) {}

  void show(Time now, const Instruction& instruction) override {
    {
      const std::lock_guard lock(mutex_);
      last_ = instruction;
    }
    display_->show(now, instruction);
  }
  void finish() override { display_->finish(); }
  [[nodiscard]] HandLook look() const override {
    const std::lock_guard lock(mutex_);
    HandLook look;
    look.instruction = last_;
    return look;
  }

 private:
  const std::unique_ptr<InstructionSink> display_;
  mutable std::mutex mutex_;
  Instruction last_;
};

class ShownDrive final : public CallInterceptor {
 public:
  ShownDrive(Backend& robot, std::shared_ptr<InstructionSink> display)
      : clock_(robot.clock()), drive_(*robot.drive()), display_(std::move(display)) {}

  Result<Values> exchange(const Call& call,
                          const std::function<Result<Values>()>& device) override {
    Result<Values> reply = device();
    if (call.device == "drive" && reply) follow(call, *reply);
    return reply;
  }

  void finish() noexcept override {
    try {
      const std::lock_guard lock(mutex_);
      movement_.stop();
      show();
      display_->finish();
    } catch (...) {
      // The motors are stopped; nobody can be told.
    }
  }

 private:
  void follow(const Call& call, const Values& reply) {
    const Result<Pose> odometry = drive_.odometry();
    if (!odometry) return;  // the program's own calls will say so
    const std::lock_guard lock(mutex_);
    if (last_) movement_.moved(*last_, *odometry);
    last_ = *odometry;
    if (call.name == "set_speed") movement_.set_speed(AsValues<Twist>::unpack(call.request));
    if (call.name == "start") {
      movement_.start({call.request[0], call.request[1], call.request[2]}, *odometry);
    }
    // The drive knows best when it is done, or has given up.
    const bool is_over = call.name == "status" &&
                         AsValues<DriveStatus>::unpack(reply).progress != DriveProgress::Driving;
    if (is_over && movement_.driving()) movement_.stop();
    show();
  }

  void show() { display_->show(clock_.now(), movement_.instruction()); }

  Clock& clock_;
  Drive& drive_;
  const std::shared_ptr<InstructionSink> display_;
  std::mutex mutex_;
  Movement movement_;
  std::optional<Pose> last_;
};

class FreeBackend final : public PassingBackend {
 public:
  FreeBackend(std::unique_ptr<Backend> inner, std::shared_ptr<HandGuide> guide)
      : PassingBackend(std::move(inner)), guide_(std::move(guide)) {}
  HandGuide* hand_guide() override { return guide_.get(); }

 private:
  const std::shared_ptr<HandGuide> guide_;
};

}  // namespace

std::unique_ptr<Backend> with_shown_drive(std::unique_ptr<Backend> inner,
                                          std::unique_ptr<InstructionSink> display) {
  auto kept = std::make_shared<KeptInstruction>(std::move(display));
  auto shown = with_interceptor(
      std::move(inner), [&](Backend& robot) { return std::make_unique<ShownDrive>(robot, kept); });
  return std::make_unique<FreeBackend>(std::move(shown), kept);
}

}  // namespace eyebridge::hal
