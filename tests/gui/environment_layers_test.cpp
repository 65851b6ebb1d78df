// What the environment draws beside walls and bodies, and the files that it offers.
#include <QFile>
#include <QMenu>
#include <QSettings>
#include <QTest>

#include <gtest/gtest.h>

#include "editor/editor_window.hpp"
#include "environment_fixture.hpp"
#include "eyebridge/hal/hand_guide.hpp"
#include "widgets/recent_files.hpp"

namespace eyebridge::gui {
namespace {

class LayerTest : public testing::EnvironmentFixture {
 protected:
  QImage seen() { return window_->view().grab().toImage(); }
};

/// Believes that the robot is at (1, 0.5), give or take 100 mm.
struct SureGuide final : hal::HandGuide {
  [[nodiscard]] hal::HandLook look() const override { return told; }
  hal::HandLook told;
};

TEST_F(LayerTest, WhereARobotIsBelievedToBeIsShownAndHidden) {
  SureGuide guide;
  guide.told.pose = Pose{1.0, 0.6, 0.0};
  guide.told.covariance = {0.0025, 0, 0, 0, 0.0025, 0, 0, 0, 0.01};
  EXPECT_FALSE(is_drawn_at(1.0, 0.68));
  window_->view().set_guide(guide);
  window_->view().refresh();
  EXPECT_TRUE(is_drawn_at(1.0, 0.68));
  EXPECT_FALSE(is_drawn_at(1.0, 0.75)) << "beyond 2.45 deviations";
  QTest::keyClick(&*window_, Qt::Key_U);
  EXPECT_FALSE(is_drawn_at(1.0, 0.68));
  QTest::keyClick(&*window_, Qt::Key_U);
  guide.told.pose.reset();
  window_->view().refresh();
  EXPECT_FALSE(is_drawn_at(1.0, 0.68)) << "nobody knows";
}

TEST_F(LayerTest, TrailsArePaintedOnceAndStayUntilTheyAreCleared) {
  Layers only_trails{true, false, false, false, false, false, false};
  window_->view().set_layers(only_trails);
  ASSERT_TRUE(room_.robot().drive()->set_speed({0.2, 0.0}));
  for (int i = 0; i < 20; ++i) {
    room_.pass(0.1);
    window_->view().refresh();
    seen();  // bit by bit
  }
  ASSERT_NEAR(room_.pose(1).x, 0.88, 0.04);
  EXPECT_TRUE(is_drawn_at(0.55, 0.5));
  EXPECT_TRUE(is_drawn_at(0.72, 0.5));
  const QImage bit_by_bit = seen();
  window_->view().zoom(1.5);
  window_->view().fit();
  const QImage at_once = seen();
  int different = 0;
  for (int y = 0; y < at_once.height(); ++y) {
    for (int x = 0; x < at_once.width(); ++x) {
      const QColor a = at_once.pixelColor(x, y);
      const QColor b = bit_by_bit.pixelColor(x, y);
      if (std::abs(a.red() - b.red()) > 48) ++different;
    }
  }
  EXPECT_LT(different, 20);
  window_->view().clear_trails();
  EXPECT_FALSE(is_drawn_at(0.55, 0.5));
}

QStringList offered(QWidget& window) {
  for (QMenu* menu : window.findChildren<QMenu*>()) {
    if (menu->title().remove('&') != "Open recent") continue;
    emit menu->aboutToShow();
    QStringList texts;
    for (const QAction* action : menu->actions()) {
      if (!action->isSeparator()) texts << action->text();
    }
    return texts;
  }
  return {"no such menu"};
}

TEST_F(LayerTest, RecentFilesAreOfferedTheNewestFirst) {
  EXPECT_EQ(offered(*window_), QStringList("None yet"));
  const QString folder = QString::fromStdString(room_.folder());
  const QString room = folder + "/room.wld";
  const QString sim = folder + "/room.sim";
  {
    EditorWindow editor(room);
    EXPECT_EQ(offered(editor), QStringList(room));
    ASSERT_TRUE(editor.open(sim));
  }
  remember_file(kRecentPrograms, folder + "/gone.c");
  EXPECT_EQ(offered(*window_), QStringList({sim, room})) << "what is gone is not offered";
  QString asked;
  window_->on_edit = [&](const QString& path) { asked = path; };
  action(room).trigger();
  EXPECT_EQ(asked, room);
  for (int i = 0; i < 12; ++i) remember_file(kRecentWorlds, folder + QString("/%1.wld").arg(i));
  EXPECT_EQ(recent_files(kRecentWorlds).size(), 10);
  EXPECT_EQ(recent_files(kRecentWorlds).front(), folder + "/11.wld");
}

}  // namespace
}  // namespace eyebridge::gui
