#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/pose_finder.hpp"
#include "fiducials/localise.hpp"
#include "fiducials/mounting_watch.hpp"
#include "fiducials/pose_filter.hpp"
#include "fiducials/vision.hpp"
#include "optics/lens_distortion.hpp"

namespace eyebridge::camera {
namespace {

/// Without a usable fiducial for longer the camera is lost.
constexpr Time kLostAfter{300'000'000};
/// How long the last pose helps to tell two possible ones apart.
constexpr Time kForgottenAfter{2'000'000'000};
/// A sighting that misses by more than this does not belong to the pose, pixels.
constexpr double kTolerance = 3.0;
/// So many frames more that do not fit than frames that do: it is the wrong world.
constexpr int kMisfitsToReport = 15;
/// Farther than one can have gone while the camera was lost, metres and metres per second.
constexpr double kJump = 0.5;
constexpr double kFastest = 2.0;
constexpr int kJumpsToReport = 3;

class FiducialFinder final : public PoseFinder {
 public:
  FiducialFinder(const std::vector<Fiducial>& map, const Calibration& lens, LogSink& log,
                 std::string world)
      : calibration_(lens),
        log_(log),
        world_(std::move(world)),
        vision_(vision()),
        family_(map.front().family) {
    for (const Fiducial& fiducial : map) places_.emplace(fiducial.id, corners_of(fiducial));
  }

  std::optional<FoundPose> take(const Frame& frame) override {
    if (lens_.size != Size{frame.width, frame.height}) {
      lens_ = scaled(calibration_, {frame.width, frame.height});
    }
    const std::vector<Sighting> sightings = sightings_in(frame);
    if (const std::string what = mounting_.look(frame, seen_, vision_, family_); !what.empty()) {
      log_.write(Severity::Warning, what);
    }
    if (filter_ && frame.time - last_fix_ > kLostAfter) filter_.reset();
    const int used = filter_ ? follow(sightings, frame.time) : find(sightings, frame.time);
    judge(sightings.size(), used);
    if (used > 0) {
      last_fix_ = frame.time;
      last_pose_ = filter_->pose();
    }
    if (!filter_) return std::nullopt;
    return found(frame.time, used);
  }

  [[nodiscard]] const std::vector<SeenFiducial>& seen() const override { return seen_; }

 private:
  std::vector<Sighting> sightings_in(const Frame& frame) {
    std::vector<Sighting> sightings;
    strangers_ = 0;
    seen_ = vision_.find_fiducials(frame, family_);
    for (const SeenFiducial& seen : seen_) {
      const auto place = places_.find(seen.id);
      if (place == places_.end()) {
        ++strangers_;
        continue;
      }
      Sighting sighting{seen.id, place->second, {}};
      for (std::size_t i = 0; i < 4; ++i) {
        sighting.pixels[i] = to_pixel(lens_, undistorted(lens_, to_plane(lens_, seen.corners[i])));
      }
      sightings.push_back(sighting);
    }
    return sightings;
  }

  /// Goes on from the last frame; how many fiducials agreed.
  int follow(const std::vector<Sighting>& sightings, Time time) {
    filter_->predict(time);
    if (sightings.empty()) return 0;
    const auto prior = filter_->prior();
    if (!prior) return 0;
    std::vector<Sighting> used = sightings;
    auto fit = fit_pose(used, lens_, *prior, prior->mean);
    // What does not agree goes, the rest is fitted again.
    for (int round = 0; fit && round < 2; ++round) {
      std::vector<Sighting> agreeing = inliers_of(sightings, lens_, fit->pose, kTolerance);
      if (agreeing.size() == used.size()) break;
      used = std::move(agreeing);
      if (used.empty()) break;
      fit = fit_pose(used, lens_, *prior, fit->pose);
    }
    if (fit && 2 * used.size() > sightings.size() && is_plausible(fit->pose)) {
      filter_->update(*fit);
      return static_cast<int>(used.size());
    }
    // A camera that was carried off: two that agree are more trustworthy than what was expected.
    const auto elsewhere = localise(sightings, lens_, &*last_pose_, vision_);
    if (!elsewhere || elsewhere->inliers.size() < 2) return 0;
    filter_.emplace(elsewhere->fit, time);
    return static_cast<int>(elsewhere->inliers.size());
  }

  /// Looks where the camera may be, from nothing.
  int find(const std::vector<Sighting>& sightings, Time time) {
    const bool remembers = last_pose_ && time - last_fix_ < kForgottenAfter;
    const auto here = localise(sightings, lens_, remembers ? &*last_pose_ : nullptr, vision_);
    if (!here) return 0;
    if (last_pose_) {
      const Vector<6> way = difference(here->fit.pose, *last_pose_);
      const double far = kJump + kFastest * to_seconds(time - last_fix_);
      if (std::sqrt(way[kX] * way[kX] + way[kY] * way[kY]) > far) ++jumps_;
    }
    filter_.emplace(here->fit, time);
    return static_cast<int>(here->inliers.size());
  }

  /// Says it, once, when what is seen is not what the map has.
  void judge(std::size_t sightings, int used) {
    const auto seen = static_cast<int>(sightings) + strangers_;
    if (seen == 0 || reported_) return;
    misfits_ = 2 * used > seen ? std::max(0, misfits_ - 1) : misfits_ + 1;
    if (misfits_ < kMisfitsToReport && jumps_ < kJumpsToReport) return;
    reported_ = true;
    log_.write(Severity::Warning,
               fmt::format("the fiducials seen do not fit {}: printed for another world, or moved?",
                           world_));
  }

  [[nodiscard]] FoundPose found(Time time, int used) const {
    const Vector<6>& values = filter_->pose().values;
    FoundPose out;
    out.time = time;
    out.pose = {values[kX], values[kY], values[kHeading]};
    out.z = values[kZ];
    out.pitch = values[kPitch];
    out.roll = values[kRoll];
    constexpr std::size_t kPlane[3] = {kX, kY, kHeading};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        out.covariance[3 * i + j] = filter_->covariance()(kPlane[i], kPlane[j]);
      }
    }
    out.fiducials = used;
    return out;
  }

  const Calibration calibration_;
  LogSink& log_;
  const std::string world_;
  const Vision& vision_;
  const FiducialFamily family_;
  std::unordered_map<int, std::array<Vec3, 4>> places_;
  Calibration lens_;                  ///< calibration_ for the size of the frames.
  std::optional<PoseFilter> filter_;  ///< None: lost.
  std::optional<EyePose> last_pose_;  ///< At last_fix_.
  Time last_fix_{0};
  std::vector<SeenFiducial> seen_;  ///< In the last frame.
  MountingWatch mounting_;
  int strangers_ = 0;  ///< Seen in this frame, not in the map.
  int misfits_ = 0;
  int jumps_ = 0;
  bool reported_ = false;
};

}  // namespace

std::unique_ptr<PoseFinder> make_fiducial_finder(const std::vector<Fiducial>& map,
                                                 const Calibration& lens, LogSink& log,
                                                 std::string_view world) {
  if (map.empty()) {
    throw ConfigError({}, fmt::format("{} has no wall that fiducials fit on", world));
  }
  if (!(lens.fx > 0.0 && lens.fy > 0.0) || lens.size.width < 1 || lens.size.height < 1) {
    throw ConfigError({}, "the calibration of the camera is empty");
  }
  return std::make_unique<FiducialFinder>(map, lens, log, std::string(world));
}

}  // namespace eyebridge::camera
