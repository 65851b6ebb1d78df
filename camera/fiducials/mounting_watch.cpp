#include "fiducials/mounting_watch.hpp"

#include <cmath>
#include <optional>

#include "fiducials/vision.hpp"
#include "pictures/turn.hpp"

namespace eyebridge::camera {
namespace {

constexpr int kEnough = 10;         // frames that agree
constexpr int kMirrorEvery = 5;     // looking at a mirror image costs as much as the picture
constexpr int kEnoughMirrored = 3;  // of them
constexpr int kMostEmpty = 500;     // then there are just no fiducials
constexpr int kMirroredByExif = 2;

/// Quarters clockwise that a fiducial is turned by in the picture.
int quarters_of(const SeenFiducial& seen) {
  const Vec2 along = seen.corners[1] - seen.corners[0];  // its upper edge, y downwards
  if (std::fabs(along.x) >= std::fabs(along.y)) return along.x >= 0 ? 0 : 2;
  return along.y >= 0 ? 1 : 3;
}

}  // namespace

std::string MountingWatch::look(const Frame& frame, const std::vector<SeenFiducial>& seen,
                                const Vision& vision, FiducialFamily family) {
  if (is_over_) return {};
  std::string what = seen.empty() ? look_mirrored(frame, vision, family) : count_turn(seen);
  is_over_ = is_over_ || !what.empty();
  return what;
}

std::string MountingWatch::count_turn(const std::vector<SeenFiducial>& seen) {
  empty_ = kMostEmpty;  // they are seen: the picture is not mirrored
  std::optional<int> all;
  for (const SeenFiducial& one : seen) {
    const int quarters = quarters_of(one);
    if (all && *all != quarters) return {};
    all = quarters;
  }
  agreeing_ = *all == turn_ ? agreeing_ + 1 : 1;
  turn_ = *all;
  if (agreeing_ < kEnough) return {};
  is_over_ = true;
  switch (turn_) {
    case 1:
      return "fiducials are seen lying on their side: a camera that is mounted so has ?rotate=270";
    case 2:
      return "fiducials are seen upside down: a camera that is mounted so has ?rotate=180";
    case 3:
      return "fiducials are seen lying on their side: a camera that is mounted so has ?rotate=90";
    default:
      return {};
  }
}

std::string MountingWatch::look_mirrored(const Frame& frame, const Vision& vision,
                                         FiducialFamily family) {
  if (empty_ >= kMostEmpty || ++empty_ % kMirrorEvery != 0) return {};
  if (vision.find_fiducials(upright(frame, kMirroredByExif), family).empty()) return {};
  if (++mirrored_ < kEnoughMirrored) return {};
  return "fiducials are seen in the mirror image alone: such a camera has ?flip=h";
}

}  // namespace eyebridge::camera
