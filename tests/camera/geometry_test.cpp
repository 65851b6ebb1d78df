#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "fake_view.hpp"
#include "render/engine.hpp"
#include "scenes.hpp"

// Where things must be in a picture follows here from angles (atan, tan of libm), independently of
// the matrices of the renderer.

namespace eyebridge::camera::testing {
namespace {

struct ShotSize {
  int width;
  int height;
};
void PrintTo(const ShotSize& size, std::ostream* out) { *out << size.width << "x" << size.height; }

bool is_red(const std::uint8_t* p) { return p[0] > 60 && p[1] < 20 && p[2] < 20; }
bool is_green(const std::uint8_t* p) { return p[1] > 60 && p[0] < 20 && p[2] < 20; }
bool is_sky(const std::uint8_t* p) { return p[2] > p[0] + 40; }

/// The rectangle round the pixels of one kind: columns left … right - 1, rows top … bottom - 1.
struct Extent {
  int left = 1 << 20;
  int right = -1;
  int top = 1 << 20;
  int bottom = -1;
  int count = 0;
};

Extent extent(const Frame& frame, const std::function<bool(const std::uint8_t*)>& is) {
  Extent found;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (!is(&frame.row(y)[static_cast<std::size_t>(3 * x)])) continue;
      found.left = std::min(found.left, x);
      found.right = std::max(found.right, x + 1);
      found.top = std::min(found.top, y);
      found.bottom = std::max(found.bottom, y + 1);
      ++found.count;
    }
  }
  return found;
}

/// Rows top … bottom - 1 of one kind in one column.
Extent column_extent(const Frame& frame, int column, bool (*is)(const std::uint8_t*)) {
  Extent found;
  for (int y = 0; y < frame.height; ++y) {
    if (!is(&frame.row(y)[static_cast<std::size_t>(3 * column)])) continue;
    found.top = std::min(found.top, y);
    found.bottom = std::max(found.bottom, y + 1);
  }
  return found;
}

class Projection : public ::testing::TestWithParam<ShotSize> {
 protected:
  Projection() { shot_.carrier = 99; }

  static RenderEngine& engine() {
    static RecordingLog log;
    return RenderEngine::of_this_thread(first_maker(), log);
  }

  Frame draw() {
    shot_.scene.model = std::make_shared<const world::WorldModel>(model_);
    shot_.width = GetParam().width;
    shot_.height = GetParam().height;
    return picture(engine(), shot_);
  }

  /// Pixels from the middle to the picture plane.
  [[nodiscard]] double focal() const {
    return 0.5 * GetParam().width / std::tan(0.5 * shot_.eye.horizontal_field_of_view);
  }
  /// Column of a bearing to the left of the optical axis, level camera.
  [[nodiscard]] double column(double bearing) const {
    return 0.5 * GetParam().width - focal() * std::tan(bearing);
  }
  /// Row of an elevation above the horizontal, in the vertical plane of the optical axis.
  [[nodiscard]] double row(double elevation) const {
    return 0.5 * GetParam().height - focal() * std::tan(elevation - shot_.eye.pitch);
  }

  /// Stands the eye at `at`, looking `heading`, and a red wall across its axis `distance` ahead,
  /// from `left` to `right` metres to the left of the axis.
  void stand(Vec2 at, double heading, double distance, double left, double right) {
    shot_.eye.x = at.x;
    shot_.eye.y = at.y;
    shot_.eye.heading = heading;
    const Vec2 forward{std::cos(heading), std::sin(heading)};
    const Vec2 leftward{-forward.y, forward.x};
    world::Wall wall;
    wall.a = at + distance * forward + left * leftward;
    wall.b = at + distance * forward + right * leftward;
    wall.colour = kRed;
    model_.walls = {wall};
  }

  world::WorldModel model_ = empty_room();
  Shot shot_;
};

TEST_P(Projection, AWallAheadSpansTheRightColumnsAndRows) {
  for (const double heading : {0.0, 0.6, 2.2, -1.9}) {
    for (const double distance : {0.35, 0.6, 1.0, 1.7}) {
      stand({2.0, 2.0}, heading, distance, 0.15, -0.10);
      const Extent seen = extent(draw(), is_red);
      EXPECT_NEAR(seen.left, column(std::atan2(0.15, distance)), 1.0) << heading << " " << distance;
      EXPECT_NEAR(seen.right, column(std::atan2(-0.10, distance)), 1.0);
      EXPECT_NEAR(seen.top, row(std::atan2(0.2 - shot_.eye.z, distance)), 1.0);
      EXPECT_NEAR(seen.bottom, row(std::atan2(-shot_.eye.z, distance)), 1.0);
    }
  }
}

