#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/pose_finder.hpp"
#include "fake_view.hpp"
#include "fiducials/vision.hpp"
#include "lens_effects.hpp"
#include "pictures/turn.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr Time kPeriod{33'333'333};

/// The corner of a room, 1 m x 1 m, and a camera in it.
class Corner : public ::testing::Test {
 protected:
  Corner() {
    model_.width = model_.height = 1.0;
    model_.walls = {{{1.0, 0.0}, {1.0, 1.0}}, {{0.0, 1.0}, {1.0, 1.0}}};
    fiducials_ = place_fiducials(model_);
    lens_ = pinhole({640, 480}, deg_to_rad(60.0));
  }

  Frame picture(const EyePose& eye, const std::vector<char>& hidden = {}) {
    if (!painter_) painter_.emplace(model_, fiducials_);
    return LensCamera(*painter_, lens_).take(eye, eye, {.exposures = 4}, random_, hidden);
  }

  /// The next frame, 1/30 s later.
  std::optional<FoundPose> take(PoseFinder& finder, const EyePose& eye,
                                const std::vector<char>& hidden = {}) {
    Frame frame = picture(eye, hidden);
    frame.time = now_ += kPeriod;
    return finder.take(frame);
  }

  [[nodiscard]] std::vector<char> none_shown() const {
    return std::vector<char>(fiducials_.size(), 1);
  }

  const EyePose eye_{{0.3, 0.3, 0.12, 0.7, 0.02, 0.03}};
  world::WorldModel model_;
  std::vector<Fiducial> fiducials_;
  Calibration lens_;
  std::optional<WallPainter> painter_;
  Random random_{11};
  RecordingLog log_;
  Time now_{0};
};

TEST_F(Corner, EveryFiducialInViewIsFoundWhereItIs) {
  const auto seen = vision().find_fiducials(picture(eye_), FiducialFamily::Aruco5x5);
  EXPECT_GE(seen.size(), 3U);
  for (const SeenFiducial& one : seen) {
    const auto corners = corners_of(fiducials_[static_cast<std::size_t>(one.id)]);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto expected = project(eye_, lens_, corners[i]);
      EXPECT_LT(norm(one.corners[i] - expected->pixel), 0.3) << one.id << " corner " << i;
    }
  }
}

TEST_F(Corner, FramesOfAllFormatsShowTheSame) {
  const Frame grey = picture(eye_);
  const auto expected = vision().find_fiducials(grey, FiducialFamily::Aruco5x5);
  const auto seen = vision().find_fiducials(to_rgb24(grey), FiducialFamily::Aruco5x5);
  ASSERT_EQ(seen.size(), expected.size());
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i].id, expected[i].id);
}

TEST_F(Corner, ThePoseIsWhereTheCameraIs) {
  const auto finder = make_fiducial_finder(fiducials_, lens_, log_);
  const auto found = take(*finder, eye_);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pose.x, 0.3, 0.01);
  EXPECT_NEAR(found->pose.y, 0.3, 0.01);
  EXPECT_NEAR(found->z, 0.12, 0.01);
  EXPECT_NEAR(found->pose.theta, 0.7, 0.01);
  EXPECT_NEAR(found->pitch, 0.02, 0.01);
  EXPECT_NEAR(found->roll, 0.03, 0.01);
  EXPECT_GE(found->fiducials, 3);
  EXPECT_EQ(found->time, now_);
  EXPECT_GT(found->covariance[0], 0.0);
  EXPECT_LT(found->covariance[0], 1e-3);
  EXPECT_TRUE(log_.warnings.empty());
}

TEST_F(Corner, FramesOfHalfTheSizeGiveTheSamePose) {
  const auto finder = make_fiducial_finder(fiducials_, lens_, log_);
  Frame frame = fit(picture(eye_), 320, 240);
  const auto found = finder->take(frame);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pose.x, 0.3, 0.02);
  EXPECT_NEAR(found->pose.theta, 0.7, 0.02);
}

