#include "plan/viewport.hpp"

#include <gtest/gtest.h>

namespace eyebridge::gui {
namespace {

Viewport fitted() {
  Viewport view;
  view.resize({800, 600});
  view.fit({}, {4.0, 2.0});
  return view;
}

TEST(Viewport, FitsTheWholeWorldWithItsYAxisUp) {
  const Viewport view = fitted();
  EXPECT_EQ(view.to_pixel({2.0, 1.0}), QPointF(400, 300));
  EXPECT_GE(view.to_pixel({0.0, 0.0}).x(), 0.0);
  EXPECT_LE(view.to_pixel({4.0, 0.0}).x(), 800.0);
  EXPECT_GT(view.to_pixel({0.0, 0.0}).y(), view.to_pixel({0.0, 2.0}).y());
  EXPECT_NEAR(view.pixels_per_metre(), 800 / 4.2, 1e-9);
}

TEST(Viewport, PixelsAndPlacesAreEachOthersInverse) {
  const Viewport view = fitted();
  for (const QPointF pixel : {QPointF(0, 0), QPointF(800, 600), QPointF(123.5, 7)}) {
    const QPointF back = view.to_pixel(view.to_world(pixel));
    EXPECT_NEAR(back.x(), pixel.x(), 1e-9);
    EXPECT_NEAR(back.y(), pixel.y(), 1e-9);
  }
}

TEST(Viewport, ZoomsToThePointer) {
  Viewport view = fitted();
  const QPointF pointer(700, 100);
  const Vec2 before = view.to_world(pointer);
  const double scale = view.pixels_per_metre();
  view.zoom_at(pointer, 2.0);
  EXPECT_DOUBLE_EQ(view.pixels_per_metre(), 2 * scale);
  EXPECT_NEAR(norm(view.to_world(pointer) - before), 0.0, 1e-12);
  view.zoom_at(pointer, 1e30);
  EXPECT_DOUBLE_EQ(view.pixels_per_metre(), Viewport::kNearest);
  view.zoom_at(pointer, 1e-30);
  EXPECT_DOUBLE_EQ(view.pixels_per_metre(), Viewport::kFarthest);
}

TEST(Viewport, PansWithTheMouse) {
  Viewport view = fitted();
  const QPointF before = view.to_pixel({1.0, 1.0});
  view.pan({30, -20});
  EXPECT_EQ((view.to_pixel({1.0, 1.0}) - before).toPoint(), QPoint(30, -20));
}

TEST(Viewport, AWorldWithoutExtentCanBeSeen) {
  Viewport view = fitted();
  view.fit({}, {});
  EXPECT_EQ(view.to_pixel({0.0, 0.0}), QPointF(400, 300));
}

}  // namespace
}  // namespace eyebridge::gui