TEST_P(Projection, ATiltedCameraSeesAWallShifted) {
  for (const double pitch : {0.12, -0.12, 0.2}) {
    shot_.eye.pitch = pitch;
    // A narrow strip on the axis: rows follow from elevations alone.
    stand({2.0, 2.0}, 0.4, 0.9, 0.02, -0.02);
    const Frame frame = draw();
    const Extent seen = column_extent(frame, frame.width / 2, is_red);
    EXPECT_NEAR(seen.top, row(std::atan2(0.2 - shot_.eye.z, 0.9)), 1.0) << pitch;
    EXPECT_NEAR(seen.bottom, std::min(row(std::atan2(-shot_.eye.z, 0.9)), 1.0 * frame.height), 1.0);
  }
}

TEST_P(Projection, AWallOffTheAxisHasItsEndsAtTheirBearings) {
  shot_.eye = {1.0, 1.0, 0.08, 0.0, 0.0, 1.2};
  world::Wall wall;
  wall.a = {1.5, 1.25};
  wall.b = {2.4, 1.10};
  wall.colour = kRed;
  model_.walls = {wall};
  const Frame frame = draw();
  const Extent seen = extent(frame, is_red);
  const double left = column(std::atan2(0.25, 0.5));
  const double right = column(std::atan2(0.10, 1.4));
  EXPECT_NEAR(seen.left, left, 1.0);
  EXPECT_NEAR(seen.right, right, 1.0);
  // At an end the picture's row depends on the depth along the axis.
  const Extent near_end = column_extent(frame, static_cast<int>(left) + 1, is_red);
  const Extent far_end = column_extent(frame, static_cast<int>(right) - 2, is_red);
  EXPECT_NEAR(near_end.top, row(std::atan2(0.12, 0.5)), 1.5);
  EXPECT_NEAR(far_end.top, row(std::atan2(0.12, 1.4)), 1.5);
  EXPECT_NEAR(far_end.bottom, row(std::atan2(-0.08, 1.4)), 1.5);
}

TEST_P(Projection, AThickWallShowsItsNearFaceAndItsEnd) {
  stand({2.0, 2.0}, 0.0, 1.0, 0.1, -0.1);
  model_.walls[0].thickness = 0.1;
  const Extent front = extent(draw(), is_red);
  EXPECT_NEAR(front.left, column(std::atan2(0.1, 0.95)), 1.0);
  EXPECT_NEAR(front.top, row(std::atan2(0.2 - shot_.eye.z, 0.95)), 1.0);
  EXPECT_NEAR(front.bottom, row(std::atan2(-shot_.eye.z, 0.95)), 1.0);

  model_.walls[0].a = {2.6, 1.9};  // along the axis, to its right
  model_.walls[0].b = {3.0, 1.9};
  const Extent side = extent(draw(), is_red);
  EXPECT_NEAR(side.left, column(std::atan2(-0.05, 1.0)), 1.0);
  EXPECT_NEAR(side.right, column(std::atan2(-0.15, 0.6)), 1.0);
}

TEST_P(Projection, WallsHaveTheirOwnHeightAndBothSides) {
  for (const bool swapped : {false, true}) {
    stand({2.0, 2.0}, -0.3, 1.0, 0.1, -0.1);
    model_.walls[0].height = 0.35;
    if (swapped) std::swap(model_.walls[0].a, model_.walls[0].b);
    EXPECT_NEAR(extent(draw(), is_red).top, row(std::atan2(0.35 - shot_.eye.z, 1.0)), 1.0);
  }
}

TEST_P(Projection, TheFloorEndsAtItsEdge) {
  for (const double pitch : {0.0, -0.15, 0.1}) {
    shot_.eye = {1.0, 2.0, 0.1, 0.0, pitch, 1.0};
    const Frame frame = draw();
    const Extent sky = column_extent(frame, frame.width / 2, is_sky);
    EXPECT_EQ(sky.top, 0);
    EXPECT_NEAR(sky.bottom, row(std::atan2(-0.1, 3.0)), 1.0) << pitch;
  }
}

