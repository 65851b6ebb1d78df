#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/fiducials.hpp"
#include "eyebridge/camera/source.hpp"
#include "fake_clock.hpp"
#include "fake_view.hpp"
#include "scenes.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::HasSubstr;

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr double kFieldOfView = kPi / 3;

struct Point {
  double x;
  double y;
};

class RenderedFiducials : public ::testing::Test {
 protected:
  /// A picture through the source `url`.
  FramePtr look(const char* url = "render:?fiducials=on") {
    const auto source = open_source(url, {&clock_, &view_, &log_});
    EXPECT_TRUE(source->set_size(kWidth, kHeight));
    return *source->next(clock_.now() + Time(1'000'000'000));
  }

  /// A single wall in the middle of the room, marked on both sides.
  void put_wall(double direction, double thickness) {
    view_.model = empty_room();
    world::Wall wall;
    const Vec2 half = 0.18 * Vec2{std::cos(direction), std::sin(direction)};
    wall.a = Vec2{2.0, 2.0} - half;
    wall.b = Vec2{2.0, 2.0} + half;
    wall.thickness = thickness;
    view_.model.walls = {wall};
  }

  /// Looks at `fiducial` from `distance` metres, `aside` radians off its normal.
  void stand_before(const Fiducial& fiducial, double distance, double aside) {
    const double bearing = fiducial.facing + aside;
    view_.eye_.x = fiducial.centre.x + distance * std::cos(bearing);
    view_.eye_.y = fiducial.centre.y + distance * std::sin(bearing);
    view_.eye_.z = 0.08;
    view_.eye_.heading = bearing + kPi;
    view_.eye_.horizontal_field_of_view = kFieldOfView;
  }

  /// Where a point of `fiducial` is in the picture: `right` and `up` metres from its centre, as one
  /// faces it. From angles, independently of the renderer's matrices; the eye is level.
  [[nodiscard]] Point in_picture(const Fiducial& fiducial, double right, double up) const {
    const double x = fiducial.centre.x - right * std::sin(fiducial.facing) - view_.eye_.x;
    const double y = fiducial.centre.y + right * std::cos(fiducial.facing) - view_.eye_.y;
    const double bearing = std::atan2(y, x) - view_.eye_.heading;
    const double depth = std::hypot(x, y) * std::cos(bearing);
    const double focal = 0.5 * kWidth / std::tan(0.5 * kFieldOfView);
    return {0.5 * kWidth - focal * std::tan(bearing),
            0.5 * kHeight - focal * (fiducial.z + up - view_.eye_.z) / depth};
  }

  static int tone(const Frame& frame, Point at) {
    return frame.row(static_cast<int>(at.y))[3 * static_cast<std::size_t>(at.x)];
  }

  /// True when the bits of `fiducial` are where they must be, and white round them.
  [[nodiscard]] ::testing::AssertionResult is_at_its_place(const Frame& frame,
                                                           const Fiducial& fiducial) const {
    const int cells = cells_of(fiducial.family);
    const double cell = fiducial.size / cells;
    const FiducialBits bits = fiducial_bits(fiducial.family, fiducial.id);
    for (int row = -1; row <= cells; ++row) {
      for (int column = -1; column <= cells; ++column) {
        const bool margin = std::min(row, column) < 0 || std::max(row, column) >= cells;
        const bool white = margin || bits[static_cast<std::size_t>(row * cells + column)] != 0;
        const Point at = in_picture(fiducial, (column - 0.5 * (cells - 1)) * cell,
                                    (0.5 * (cells - 1) - row) * cell);
        const int seen = tone(frame, at);
        if (white ? seen < 120 : seen > 60) {
          return ::testing::AssertionFailure() << "row " << row << ", column " << column << " at "
                                               << at.x << ", " << at.y << " is " << seen;
        }
      }
    }
    return ::testing::AssertionSuccess();
  }

  FakeClock clock_;
  FakeView view_;
  RecordingLog log_;
};

TEST_F(RenderedFiducials, AreWhereTheWorldHasThem) {
  for (const double thickness : {0.0, 0.02}) {
    for (const double direction : {0.0, 0.7}) {
      put_wall(direction, thickness);
      const std::vector<Fiducial> fiducials = place_fiducials(view_.model);
      ASSERT_EQ(fiducials.size(), 2U);
      for (const Fiducial& fiducial : fiducials) {
        for (const double distance : {0.2, 0.6, 1.5}) {
          for (const double aside : {0.0, 0.6, -1.0}) {
            stand_before(fiducial, distance, aside);
            EXPECT_TRUE(is_at_its_place(*look(), fiducial))
                << fiducial.id << " from " << distance << " m, " << aside << " rad aside";
          }
        }
      }
    }
  }
}

TEST_F(RenderedFiducials, HaveTheirEdgesOnThePixel) {
  put_wall(0.3, 0.0);
  const Fiducial fiducial = place_fiducials(view_.model).front();
  stand_before(fiducial, 0.5, 0.2);
  const FramePtr frame = look();
  for (const double side : {-0.5, 0.5}) {
    const Point edge = in_picture(fiducial, side * fiducial.size, 0.0);
    const double in = side > 0.0 ? -1.0 : 1.0;
    EXPECT_LT(tone(*frame, {edge.x + in, edge.y}), 60) << side;
    EXPECT_GT(tone(*frame, {edge.x - in, edge.y}), 120) << side;
    const Point top = in_picture(fiducial, 0.0, -side * fiducial.size);
    EXPECT_LT(tone(*frame, {top.x, top.y - (side > 0.0 ? 1.0 : -1.0)}), 60) << side;
    EXPECT_GT(tone(*frame, {top.x, top.y + (side > 0.0 ? 1.0 : -1.0)}), 120) << side;
  }
}

TEST_F(RenderedFiducials, AreDrawnOnlyWhenAskedFor) {
  put_wall(0.0, 0.0);
  stand_before(place_fiducials(view_.model).front(), 0.5, 0.0);
  const FramePtr without = look("render");
  EXPECT_EQ(without->bytes, look("render:?fiducials=off")->bytes);
  EXPECT_NE(without->bytes, look()->bytes);
  EXPECT_EQ(without->bytes, look("render")->bytes);  // the engine is the same
}

TEST_F(RenderedFiducials, AreHiddenByWallsBeforeThem) {
  put_wall(0.0, 0.0);
  const Fiducial fiducial = place_fiducials(view_.model).front();
  stand_before(fiducial, 1.0, 0.1);
  world::Wall before = view_.model.walls[0];
  const Vec2 half_way = 0.5 * (fiducial.centre + Vec2{view_.eye_.x, view_.eye_.y});
  before.a = before.a + (half_way - fiducial.centre);
  before.b = before.b + (half_way - fiducial.centre);
  view_.model.walls.push_back(before);
  EXPECT_FALSE(is_at_its_place(*look(), fiducial));
  EXPECT_TRUE(is_at_its_place(*look(), place_fiducials(view_.model).at(2)));
}

TEST_F(RenderedFiducials, ThatAreLeftOutAreThoseThatCannotBeSeen) {
  view_.model = *maze_scene(9, 7).model;
  const std::vector<world::Wall> walls = view_.model.walls;
  int most = 0;
  for (int place = 0; place < 24; ++place) {
    view_.model.walls = walls;
    view_.eye_ = {0.15 + 0.3 * (place % 9), 0.15 + 0.3 * (place * 5 % 9), 0.1, 0.7 * place, 0, 1.1};
    const FramePtr culled = look();
    // A tall wall out of view: beside it none is the tallest, so none hides another.
    world::Wall tall;
    tall.a = {-5.0, -5.0};
    tall.b = {-5.1, -5.0};
    tall.height = 0.5;
    view_.model.walls.push_back(tall);
    const FramePtr all = look();
    int different = 0;
    for (std::size_t i = 0; i < all->bytes.size(); i += 3) {
      if (all->bytes[i] != culled->bytes[i]) ++different;
    }
    most = std::max(most, different);
  }
  // Where three walls meet, the edge of a pixel may belong to either.
  EXPECT_LE(most, 3);
}

std::string error_of(const std::string& url, const world::WorldModel& model) {
  FakeClock clock;
  FakeView view;
  view.model = model;
  try {
    check_source(url, {&clock, &view, nullptr});
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.where().file, "--camera");
    return error.text();
  }
  return "";
}

TEST_F(RenderedFiducials, AreAnErrorAtTheStartWhereTheWorldNeedsTooMany) {
  EXPECT_THAT(error_of("render:?fiducials=on", *maze_scene(43, 7).model), HasSubstr("1000"));
  EXPECT_EQ(error_of("render", *maze_scene(43, 7).model), "");
  EXPECT_THAT(error_of("render:?fiducials=yes", empty_room()),
              HasSubstr("expected on, off, aruco"));
}

}  // namespace
}  // namespace eyebridge::camera::testing
