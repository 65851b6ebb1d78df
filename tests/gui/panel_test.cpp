// The robot's panel, as a person uses it.
#include <QTest>

#include <gtest/gtest.h>

#include "eyebridge/base/jumping_clock.hpp"
#include "keys.hpp"
#include "lcd.hpp"
#include "panel/panel_window.hpp"

namespace eyebridge::gui {
namespace {

class Panel : public ::testing::Test {
 protected:
  void show() {
    panel_.emplace(robios::PanelStart{"square – robot", &lcd_, &keys_});
    panel_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&*panel_));
  }
  /// The place of a pixel of the screen in the window.
  QPoint place_of(int x, int y) {
    LcdWidget& shown = panel_->lcd();
    const QSize size = shown.scale() * shown.picture().size();
    return {(shown.width() - size.width()) / 2 + x * shown.scale() + shown.scale() / 2,
            (shown.height() - size.height()) / 2 + y * shown.scale() + shown.scale() / 2};
  }

  robios::Lcd lcd_;
  JumpingClock clock_;
  robios::Keys keys_{clock_, {}, nullptr};
  std::optional<PanelWindow> panel_;
};

TEST_F(Panel, ShowsTheScreenPixelForPixel) {
  lcd_.area(10, 20, 30, 40, {200, 0, 0}, true);
  show();
  lcd_.pixel(5, 6, {0, 255, 0});
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return panel_->lcd().picture().pixelColor(5, 6).green() == 255; }));
  for (const int scale : {1, 2}) {
    panel_->lcd().setFixedSize(scale * robios::Lcd::kDefaultWidth + 7,
                               scale * robios::Lcd::kDefaultHeight + 3);
    QTest::qWait(0);
    ASSERT_EQ(panel_->lcd().scale(), scale);
    const QImage shown = panel_->lcd().grab().toImage();
    const camera::Frame wanted = lcd_.snapshot();
    for (int y = 0; y < wanted.height; ++y) {
      for (int x = 0; x < wanted.width; ++x) {
        const std::uint8_t* const rgb = wanted.row(y).data() + 3 * x;
        ASSERT_EQ(shown.pixelColor(place_of(x, y)), QColor(rgb[0], rgb[1], rgb[2]))
            << x << ", " << y;
      }
    }
  }
}

TEST_F(Panel, KeysArePressedByMouseAndKeyboard) {
  lcd_.set_menu({"Go", "Stop", "", "A&B"});
  show();
  EXPECT_EQ(panel_->key(0).text(), "Go");
  EXPECT_EQ(panel_->key(3).text(), "A&&B");
  for (int i = 0; i < 4; ++i) {
    QTest::mouseClick(&panel_->key(i), Qt::LeftButton);
    EXPECT_EQ(keys_.read(), 1 << i);
    QTest::keyClick(&*panel_, static_cast<Qt::Key>(Qt::Key_1 + i));
    EXPECT_EQ(keys_.read(), 1 << i);
    QTest::keyClick(&*panel_, static_cast<Qt::Key>(Qt::Key_F1 + i));
    EXPECT_EQ(keys_.read(), 1 << i);
  }
  QTest::keyClick(&*panel_, Qt::Key_5);
  EXPECT_EQ(keys_.read(), 0);
}

TEST_F(Panel, LabelsAndColoursFollowTheProgram) {
  show();
  EXPECT_EQ(panel_->key(1).text(), "");
  ASSERT_TRUE(lcd_.set_menu_label(2, "Red", {255, 255, 255}, {200, 0, 0}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel_->key(1).text() == "Red"; }));
  EXPECT_TRUE(panel_->key(1).styleSheet().contains("#c80000"));
}

TEST_F(Panel, AClickIsATouchAtThePixelThatIsSeen) {
  show();
  keys_.set_touch_map([this](int x, int y) { return lcd_.key_at(x, y); });
  panel_->lcd().setFixedSize(2 * robios::Lcd::kDefaultWidth, 2 * robios::Lcd::kDefaultHeight);
  QTest::qWait(0);
  QTest::mouseClick(&panel_->lcd(), Qt::LeftButton, {}, place_of(123, 45));
  EXPECT_EQ(keys_.read_touch(), (robios::TouchPoint{123, 45}));
  lcd_.set_menu({"1", "2", "3", "4"});
  QTest::mouseClick(&panel_->lcd(), Qt::LeftButton, {}, place_of(200, 390));
  EXPECT_EQ(keys_.read(), 2);
  QTest::mouseClick(&panel_->lcd(), Qt::RightButton, {}, place_of(1, 1));
  EXPECT_EQ(keys_.read_touch(), (robios::TouchPoint{200, 390})) << "only the left button touches";
}

TEST_F(Panel, TheScreenStaysWhenTheProgramHasEnded) {
  show();
  panel_->tell_end("The program has ended (0)");
  EXPECT_FALSE(panel_->key(0).isEnabled());
  QTest::mouseClick(&panel_->key(0), Qt::LeftButton);
  EXPECT_EQ(keys_.read(), 0);
}

}  // namespace
}  // namespace eyebridge::gui
