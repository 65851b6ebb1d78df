// Beliefs and maps beside the world.
#include "environment/map_view.hpp"

#include <QDockWidget>
#include <QLabel>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

#include "album.hpp"
#include "environment_fixture.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/mapping/ground_truth.hpp"
#include "eyebridge/mapping/picture.hpp"
#include "eyebridge/mapping/robot_mapper.hpp"
#include "windows/map_board.hpp"

namespace eyebridge::gui {
namespace {

using robios::MapBoard;

mapping::Raster<std::uint8_t> greys_of(const mapping::OccupancyGrid& grid) {
  return mapping::picture_of(grid, mapping::PictureKind::Probabilities);
}

/// 2 x 1 m, three cells in a row at the bottom: free, occupied, unknown.
mapping::OccupancyGrid three_cells() {
  mapping::OccupancyGrid grid({{1.0, 2.0}, 0.5, 4, 2});
  grid.set_probability({0, 0}, 0.01);
  grid.set_probability({1, 0}, 0.99);
  return grid;
}

class MapViews : public ::testing::Test {
 protected:
  MapViews() {
    board_.show({greys_of(three_cells()), {}});
    view_.resize(400, 400);
    view_.show();
    view_.refresh();
  }
  int grey_at(double x, double y) {
    const QPoint pixel = view_.viewport().to_pixel({x, y}).toPoint();
    return qGray(view_.grab().toImage().pixel(pixel));
  }

  MapBoard board_;
  MapView view_{board_, nullptr};
};

TEST_F(MapViews, FreeIsWhiteOccupiedBlackUnknownGrey) {
  EXPECT_GT(grey_at(1.25, 2.25), 245);
  EXPECT_LT(grey_at(1.75, 2.25), 10);
  EXPECT_NEAR(grey_at(2.25, 2.25), 127, 2);
  EXPECT_NEAR(grey_at(1.75, 2.75), 127, 2) << "up in the world is up in the view";
}

TEST_F(MapViews, ShowsWhatIsNewOnTheBoard) {
  mapping::OccupancyGrid grid = three_cells();
  grid.set_probability({0, 0}, 0.99);
  board_.show({greys_of(grid), {}});
  view_.refresh();
  EXPECT_LT(grey_at(1.25, 2.25), 10);
}

TEST_F(MapViews, ShowsRobotsWhereTheyAreInTheMap) {
  board_.show({greys_of(three_cells()), {{1, {1.25, 2.25, 0.0}, 0.1}}});
  view_.refresh();
  const QPoint beside = view_.viewport().to_pixel({1.25, 2.30}).toPoint();
  const QColor seen = view_.grab().toImage().pixelColor(beside);
  EXPECT_GT(seen.blue(), seen.red() + 50);
}

TEST_F(MapViews, TheWheelZoomsToThePointer) {
  const QPointF pointer(100, 150);
  const Vec2 place = view_.viewport().to_world(pointer);
  const double before = view_.viewport().pixels_per_metre();
  QWheelEvent wheel(pointer, view_.mapToGlobal(pointer), {}, {0, 120}, Qt::NoButton, {},
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&view_, &wheel);
  EXPECT_GT(view_.viewport().pixels_per_metre(), 1.2 * before);
  const Vec2 now = view_.viewport().to_world(pointer);
  EXPECT_NEAR(now.x, place.x, 1e-9);
  EXPECT_NEAR(now.y, place.y, 1e-9);
  view_.resize(300, 300);
  EXPECT_GT(view_.viewport().pixels_per_metre(), 1.2 * before) << "it stays where it was put";
}

TEST_F(MapViews, ADragMovesItAndADoubleClickShowsAll) {
  const Viewport all = view_.viewport();
  QTest::mousePress(&view_, Qt::LeftButton, {}, {100, 100});
  QMouseEvent move(QEvent::MouseMove, QPointF(140, 100), view_.mapToGlobal(QPointF(140, 100)),
                   Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(&view_, &move);
  QTest::mouseRelease(&view_, Qt::LeftButton, {}, {140, 100});
  EXPECT_NEAR(view_.viewport().to_pixel({1, 2}).x(), all.to_pixel({1, 2}).x() + 40, 1e-6);
  QTest::mouseDClick(&view_, Qt::LeftButton, {}, {140, 100});
  EXPECT_EQ(view_.viewport(), all);
}

TEST(MapView, SaysThatThereIsNothingYet) {
  const MapBoard empty;
  MapView view(empty, nullptr);
  view.resize(200, 200);
  const QImage seen = view.grab().toImage();
  const QColor ground = view.palette().color(QPalette::Window);
  int written = 0;
  for (int x = 0; x < 200; ++x) written += seen.pixelColor(x, 100) == ground ? 0 : 1;
  EXPECT_GT(written, 5) << "words in the middle";
}

class Maps : public testing::EnvironmentFixture {};

TEST_F(Maps, AreShownBesideTheWorld) {
  hal::WorldLook look;
  room_.environment().look(look);
  const robot::RobotModel& model = *look.robots[0].model;
  const mapping::OccupancyGrid truth =
      mapping::truth_of(*look.scene.model, {.resolution = 0.02, .objects = true});
  mapping::OccupancyGrid belief(truth.geometry());
  mapping::RobotMapper mapper(model);
  hal::Lidar& lidar = *room_.robot().lidar();
  std::vector<double> ranges(static_cast<std::size_t>(lidar.points()));
  ASSERT_TRUE(room_.robot().drive()->set_speed({0.2, 0.1}));
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(lidar.read(ranges));
    const auto field_of_view = lidar.shape().field_of_view;
    ASSERT_TRUE(mapper.insert_lidar(belief, room_.pose(1), field_of_view, ranges));
    room_.pass(0.1);
  }
  MapBoard belief_board;
  MapBoard map_board;
  belief_board.show({greys_of(belief), {{1, room_.pose(1), model.radius()}}});
  map_board.show({greys_of(truth), {}});
  window_->resize(1200, 460);
  // What they show depends on when they were asked.
  for (const char* name : {"readings", "events"}) window_->findChild<QDockWidget*>(name)->hide();
  window_->show_map("Belief", belief_board);
  window_->show_map("Map", map_board);
  window_->view().fit();
  window_->view().refresh();
  const auto* const time = window_->findChild<QLabel*>("time");
  ASSERT_TRUE(QTest::qWaitFor([&] { return time->text() == "1.00 s"; }))
      << time->text().toStdString();
  for (const MapView* map : window_->findChildren<MapView*>()) EXPECT_TRUE(map->isVisible());
  EXPECT_TRUE(testing::looks_as(window_->grab().toImage(), "maps"));
}

}  // namespace
}  // namespace eyebridge::gui