TEST_P(Projection, ABallIsADiscOfTheRightSizeAtTheRightPlace) {
  shot_.eye = {1.0, 1.0, 0.06, 0.5, 0.0, 1.0};
  constexpr double kRadius = 0.06;
  for (const double distance : {0.4, 0.8}) {
    const Vec2 at = Vec2{1.0, 1.0} + distance * Vec2{std::cos(0.5), std::sin(0.5)};
    shot_.scene.bodies = {
        {3, world::BodyShape::Ball, {at.x, at.y, 1.0}, kRadius, 2 * kRadius, kRed}};
    const Extent seen = extent(draw(), is_red);
    // Eye and centre are equally high: the silhouette's tangents make asin(r / d) with the axis.
    const double half = focal() * std::tan(std::asin(kRadius / distance));
    EXPECT_NEAR(0.5 * (seen.left + seen.right), 0.5 * GetParam().width, 1.0) << distance;
    EXPECT_NEAR(0.5 * (seen.top + seen.bottom), 0.5 * GetParam().height, 1.0);
    EXPECT_NEAR(0.5 * (seen.right - seen.left), half, 1.0);
    EXPECT_NEAR(0.5 * (seen.bottom - seen.top), half, 1.0);
    EXPECT_NEAR(seen.count, kPi * half * half, 2.0 * kPi * half);  // a disc, not its square
  }
}

std::shared_ptr<const std::vector<Vec2>> rectangle(double length, double width) {
  const Vec2 half{length / 2, width / 2};
  return std::make_shared<const std::vector<Vec2>>(std::vector<Vec2>{
      {half.x, half.y}, {-half.x, half.y}, {-half.x, -half.y}, {half.x, -half.y}});
}

TEST_P(Projection, ABoxIsAsWideAndHighAsTheSideThatItShows) {
  constexpr double kEyeHeight = 0.05;
  shot_.eye = {1.0, 1.0, kEyeHeight, 0.0, 0.0, 1.0};
  shot_.scene.bodies = {
      {3, world::BodyShape::Polygon, {1.8, 1.0, kPi / 2}, 0.2, 0.1, kRed, rectangle(0.3, 0.2)}};
  const Extent seen = extent(draw(), is_red);
  // Turned by a quarter it shows its length, 0.7 m away: 0.8 m less half its width.
  EXPECT_NEAR(seen.left, column(std::atan2(0.15, 0.7)), 1.0);
  EXPECT_NEAR(seen.right, column(-std::atan2(0.15, 0.7)), 1.0);
  EXPECT_NEAR(seen.top, row(std::atan2(0.1 - kEyeHeight, 0.7)), 1.0);
  EXPECT_NEAR(seen.bottom, row(-std::atan2(kEyeHeight, 0.7)), 1.0);
}

TEST_P(Projection, APolygonShowsTheSidesThatLookThisWay) {
  constexpr double kEyeHeight = 0.05;
  shot_.eye = {1.0, 1.0, kEyeHeight, 0.0, 0.0, 1.0};
  // A triangle whose tip points here, with one shorter flank.
  const auto wedge = std::make_shared<const std::vector<Vec2>>(
      std::vector<Vec2>{{-0.2, 0.0}, {0.1, -0.2}, {0.1, 0.1}});
  shot_.scene.bodies = {{3, world::BodyShape::Polygon, {1.8, 1.0, 0.0}, 0.25, 0.1, kRed, wedge},
                        {4, world::BodyShape::Polygon, {1.5, 3.0, 0.0}, 0.25, 0.1, kGreen, wedge}};
  const Extent seen = extent(draw(), is_red);
  EXPECT_NEAR(seen.left, column(std::atan2(0.1, 0.9)), 1.0);
  EXPECT_NEAR(seen.right, column(-std::atan2(0.2, 0.9)), 1.0);
  EXPECT_NEAR(seen.top, row(std::atan2(0.1 - kEyeHeight, 0.6)), 1.0) << "at its tip";
  EXPECT_NEAR(seen.bottom, row(-std::atan2(kEyeHeight, 0.6)), 1.0);
}

TEST_P(Projection, ATallBodyIsDrawnWhereOnlyItsFootIsInView) {
  shot_.eye = {1.0, 1.0, 0.1, 0.0, 0.0, 1.0};
  shot_.scene.bodies = {
      {3, world::BodyShape::Polygon, {2.0, 1.0, 0.0}, 0.15, 2.0, kRed, rectangle(0.2, 0.2)}};
  const Extent seen = extent(draw(), is_red);
  EXPECT_EQ(seen.top, 0);
  EXPECT_NEAR(seen.bottom, row(-std::atan2(0.1, 0.9)), 1.0);
}

