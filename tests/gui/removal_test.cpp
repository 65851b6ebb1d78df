// Robots that leave while people look.
#include <QComboBox>
#include <QContextMenuEvent>
#include <QMenu>
#include <QMessageBox>
#include <QTest>
#include <csignal>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "environment_fixture.hpp"
#include "eyebridge/hal/shared_world.hpp"
#include "person.hpp"
#include "running_program.hpp"

namespace eyebridge::gui {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

class Removal : public testing::EnvironmentFixture {};

TEST_F(Removal, TheChosenRobotIsRemovedWhenThePersonSaysYes) {
  window_->view().choose(1);
  const auto asked = [&] { return window_->findChild<QMessageBox*>("removal"); };
  QTest::keyClick(&window_->view(), Qt::Key_Delete);
  ASSERT_NE(asked(), nullptr);
  EXPECT_TRUE(asked()->text().startsWith("Remove robot 2?"));
  QTest::mouseClick(asked()->button(QMessageBox::Cancel), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return asked() == nullptr; }));
  EXPECT_TRUE(crew_.removed.empty());
  action("Remove...").trigger();
  ASSERT_NE(asked(), nullptr);
  QTest::keyClick(asked(), Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([&] {
    return window_->findChild<QLabel*>("trouble")->text() == "Robot 2 has been removed";
  }));
  const std::lock_guard lock(crew_.mutex);
  EXPECT_EQ(crew_.removed, (std::vector<std::size_t>{1}));
}

TEST_F(Removal, TheRightButtonOffersWhatCanBeDoneWithARobot) {
  WorldView& view = window_->view();
  const auto menu = [&] { return window_->findChild<QMenu*>("robot_menu"); };
  const auto press_right = [&](QPoint place) {
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, view.mapToGlobal(place));
    QApplication::sendEvent(&view, &event);
  };
  press_right(at(1.0, 0.9));
  EXPECT_EQ(menu(), nullptr) << "nothing is there";
  press_right(at(1.5, 0.5));
  ASSERT_NE(menu(), nullptr);
  EXPECT_EQ(view.chosen(), 1U);
  EXPECT_TRUE(menu()->actions().contains(&action("Remove...")));
  menu()->close();
}

TEST(RemoveRobot, IsNotOfferedWhereARunHasOne) {
  testing::Room room;
  EnvironmentWindow window(room.environment(), "square");
  window.view().choose(0);
  window.ask_to_remove();
  EXPECT_EQ(window.findChild<QMessageBox*>("removal"), nullptr);
}

/// The room of two robots, which can leave it.
class LeavingRoom {
 public:
  LeavingRoom() {
    folder_.write("room.wld",
                  "floor 2000 1000\n0 0 2000 0\n2000 0 2000 1000\n2000 1000 0 1000\n0 1000 0 0\n");
    const std::string sim =
        folder_.write("room.sim", "world room.wld\nS4 500 500 0\nS4 1500 500 180\n");
    const hal::Config config =
        hal::Config::load({{{"world", sim}, {"fast", "true"}, {"robots", "2"}}, {}, {}});
    world_ = hal::open_shared_world(config, log_, &turns_);
  }
  hal::SharedWorld& world() { return *world_; }

 private:
  struct Silence final : LogSink {
    void write(Severity, std::string_view) override {}
  };
  struct NoTurns final : hal::Turns {
    [[nodiscard]] const Time& limit_of(std::size_t) const override { return never; }
    void wait(std::size_t, Time) override {}
    Time never = Time::max();
  };
  eyebridge::testing::ScratchFolder folder_;
  Silence log_;
  NoTurns turns_;
  std::shared_ptr<hal::SharedWorld> world_;
};

TEST(RemovedRobot, IsShownNoMoreAndCannotBeChosen) {
  QSettings().clear();
  LeavingRoom room;
  EnvironmentWindow window(room.world().environment(), "square");
  window.resize(1000, 900);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  WorldView& view = window.view();
  view.fit();
  view.choose_next();
  ASSERT_EQ(view.chosen(), 1U);
  const QPoint place = view.viewport().to_pixel({1.5, 0.45}).toPoint();
  const QPoint floor = view.viewport().to_pixel({0.6, 0.9}).toPoint();
  ASSERT_LT(view.mirror().distance_rays(0).at(0).range, 1.0);
  ASSERT_NE(view.grab().toImage().pixelColor(place), view.grab().toImage().pixelColor(floor));
  auto& targets = *window.findChild<QComboBox*>("error_target");
  ASSERT_EQ(targets.count(), 3);

  ASSERT_TRUE(room.world().leave(1));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !view.chosen(); }));
  EXPECT_EQ(view.grab().toImage().pixelColor(place), view.grab().toImage().pixelColor(floor));
  EXPECT_GT(view.mirror().distance_rays(0).at(0).range, 1.3) << "as far as the wall";
  EXPECT_TRUE(QTest::qWaitFor([&] { return targets.count() == 2; })) << "all, and robot 1";
  QTest::mouseClick(&view, Qt::LeftButton, {}, place);
  EXPECT_FALSE(view.chosen());
  for (int i = 0; i < 2; ++i) {
    view.choose_next();
    EXPECT_EQ(view.chosen(), 0U);
  }
}

