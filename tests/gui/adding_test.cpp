// A person adds a robot to a run that began with one, by mouse, from outside of it.
#include <QTest>
#include <array>
#include <string>

#include <gtest/gtest.h>

#include "environment_fixture.hpp"
#include "person.hpp"
#include "running_program.hpp"

namespace eyebridge::gui {
namespace {

using eyebridge::testing::RunningProgram;

/// The same window in this process, to find where the other one's controls are.
class Twin : public testing::EnvironmentFixture {
 protected:
  void look_like(QSize size) {
    window_->resize(size);
    QTest::keyClick(&*window_, Qt::Key_A);
    ASSERT_TRUE(QTest::qWaitFor([&] { return control("add_place").isVisible(); }));
    ASSERT_EQ(window_->size(), size);
  }
  QWidget& control(const char* name) { return *window_->findChild<QWidget*>(name); }
  QPoint place_of(const char* name) {
    return control(name).mapTo(&*window_, control(name).rect().center());
  }
  QPoint floor_at(double x, double y) { return window_->view().mapTo(&*window_, at(x, y)); }
};

class Adding : public Twin, public ::testing::WithParamInterface<const char*> {};

TEST_P(Adding, ARobotIsAddedByMouseToARunWithOne) {
  const eyebridge::testing::ScratchFolder folder;
  folder.write("one.c",
               "#include <eyebot.h>\nint main(void) {\n  LCDMenu(\"END\", \"\", \"\", \"\");\n"
               "  VWSetSpeed(0, 20);\n  while (KEYRead() != KEY1) OSWait(20);\n  return 7;\n}\n");
  folder.write(
      "two.c",
      "#include <eyebot.h>\n#include <stdio.h>\nint main(void) {\n"
      "  int x, y, z, phi;\n  SIMGetRobot(0, &x, &y, &z, &phi);\n"
      "  printf(\"robot %d at %d %d\\n\", OSMachineID(), (x + 50) / 100, (y + 50) / 100);\n"
      "  fflush(stdout);\n  LCDMenu(\"END\", \"\", \"\", \"\");\n"
      "  while (KEYRead() != KEY1) OSWait(20);\n"
      "  puts(\"two ends\");\n  return 0;\n}\n");
  const auto built = eyebridge::testing::run_program(
      {{"sh", "-c",
        "for p in one two; do " EYEBRIDGE_BIN "/eyebridge-cc $p.c -o $p || exit 1; done"},
       {},
       folder.path()});
  ASSERT_EQ(built.exit_code, 0) << built.err;

  testing::Person person;
  RunningProgram run({{EYEBRIDGE_BIN "/eyebridge", "run", "--gui", GetParam(), "--world",
                       room_.folder() + "/room.sim", "./one"},
                      {{"XDG_CONFIG_HOME", folder.path()}, {"XDG_RUNTIME_DIR", folder.path()}},
                      folder.path()});
  const xcb_window_t first = person.window("one – robot");
  const xcb_window_t environment = person.window("one – environment");
  ASSERT_NO_FATAL_FAILURE(look_like(person.place(environment).size()));
  window_->hide();  // it may lie above the other one
  person.type(environment, 'a');
  // What is drawn there tells that the controls are.
  const QPoint button = place_of("add_place");
  const QImage mine = control("add_place").grab().toImage();
  const QRect there(button - mine.rect().center(), mine.size());
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return person.picture(environment).copy(there).pixelColor(3, 3) == mine.pixelColor(3, 3);
      },
      30'000));
  person.click(environment, place_of("add_program"));
  for (const char letter : std::string("./two")) person.type(environment, letter);
  person.click(environment, button);
  person.click(environment, floor_at(1.0, 0.7));
  run.wait_for("robot 3 at 10 7\n");
  const xcb_window_t added = person.window("two – robot 3");
  person.type(added, '1');
  run.wait_for("two ends\n");
  person.close(added);
  person.type(first, '1');
  EXPECT_EQ(person.window("environment – ended"), environment);
  person.close(environment);
  person.close(first);
  EXPECT_EQ(run.wait(), 7) << run.said();
}

std::string name_of(const ::testing::TestParamInfo<const char*>& way) {
  const std::array<const char*, 3> names = {"Real", "Virtual", "OfOne"};
  return names.at(way.index);
}
INSTANTIATE_TEST_SUITE_P(Runs, Adding, ::testing::Values("--factor=1", "--fast", "--robots=1"),
                         name_of);

}  // namespace
}  // namespace eyebridge::gui
