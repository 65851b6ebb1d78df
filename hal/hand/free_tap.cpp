#include "hand/free_tap.hpp"

#include <mutex>
#include <optional>
#include <utility>

#include "hand/movement.hpp"
#include "tap/tap.hpp"
#include "tap/values.hpp"

namespace eyebridge::hal {
namespace {

class FreeTap final : public Tap {
 public:
  FreeTap(Backend& robot, std::unique_ptr<InstructionSink> display)
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
  const std::unique_ptr<InstructionSink> display_;
  std::mutex mutex_;
  Movement movement_;
  std::optional<Pose> last_;
};

}  // namespace

std::unique_ptr<Backend> with_shown_drive(std::unique_ptr<Backend> inner,
                                          std::unique_ptr<InstructionSink> display) {
  return make_tapped(std::move(inner), [&](Backend& robot) {
    return std::make_unique<FreeTap>(robot, std::move(display));
  });
}

}  // namespace eyebridge::hal