/// Two robots that drive until they are told to end.
TEST(RemovalSession, APersonRemovesARobotAndItsPanelGoes) {
  const eyebridge::testing::ScratchFolder folder;
  folder.write("drives.c",
               "#include <eyebot.h>\n#include <stdio.h>\nint main(void) {\n"
               "  LCDPrintf(\"going\");\n  VWSetSpeed(0, 20);\n"
               "  printf(\"robot %d is going\\n\", OSMachineID());\n  fflush(stdout);\n"
               "  while (KEYRead() != KEY1) OSWait(20);\n  return 7;\n}\n");
  const auto built = eyebridge::testing::run_program(
      {{EYEBRIDGE_BIN "/eyebridge-cc", "drives.c", "-o", "drives"}, {}, folder.path()});
  ASSERT_EQ(built.exit_code, 0) << built.err;
  testing::Person person;
  eyebridge::testing::RunningProgram run(
      {{EYEBRIDGE_BIN "/eyebridge", "run", "--robots", "2", "--out", "out", "./drives"},
       {{"XDG_CONFIG_HOME", folder.path()}, {"XDG_RUNTIME_DIR", folder.path()}},
       folder.path()});
  const xcb_window_t environment = person.window("– environment");
  const xcb_window_t first = person.window("robot 1");
  person.window("robot 2");
  ASSERT_THAT(run.wait_for("robot 2 is going\n"), HasSubstr("robot 2 is going\n"));
  person.type(environment, 'n');  // robot 2
  constexpr std::uint32_t kDelete = 0xffff;
  constexpr std::uint32_t kReturn = 0xff0d;
  person.press(environment, kDelete);
  person.press(person.window("Remove robot"), kReturn);
  person.wait_until_gone("robot 2");
  EXPECT_THAT(eyebridge::testing::file_text(folder.path() + "/out/robot-2/lcd.txt"),
              HasSubstr("going"));
  EXPECT_THAT(person.titles(), Contains(HasSubstr("robot 1")));
  EXPECT_THAT(person.titles(), Not(Contains(HasSubstr("ended"))));
  person.type(first, '1');
  EXPECT_EQ(person.window("environment – ended"), environment);
  person.close(environment);
  person.close(first);
  EXPECT_EQ(run.wait(), 7) << run.said();
}

/// Another terminal removes it while its panel is the last window.
TEST(RemovalSession, APanelThatGoesDoesNotEndTheRun) {
  const eyebridge::testing::ScratchFolder folder;
  folder.write("drives.c",
               "#include <eyebot.h>\n#include <stdio.h>\nint main(void) {\n"
               "  const int me = OSMachineID();\n  LCDPrintf(\"going\");\n"
               "  for (int i = 0; me == 2 || i < 150; ++i) OSWait(20);\n  return 5;\n}\n");
  const auto built = eyebridge::testing::run_program(
      {{EYEBRIDGE_BIN "/eyebridge-cc", "drives.c", "-o", "drives"}, {}, folder.path()});
  ASSERT_EQ(built.exit_code, 0) << built.err;
  testing::Person person;
  const std::map<std::string, std::string> own = {{"XDG_CONFIG_HOME", folder.path()},
                                                  {"XDG_RUNTIME_DIR", folder.path()}};
  eyebridge::testing::RunningProgram run(
      {{EYEBRIDGE_BIN "/eyebridge", "run", "--robots", "2", "./drives"}, own, folder.path()});
  const xcb_window_t environment = person.window("– environment");
  person.close(person.window("robot 1"));
  person.wait_until_gone("robot 1");
  person.window("robot 2");
  person.close(environment);
  person.wait_until_gone("environment");
  const auto removed = eyebridge::testing::run_program(
      {{EYEBRIDGE_BIN "/eyebridge", "remove", "2"}, own, folder.path()});
  EXPECT_EQ(removed.out, "2\n") << removed.err;
  person.wait_until_gone("robot 2");
  EXPECT_EQ(run.wait(), 5) << "robot 1 went on to its end; " << run.said();
}

}  // namespace
}  // namespace eyebridge::gui
