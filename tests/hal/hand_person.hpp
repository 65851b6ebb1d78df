#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/pose_finder.hpp"
#include "eyebridge/camera/source.hpp"
#include "hand/instruction.hpp"

namespace eyebridge::hal {

/// Where a person holds the camera, and what they were told last.
struct Hand {
  std::mutex mutex;
  Pose robot{1.0, 1.0, 0.0};  ///< Where the robot is that the camera belongs to.
  Pose camera_in_robot;
  bool is_lost = false;
  bool walks_on = false;  ///< Goes on with what they were told when the robot is lost.
  double noise = 0.0;     ///< Of the pose found, m and rad.
  double linear = 0.2;    ///< How fast the person walks, m/s …
  double angular = 1.0;   ///< … and turns, rad/s.
  std::vector<camera::SeenFiducial> seen;  ///< In each frame.
  std::array<double, 9> covariance{};      ///< Of the pose found.
  Instruction told;
  Instruction doing;  ///< The last that was not "lost".
  Time last{0};
  int frames = 0;
  int width = 0;  ///< Of the last frame.
};

/// Keeps what the person is told.
class HandEye final : public InstructionSink {
 public:
  explicit HandEye(std::shared_ptr<Hand> hand) : hand_(std::move(hand)) {}
  void show(Time, const Instruction& instruction) override {
    const std::lock_guard lock(hand_->mutex);
    if (instruction.kind != Instruction::Kind::Lost) hand_->doing = instruction;
    hand_->told = instruction;
  }
  void finish() override {}

 private:
  std::shared_ptr<Hand> hand_;
};

/// A person who does what they are told between two frames, and a finder that knows where they are.
class PersonFinder final : public camera::PoseFinder {
 public:
  explicit PersonFinder(std::shared_ptr<Hand> hand) : hand_(std::move(hand)) {}

  std::optional<camera::FoundPose> take(const camera::Frame& frame) override {
    const std::lock_guard lock(hand_->mutex);
    ++hand_->frames;
    hand_->width = frame.width;
    walk(to_seconds(frame.time - hand_->last));
    hand_->last = frame.time;
    seen_ = hand_->seen;
    if (hand_->is_lost) return std::nullopt;
    camera::FoundPose found;
    found.time = frame.time;
    found.pose = transform(hand_->robot, hand_->camera_in_robot);
    found.covariance = hand_->covariance;
    found.pose.x += hand_->noise * random_.gaussian();
    found.pose.y += hand_->noise * random_.gaussian();
    found.pose.theta = wrap_angle(found.pose.theta + hand_->noise * random_.gaussian());
    return found;
  }

  [[nodiscard]] const std::vector<camera::SeenFiducial>& seen() const override { return seen_; }

 private:
  void walk(double seconds) {
    const Instruction& told = hand_->walks_on ? hand_->doing : hand_->told;
    Twist twist;
    if (told.kind == Instruction::Kind::Speed) twist = told.speed;
    if (told.kind == Instruction::Kind::Goal) {
      twist.linear = told.distance == 0.0 ? 0.0 : std::copysign(hand_->linear, told.distance);
      twist.angular = told.angle == 0.0 ? 0.0 : std::copysign(hand_->angular, told.angle);
      // Both ends of a curve at once.
      if (told.distance != 0.0 && told.angle != 0.0) {
        twist.angular = told.angle / std::abs(told.distance) * hand_->linear;
      }
    }
    const double turn = twist.angular * seconds;
    const Vec2 way = Heading::from_angle(0.5 * turn).rotate({twist.linear * seconds, 0.0});
    hand_->robot = transform(hand_->robot, {way.x, way.y, turn});
  }

  std::shared_ptr<Hand> hand_;
  Random random_{5};
  std::vector<camera::SeenFiducial> seen_;
};

/// A camera of 30 frames a second, small and grey; `trouble` makes it fail.
class PlainCamera final : public camera::Source {
 public:
  PlainCamera(Clock& clock, std::shared_ptr<std::optional<Error>> trouble)
      : clock_(clock), trouble_(std::move(trouble)) {}

  Result<void> set_size(int, int) override { return {}; }
  [[nodiscard]] camera::Size natural_size() const override { return {64, 48}; }
  Result<camera::FramePtr> next(Time deadline) override {
    if (*trouble_) return tl::unexpected(**trouble_);
    const Time period = from_seconds(1.0 / 30);
    const Time due = (clock_.now() / period + (clock_.now() % period != Time(0) ? 1 : 0)) * period;
    const Time next = std::max(due, last_ + period);
    if (next > deadline) {
      clock_.wait_until(deadline);
      return fail(Errc::Timeout, "camera: no frame");
    }
    clock_.wait_until(next);
    last_ = next;
    camera::Frame frame = camera::make_frame(64, 48, camera::PixelFormat::Rgb24);
    frame.time = next;
    frame.sequence = sequence_++;
    return std::make_shared<const camera::Frame>(std::move(frame));
  }

 private:
  Clock& clock_;
  std::shared_ptr<std::optional<Error>> trouble_;
  Time last_{-1'000'000'000};
  std::uint64_t sequence_ = 0;
};

}  // namespace eyebridge::hal
