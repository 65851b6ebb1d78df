#include "mix/pose_tracker.hpp"

namespace eyebridge::hal {
Result<void> PoseTracker::begin(Source source, bool is_odometry, const Pose& start) {
  return source().map([&](const Pose& there) {
    source_ = std::move(source);
    is_odometry_ = is_odometry;
    world_ = start;
    there_ = there;
  });
}

void PoseTracker::follow(Source source) { source_ = std::move(source); }

Result<Pose> PoseTracker::pose_now() {
  return source_().map(
      [this](const Pose& now) { return transform(world_, relative_to(there_, now)); });
}

Result<Pose> PoseTracker::pose() {
  const std::lock_guard lock(mutex_);
  return pose_now();
}

Result<void> PoseTracker::rebase(const Pose& odometry, const std::function<Result<void>()>& set) {
  const std::lock_guard lock(mutex_);
  const auto before = pose_now();
  if (!before) return tl::unexpected(before.error());
  return set().map([&] {
    world_ = *before;
    there_ = odometry;
  });
}

}  // namespace eyebridge::hal