TEST_P(Projection, SidesOfBodiesAreAsBrightAsTheWayThatTheyLook) {
  const auto square = rectangle(0.2, 0.2);
  for (const auto shape : {world::BodyShape::Robot, world::BodyShape::Ball, world::BodyShape::Can,
                           world::BodyShape::Polygon}) {
    for (int turn = 0; turn < 4; ++turn) {
      const double heading = turn * kPi / 2;
      // The body has its back to the eye, which sees no mark of a robot.
      shot_.eye = {
          2.0 - 0.8 * std::cos(heading), 2.0 - 0.8 * std::sin(heading), 0.1, heading, 0.0, 1.0};
      const bool is_polygon = shape == world::BodyShape::Polygon;
      shot_.scene.bodies = {
          {3, shape, {2.0, 2.0, heading}, 0.1, 0.2, kRed, is_polygon ? square : nullptr}};
      const Frame frame = draw();
      const std::size_t middle = 3 * static_cast<std::size_t>(frame.width / 2);
      const double towards_sun = -0.30 * std::cos(heading) - 0.52 * std::sin(heading);
      EXPECT_NEAR(frame.row(frame.height / 2)[middle], 255 * (0.72 + 0.28 * towards_sun), 3.0)
          << static_cast<int>(shape) << " seen along " << heading;
    }
  }
}

TEST_P(Projection, AnotherRobotIsDrawnAndTheCarrierIsNot) {
  shot_.eye = {1.0, 1.0, 0.12, 0.0, 0.0, 1.0};
  shot_.carrier = 4;
  shot_.scene.bodies = {{4, world::BodyShape::Robot, {1.0, 1.0, 0.0}, 0.09, 0.3, kGreen},
                        {7, world::BodyShape::Robot, {1.8, 1.0, 0.0}, 0.1, 0.1, kRed}};
  const Frame frame = draw();
  EXPECT_EQ(extent(frame, is_green).count, 0);
  const Extent seen = extent(frame, is_red);
  EXPECT_NEAR(seen.left, column(std::asin(0.1 / 0.8)), 1.0);
  EXPECT_NEAR(seen.right, column(-std::asin(0.1 / 0.8)), 1.0);

  // When it looks at us, the mark hides the red of its side.
  const int away = column_extent(frame, frame.width / 2, is_red).bottom;
  shot_.scene.bodies[1].pose.theta = kPi;
  const int facing = column_extent(draw(), frame.width / 2, is_red).bottom;
  EXPECT_GT(away - facing, 0.09 / 0.7 * focal());

  shot_.carrier = 7;  // now from beside them
  shot_.eye.x = 0.2;
  const Frame other = draw();
  EXPECT_EQ(extent(other, is_red).count, 0);
  EXPECT_GT(extent(other, is_green).count, 0);
}

TEST_P(Projection, ANearWallHidesAFarOne) {
  stand({2.0, 2.0}, 0.0, 0.8, 1.0, -1.0);
  world::Wall behind = model_.walls[0];
  behind.a.x = behind.b.x = 3.0;
  behind.colour = kGreen;
  model_.walls.push_back(behind);
  EXPECT_EQ(extent(draw(), is_green).count, 0);
  model_.walls[0].height = 0.05;
  EXPECT_GT(extent(draw(), is_green).count, 0);
}

TEST_P(Projection, NoSkyShowsBetweenTheFloorAndTheWallsRoundIt) {
  model_ = *maze_scene(7, 7).model;
  for (int place = 0; place < 49; ++place) {
    const int row_of_cells = place / 7;
    shot_.eye = {0.15 + 0.3 * (place % 7), 0.15 + 0.3 * row_of_cells, 0.1, 0.4 * place, 0.0, 1.1};
    const Frame frame = draw();
    int sky = 0;
    for (int x = 0; x < frame.width; ++x) {
      if (column_extent(frame, x, is_sky).bottom > frame.height / 2) ++sky;
    }
    EXPECT_EQ(sky, 0) << place;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Projection,
                         ::testing::Values(ShotSize{160, 120}, ShotSize{320, 240},
                                           ShotSize{640, 480}),
                         [](const auto& test) { return std::to_string(test.param.width); });

}  // namespace
}  // namespace eyebridge::camera::testing
