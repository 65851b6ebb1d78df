// AprilTags beside their own library: the same pictures, and corners at least as exact.
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>

extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h11.h>
}
#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/pose_finder.hpp"
#include "fake_view.hpp"
#include "fiducials/vision.hpp"
#include "lens_effects.hpp"

namespace eyebridge::camera::testing {
namespace {

/// Debian's library does not export image_u8_destroy().
struct FreePicture {
  void operator()(image_u8_t* picture) const {
    std::free(picture->buf);
    std::free(picture);
  }
};

struct TagFamily {
  FiducialFamily ours;
  apriltag_family_t* (*make)();
  void (*destroy)(apriltag_family_t*);
  const char* name;
};
void PrintTo(const TagFamily& family, std::ostream* out) { *out << family.name; }

class AprilTags : public ::testing::TestWithParam<TagFamily> {
 protected:
  AprilTags() : theirs_(GetParam().make(), GetParam().destroy) {
    model_.width = model_.height = 1.0;
    model_.walls = {{{1.0, 0.0}, {1.0, 1.0}}, {{0.0, 1.0}, {1.0, 1.0}}};
    fiducials_ = place_fiducials(model_, {.family = GetParam().ours});
  }

  const std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)> theirs_;
  world::WorldModel model_;
  std::vector<Fiducial> fiducials_;
  const Calibration lens_ = pinhole({640, 480}, deg_to_rad(60.0));
};

TEST_P(AprilTags, ArePrintedAsTheirLibraryPrintsThem) {
  ASSERT_EQ(static_cast<int>(theirs_->ncodes), count_of(GetParam().ours));
  const int cells = cells_of(GetParam().ours);
  for (int id = 0; id < count_of(GetParam().ours); ++id) {
    const std::unique_ptr<image_u8_t, FreePicture> picture(
        apriltag_to_image(theirs_.get(), static_cast<unsigned>(id)));
    const int margin = (picture->width - cells) / 2;
    const FiducialBits bits = fiducial_bits(GetParam().ours, id);
    int wrong = 0;
    for (int row = 0; row < cells; ++row) {
      for (int column = 0; column < cells; ++column) {
        const bool white = picture->buf[(row + margin) * picture->stride + column + margin] > 127;
        wrong += white == (bits[static_cast<std::size_t>(row * cells + column)] != 0) ? 0 : 1;
      }
    }
    ASSERT_EQ(wrong, 0) << "tag " << id;
  }
}

/// Root of the mean square of the misses of all corners, pixels, and how many tags were found.
struct Exactness {
  double square = 0.0;
  int tags = 0;
  [[nodiscard]] double miss() const { return std::sqrt(square / (4.0 * tags)); }
};

TEST_P(AprilTags, CornersAreAsExactAsThoseOfTheirLibrary) {
  const std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t*)> detector(
      apriltag_detector_create(), &apriltag_detector_destroy);
  detector->quad_decimate = 1.0F;  // its most exact way
  apriltag_detector_add_family(detector.get(), theirs_.get());
  WallPainter painter(model_, fiducials_);
  Random random(5);
  Exactness ours;
  Exactness theirs;
  for (int i = 0; i < 24; ++i) {
    const EyePose eye{{0.2 + 0.02 * i, 0.55 - 0.015 * i, 0.12, 0.5 + 0.02 * i, 0.02, 0.03}};
    Frame frame = LensCamera(painter, lens_).take(eye, eye, {.exposures = 4}, random, {});
    const auto miss = [&](int id, std::size_t corner, Vec2 seen) {
      const auto place = corners_of(fiducials_[static_cast<std::size_t>(id)]);
      return norm_squared(project(eye, lens_, place[corner])->pixel - seen);
    };
    for (const SeenFiducial& one : vision().find_fiducials(frame, GetParam().ours)) {
      ++ours.tags;
      for (std::size_t k = 0; k < 4; ++k) ours.square += miss(one.id, k, one.corners[k]);
    }
    image_u8_t picture{frame.width, frame.height, frame.stride, frame.bytes.data()};
    const std::unique_ptr<zarray_t, void (*)(zarray_t*)> found(
        apriltag_detector_detect(detector.get(), &picture), &apriltag_detections_destroy);
    for (int k = 0; k < zarray_size(found.get()); ++k) {
      apriltag_detection_t* one = nullptr;
      zarray_get(found.get(), k, &one);
      if (one->hamming > 0 || one->id >= static_cast<int>(fiducials_.size())) continue;
      // Of 16h5 it sees one where there is none.
      if (miss(one->id, 0, {one->p[3][0] - 0.5, one->p[3][1] - 0.5}) > 100.0) continue;
      ++theirs.tags;
      // Counter-clockwise from the lower left; half a pixel off, as its pixels have corners.
      for (std::size_t corner = 0; corner < 4; ++corner) {
        const std::size_t c = 3 - corner;
        theirs.square += miss(one->id, corner, {one->p[c][0] - 0.5, one->p[c][1] - 0.5});
      }
    }
  }
  apriltag_detector_remove_family(detector.get(), theirs_.get());
  ASSERT_GT(theirs.tags, 20) << "there is nothing to compare with";
  RecordProperty("ours",
                 std::to_string(ours.miss()) + " pixels, tags " + std::to_string(ours.tags));
  RecordProperty("theirs",
                 std::to_string(theirs.miss()) + " pixels, tags " + std::to_string(theirs.tags));
  EXPECT_GE(ours.tags, theirs.tags * 8 / 10);
  EXPECT_LE(ours.miss(), theirs.miss());
}

TEST_P(AprilTags, ACameraIsWhereTheySayIt) {
  RecordingLog log;
  WallPainter painter(model_, fiducials_);
  Random random(11);
  const EyePose eye{{0.3, 0.3, 0.12, 0.7, 0.02, 0.03}};
  Frame frame = LensCamera(painter, lens_).take(eye, eye, {.exposures = 4}, random, {});
  const auto found = make_fiducial_finder(fiducials_, lens_, log)->take(frame);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pose.x, 0.3, 0.01);
  EXPECT_NEAR(found->pose.y, 0.3, 0.01);
  EXPECT_NEAR(found->pose.theta, 0.7, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Families, AprilTags,
                         ::testing::Values(TagFamily{FiducialFamily::Tag36h11, &tag36h11_create,
                                                     &tag36h11_destroy, "Tag36h11"},
                                           TagFamily{FiducialFamily::Tag25h9, &tag25h9_create,
                                                     &tag25h9_destroy, "Tag25h9"},
                                           TagFamily{FiducialFamily::Tag16h5, &tag16h5_create,
                                                     &tag16h5_destroy, "Tag16h5"}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace eyebridge::camera::testing
