#include "mix/follow.hpp"

#include <utility>

#include "calls/interceptor.hpp"
#include "eyebridge/hal/passing_backend.hpp"

namespace eyebridge::hal {
namespace {

/// Brings a backend to the program's time and place.
Result<void> catch_up(const Follow& follow, Clock& own) {
  // A real clock keeps up by itself.
  if (follow.clock != nullptr && own.is_virtual()) own.wait_until(follow.clock->now());
  if (follow.world == nullptr) return {};
  const auto pose = follow.tracker->pose();
  if (!pose) return tl::unexpected(pose.error());
  return follow.world->set_robot_pose(0, *pose);
}

class Following final : public CallInterceptor {
 public:
  Following(const Follow& follow, Clock& own) : follow_(follow), own_(own) {}

  Result<Values> exchange(const Call& call,
                          const std::function<Result<Values>()>& device) override {
    if (const auto there = catch_up(follow_, own_); !there) return tl::unexpected(there.error());
    if (!follow_.leads || !follow_.tracker->follows_odometry() || call.name != "set_odometry") {
      return device();
    }
    const Pose pose{call.request[0], call.request[1], call.request[2]};
    return follow_.tracker->rebase(pose, [&] { return device().map([](const Values&) {}); })
        .map([] { return Values{}; });
  }

 private:
  const Follow follow_;
  Clock& own_;
};

/// A robot that jumps to where another one is. Its own simulation has it stand: what it would feel
/// of its motion would be invented.
class PutBackend final : public PassingBackend {
 public:
  using PassingBackend::PassingBackend;
  Device* find(DeviceKind kind, int id) override {
    const bool is_felt = kind == DeviceKind::Gyroscope || kind == DeviceKind::Accelerometer;
    return is_felt ? nullptr : inner_->find(kind, id);
  }
};

class FollowView final : public camera::View {
 public:
  FollowView(camera::View& inner, const Follow& follow, Clock& own)
      : inner_(inner), follow_(follow), own_(own) {}

  // A picture has no error: of a robot that is lost it is the one from where it was last.
  [[nodiscard]] world::Scene scene() const override {
    (void)catch_up(follow_, own_);
    return inner_.scene();
  }
  [[nodiscard]] camera::Eye eye() const override {
    (void)catch_up(follow_, own_);
    return inner_.eye();
  }
  [[nodiscard]] std::uint32_t carrier() const override { return inner_.carrier(); }
  [[nodiscard]] camera::ImageNoise noise() const override { return inner_.noise(); }
  [[nodiscard]] std::string texture_directory() const override {
    return inner_.texture_directory();
  }

 private:
  camera::View& inner_;
  const Follow follow_;
  Clock& own_;
};

}  // namespace

std::unique_ptr<Backend> make_following(std::unique_ptr<Backend> inner, const Follow& follow) {
  auto following = with_interceptor(std::move(inner), [&](Backend& backend) {
    return std::make_unique<Following>(follow, backend.clock());
  });
  if (follow.world == nullptr) return following;
  return std::make_unique<PutBackend>(std::move(following));
}

std::unique_ptr<camera::View> make_following_view(Backend& backend, const Follow& follow) {
  camera::View* const view = backend.camera_view();
  if (view == nullptr) return nullptr;
  return std::make_unique<FollowView>(*view, follow, backend.clock());
}

}  // namespace eyebridge::hal