TEST_F(Corner, ACameraMountedAnotherWayIsToldWhichOptionItNeeds) {
  struct Mounted {
    int exif;  ///< How the pictures that come have to be turned to be right.
    const char* option;
  };
  for (const Mounted& mounted : {Mounted{3, "?rotate=180"}, Mounted{6, "?rotate=90"},
                                 Mounted{8, "?rotate=270"}, Mounted{2, "?flip=h"}}) {
    RecordingLog log;
    const Size size = upright_size(lens_.size, mounted.exif);
    const auto finder = make_fiducial_finder(fiducials_, pinhole(size, deg_to_rad(60.0)), log);
    // Exif 6 and 8 undo each other, all others themselves.
    const int undone = mounted.exif == 6 ? 8 : mounted.exif == 8 ? 6 : mounted.exif;
    const Frame seen = upright(picture(eye_), undone);
    for (int i = 0; i < 40; ++i) {
      Frame frame = seen;
      frame.time = now_ += kPeriod;
      finder->take(frame);
    }
    EXPECT_EQ(std::ranges::count_if(log.warnings,
                                    [&](const auto& warning) {
                                      return std::string(warning).find(mounted.option) !=
                                             std::string::npos;
                                    }),
              1)
        << mounted.option;
  }
  const auto finder = make_fiducial_finder(fiducials_, lens_, log_);
  for (int i = 0; i < 40; ++i) take(*finder, eye_);
  for (int i = 0; i < 40; ++i) take(*finder, eye_, none_shown());
  EXPECT_TRUE(log_.warnings.empty());
}

TEST_F(Corner, NothingInViewIsCarriedOnFor300MillisecondsThenLost) {
  const auto finder = make_fiducial_finder(fiducials_, lens_, log_);
  ASSERT_TRUE(take(*finder, eye_));
  for (int i = 1; i <= 9; ++i) {
    const auto found = take(*finder, eye_, none_shown());
    ASSERT_TRUE(found) << i;
    EXPECT_EQ(found->fiducials, 0);
  }
  EXPECT_FALSE(take(*finder, eye_, none_shown()));
  EXPECT_FALSE(take(*finder, eye_, none_shown()));
}

TEST_F(Corner, TheFirstGoodFrameEndsBeingLost) {
  const auto finder = make_fiducial_finder(fiducials_, lens_, log_);
  ASSERT_TRUE(take(*finder, eye_));
  for (int i = 0; i < 12; ++i) take(*finder, eye_, none_shown());
  const EyePose elsewhere{{0.4, 0.5, 0.13, 0.3, 0.0, 0.0}};
  const auto found = take(*finder, elsewhere);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pose.x, 0.4, 0.01);
  EXPECT_NEAR(found->pose.y, 0.5, 0.01);
}

TEST_F(Corner, ACameraThatIsCarriedOffIsFoundAtOnceByTwoThatAgree) {
  const auto finder = make_fiducial_finder(fiducials_, lens_, log_);
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(take(*finder, eye_));
  const EyePose elsewhere{{0.5, 0.15, 0.13, 1.2, 0.0, 0.0}};
  const auto found = take(*finder, elsewhere);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pose.y, 0.15, 0.02);
  EXPECT_NEAR(found->pose.theta, 1.2, 0.02);
}

TEST_F(Corner, FiducialsOfAnotherWorldAreSaidOnce) {
  // The map has the numbers elsewhere: three of them, in three other corners.
  std::vector<Fiducial> map = fiducials_;
  std::rotate(map.begin(), map.begin() + 1, map.end());
  for (std::size_t i = 0; i < map.size(); ++i) map[i].id = static_cast<int>(i);
  std::swap(map[0].centre, map[2].centre);
  const auto finder = make_fiducial_finder(map, lens_, log_, "maze.wld");
  for (int i = 0; i < 40; ++i) take(*finder, eye_);
  EXPECT_THAT(log_.warnings, ElementsAre(HasSubstr("maze.wld")));
}

TEST_F(Corner, NumbersThatTheWorldDoesNotHaveAreSaidOnce) {
  std::vector<Fiducial> map = fiducials_;
  for (Fiducial& fiducial : map) fiducial.id += 100;
  const auto finder = make_fiducial_finder(map, lens_, log_, "maze.wld");
  for (int i = 0; i < 40; ++i) EXPECT_FALSE(take(*finder, eye_));
  EXPECT_THAT(log_.warnings, ElementsAre(HasSubstr("another world")));
}

TEST_F(Corner, AMapOrALensThatIsEmptyIsRefused) {
  EXPECT_THROW(make_fiducial_finder({}, lens_, log_), ConfigError);
  EXPECT_THROW(make_fiducial_finder(fiducials_, {}, log_), ConfigError);
}

}  // namespace
}  // namespace eyebridge::camera::testing
