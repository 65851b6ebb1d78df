// The robot's screen on displays that make everything larger.
#include <QTest>
#include <cmath>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/jumping_clock.hpp"
#include "keys.hpp"
#include "lcd.hpp"
#include "panel/lcd_widget.hpp"
#include "panel/pixel_fit.hpp"
#include "run_program.hpp"

namespace eyebridge::gui {
namespace {

using eyebridge::testing::ProgramRun;
using eyebridge::testing::run_program;

class HighDpi : public ::testing::Test {
 protected:
  HighDpi() {
    for (int i = 0; i < 200; ++i) {
      // A pattern in which a blur or a shift by one pixel shows.
      lcd_.pixel(2 * i, i, {static_cast<std::uint8_t>(i), 255, 0});
      lcd_.pixel(2 * i + 1, i, {0, 0, static_cast<std::uint8_t>(255 - i)});
    }
    screen_.emplace(lcd_, keys_, nullptr);
    screen_->refresh();
    screen_->show();
  }
  /// Makes the widget so large that a pixel of the screen has `times` of the display, and some
  /// rest.
  void make_room(int times) {
    const double ratio = screen_->devicePixelRatioF();
    screen_->setFixedSize(
        static_cast<int>(std::ceil(times * robios::Lcd::kDefaultWidth / ratio)) + 5,
        static_cast<int>(std::ceil(times * robios::Lcd::kDefaultHeight / ratio)) + 3);
    QTest::qWait(0);
  }

  robios::Lcd lcd_;
  JumpingClock clock_;
  robios::Keys keys_{clock_, {}, nullptr};
  std::optional<LcdWidget> screen_;
};

TEST_F(HighDpi, EachPixelOfTheScreenIsAWholeSquareOfTheDisplay) {
  for (const int times : {1, 2}) {
    make_room(times);
    ASSERT_EQ(screen_->scale(), times);
    const QImage shown = screen_->grab().toImage();
    const double ratio = screen_->devicePixelRatioF();
    const QPointF corner =
        ratio * fit_pixels(*screen_, screen_->picture().size(), false).place.topLeft();
    const camera::Frame wanted = lcd_.snapshot();
    for (int y = 0; y < times * wanted.height; ++y) {
      for (int x = 0; x < times * wanted.width; ++x) {
        const std::uint8_t* const rgb = wanted.row(y / times).data() + 3 * (x / times);
        ASSERT_EQ(shown.pixelColor(qRound(corner.x()) + x, qRound(corner.y()) + y),
                  QColor(rgb[0], rgb[1], rgb[2]))
            << x << ", " << y << " of " << times << " times, scale " << ratio;
      }
    }
  }
}

TEST_F(HighDpi, ATouchIsThePixelUnderThePointer) {
  make_room(2);
  const PixelFit fit = fit_pixels(*screen_, screen_->picture().size(), false);
  const QPointF place = fit.place.topLeft() + QPointF(123.5, 45.5) * fit.unit;
  QMouseEvent press(QEvent::MouseButtonPress, place, screen_->mapToGlobal(place), Qt::LeftButton,
                    Qt::LeftButton, {});
  QApplication::sendEvent(&*screen_, &press);
  const auto touch = keys_.read_touch();
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->x, 123);
  EXPECT_EQ(touch->y, 45);
}

TEST(HighDpiDisplays, KeepItSharpAtEveryScale) {
  for (const char* const scale : {"1.5", "2"}) {
    const ProgramRun run = run_program(
        {{"/proc/self/exe", "--gtest_filter=HighDpi.*"}, {{"EYEBRIDGE_TEST_SCALE", scale}}, {}});
    EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
    EXPECT_THAT(run.out, ::testing::HasSubstr("[  PASSED  ] 2 tests.")) << scale;
  }
}

}  // namespace
}  // namespace eyebridge::gui
