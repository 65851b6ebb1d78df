// The world editor's files: saving, changes by others, read-only places.
#include <QDir>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QTest>
#include <csignal>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "disk_spy.hpp"
#include "editor_rig.hpp"
#include "eyebridge/base/config_error.hpp"

namespace eyebridge::gui {
namespace {

using ::testing::HasSubstr;

constexpr const char* kRoom = "# A room.\nfloor 2000 2000\nposition 500 500 90\n0 0 2000 0\n";
constexpr const char* kSim =
    "# Two robots.\nworld room.wld\nsettings VIS\nrobot my.robi\nMine 500 500 0 prog.x a \"b c\"\n"
    "S4 1500 500 90\nenters 4\nerror robot:2 psd:1 4\nGolf 1000 1000 0\nmass 0.1\nmarker 1 2 3 4 "
    "5\n";

class EditorFiles : public testing::EditorRig {
 protected:
  void SetUp() override {
    EditorRig::SetUp();
    folder_.write("room.wld", kRoom);
    folder_.write("my.robi",
                  "drive DIFFERENTIAL_DRIVE\nname Mine\ndiameter 120\nwheel 54 90 1000 1\n");
    folder_.write("two.sim", kSim);
  }
  [[nodiscard]] std::string notice(const QString& topic) const {
    return window_->notices().text(topic).toStdString();
  }
  void place_marker(double x, double y) {
    press_key(Qt::Key_M);
    click(at(x, y));
  }
};

TEST_F(EditorFiles, ASimulationKeepsItsMeaning) {
  open(file("two.sim"));
  EXPECT_EQ(notice("warnings"), "");
  std::vector<Warning> warnings;
  const auto before = files::read_sim(kSim, "a", warnings);
  press_key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_TRUE(files::same_meaning(files::read_sim(text_of("two.sim"), "b", warnings), before))
      << text_of("two.sim");
  EXPECT_THAT(text_of("two.sim"), ::testing::StartsWith("# Two robots.\n"));
  EXPECT_EQ(text_of("room.wld"), kRoom) << "nobody touched it";
  place_marker(1, 1);
  EXPECT_TRUE(window_->isWindowModified());
  press_key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_THAT(text_of("two.sim"), HasSubstr("marker 1000 1000 255 0 0\n"));
  EXPECT_THAT(text_of("two.sim"), HasSubstr("error robot:2 psd:1 sigma=4\n"));
  EXPECT_EQ(text_of("room.wld"), kRoom);
}

TEST_F(EditorFiles, AChangedGroundGoesToItsOwnFile) {
  open(file("two.sim"));
  drag(at(2, 0), at(2, 1));
  ASSERT_TRUE(window_->save()) << notice("save");
  EXPECT_THAT(text_of("room.wld"), HasSubstr("0 0 2000 1000"));
  EXPECT_THAT(text_of("room.wld"), ::testing::StartsWith("# A room.\n"));
  EXPECT_EQ(message(), "Saved room.wld and two.sim");
}

TEST_F(EditorFiles, AnotherNameLeavesTheOldGroundAlone) {
  open(file("two.sim"));
  drag(at(2, 0), at(2, 1));
  ASSERT_TRUE(window_->save_as(file("other.sim"))) << notice("save");
  EXPECT_EQ(text_of("room.wld"), kRoom);
  EXPECT_THAT(text_of("other.sim"), HasSubstr("world other.wld\n"));
  EXPECT_EQ(window_->windowTitle(), "other.sim[*] – world editor");
  // And again, undone steps or not.
  press_key(Qt::Key_Z, Qt::ControlModifier);
  press_key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(window_->save()) << notice("save");
  EXPECT_THAT(text_of("other.sim"), HasSubstr("world other.wld\n"));
  EXPECT_THAT(text_of("other.wld"), HasSubstr("0 0 2000 0\n"));
}

TEST_F(EditorFiles, FromANewFolderAllFilesAreStillFound) {
  open(file("two.sim"));
  QDir(file("")).mkdir("sub");
  ASSERT_TRUE(window_->save_as(file("sub/two.sim"))) << notice("save");
  EXPECT_EQ(notice("run"), "");
  EXPECT_THAT(text_of("sub/two.sim"), HasSubstr("world " + folder_.path() + "/room.wld\n"));
  EXPECT_THAT(text_of("sub/two.sim"), HasSubstr("robot " + folder_.path() + "/my.robi\n"));
}

TEST_F(EditorFiles, ANewWorldIsSavedAsAnyKindThatHoldsIt) {
  open("");
  ASSERT_TRUE(window_->save_as(file("new.wld"))) << notice("save");
  EXPECT_EQ(text_of("new.wld"),
            "floor 4000 4000\n0 0 4000 0\n4000 0 4000 4000\n4000 4000 0 4000\n0 4000 0 0\n");
  ASSERT_TRUE(window_->save_as(file("new.maz"))) << notice("save");
  EXPECT_EQ(text_of("new.maz"), " _.\n|_|\n4000\n");
  place_marker(1, 1);
  EXPECT_FALSE(window_->save_as(file("more.maz")));
  EXPECT_THAT(notice("save"),
              HasSubstr("more.maz: it is no maze: it has a marker at (1000, 1000) mm"));
  EXPECT_FALSE(window_->save_as(file("more.wld")));
  EXPECT_THAT(notice("save"),
              HasSubstr("it has 0 robots, 0 objects, 1 markers: a .wld file holds"));
  EXPECT_FALSE(window_->save_as(file("more.txt")));
  EXPECT_THAT(notice("save"), HasSubstr("expected .wld, .maz or .sim"));
  EXPECT_TRUE(window_->isWindowModified());
  ASSERT_TRUE(window_->save_as(file("more.sim"))) << notice("save");
  EXPECT_EQ(text_of("more.sim"), "world new.maz\nmarker 1000 1000 255 0 0\n");
  EXPECT_EQ(notice("save"), "");
}

TEST_F(EditorFiles, ABoxOfAnySizeLeavesAMazeAsItIs) {
  folder_.write("m.maz", " _ _\n|S  |\n|_|_|\n360\n");
  folder_.write("m.sim",
                "world m.maz\nbox 360 180 0 100 50 30\npolygon 360 560 0 50 0 -50 40 -50 -40\n");
  open(file("m.sim"));
  drag(at(0.36, 0.36), at(0.5, 0.4), Qt::ControlModifier);  // a wall off the grid: no maze
  ASSERT_TRUE(window_->save()) << notice("save");
  EXPECT_THAT(text_of("m.sim"), HasSubstr("world m.wld\n"));
  EXPECT_THAT(text_of("m.sim"), HasSubstr("box 360 180 0 100 50 30\n"));
  EXPECT_THAT(text_of("m.sim"), HasSubstr("polygon 360 560 0 50 0 -50 40 -50 -40\n"));
}

TEST_F(EditorFiles, AMazeStaysAMazeWhileItFits) {
  folder_.write("m.maz", " _ _\n|S  |\n|_|_|\n360\n");
  folder_.write("m.sim", "world m.maz\nMouse S\n");
  open(file("m.sim"));
  click(at(0.36, 0.18));
  press_key(Qt::Key_Delete);
  press_key(Qt::Key_W);
  drag(at(0.36, 0.36), at(0.36, 0.72));
  ASSERT_TRUE(window_->save()) << notice("save");
  EXPECT_EQ(text_of("m.maz"), " _ _.\n|S| |\n|_ _|\n360\n");
  EXPECT_EQ(text_of("m.sim"), "world m.maz\nMouse S\n");
  press_key(Qt::Key_V);
  drag(at(0.36, 0.36), at(0.5, 0.4), Qt::ControlModifier);
  ASSERT_TRUE(window_->save()) << notice("save");
  EXPECT_THAT(text_of("m.sim"), HasSubstr("world m.wld\nMouse 180 540 90\n"));
}

TEST_F(EditorFiles, AReadOnlyPlaceIsToldAndNothingIsLost) {
  open(file("two.sim"));
  place_marker(1, 1);
  EXPECT_FALSE(window_->save_as("/proc/two.sim"));
  EXPECT_THAT(notice("save"), HasSubstr("/proc/two.sim: cannot be written"));
  EXPECT_TRUE(window_->isWindowModified());
  EXPECT_EQ(plan().markers.size(), 2U);
  EXPECT_EQ(window_->path(), file("two.sim"));
}

TEST_F(EditorFiles, ADiskWithoutRoomKeepsTheOldFiles) {
  open(file("room.wld"));
  window_->set_autosave_delay(1'000'000);
  drag(at(2, 0), at(2, 1));
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit little{4, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &little);
  press_key(Qt::Key_S, Qt::ControlModifier);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(notice("save"), HasSubstr("room.wld: cannot be written"));
  EXPECT_EQ(text_of("room.wld"), kRoom);
  EXPECT_TRUE(window_->isWindowModified());
  press_key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_THAT(text_of("room.wld"), HasSubstr("0 0 2000 1000"));
}

TEST_F(EditorFiles, ASimulationAndItsWorldAreSavedBothOrNeither) {
  open(file("two.sim"));
  const std::string before = text_of("two.sim");
  drag(at(2, 0), at(2, 1));  // of the world's file
  place_marker(1, 1);        // of the simulation's
  {
    testing::DiskSpy disk(folder_.path());
    disk.refuse_name("/two.sim");
    EXPECT_FALSE(window_->save());
  }
  EXPECT_THAT(notice("save"), HasSubstr("two.sim: cannot be written"));
  EXPECT_EQ(text_of("room.wld"), kRoom);
  EXPECT_EQ(text_of("two.sim"), before);
  EXPECT_TRUE(window_->isWindowModified());
  EXPECT_EQ(notice("disk"), "");
  ASSERT_TRUE(window_->save()) << notice("save") << notice("disk");
  EXPECT_THAT(text_of("room.wld"), HasSubstr("0 0 2000 1000"));
  EXPECT_THAT(text_of("two.sim"), HasSubstr("marker 1000 1000"));
}

// The robots' numbers change with it, and so all that is known of robots: fields are made anew.
TEST_F(EditorFiles, AFieldLivesUntilItHasToldOfItsChange) {
  open(file("two.sim"));
  press_key(Qt::Key_V);
  click(at(0.5, 0.5));
  ASSERT_EQ(window_->document().selection(), (Selection{{Kind::Robot, 0}}));
  const QPointer<QWidget> field = window_->properties().field("Enters after");
  ASSERT_FALSE(field.isNull());
  field->setFocus();
  QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(field, "5");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_FALSE(field.isNull()) << "it was deleted while it told";
  EXPECT_EQ(plan().robots.at(0).enters, 5.0);
  EXPECT_NE(window_->properties().field("Enters after"), field.data());
  EXPECT_TRUE(QTest::qWaitFor([&] { return field.isNull(); }, 60'000));
}

TEST_F(EditorFiles, WhatARunWouldRefuseIsToldAtOnce) {
  open("");
  press_key(Qt::Key_R);
  click(at(0, 2));
  ASSERT_TRUE(window_->save_as(file("bad.sim")));
  EXPECT_THAT(notice("run"), HasSubstr("S4 (186 mm across) at (0, 2000) mm stands in the wall"));
}

TEST_F(EditorFiles, ABadFileIsToldWithItsLineAndIsNotTouched) {
  folder_.write("bad.wld", "floor 2000 2000\n0 0 oops 0\n");
  open(file("bad.wld"));
  EXPECT_THAT(notice("open"), HasSubstr("bad.wld:2:5"));
  EXPECT_EQ(window_->path(), "");
  EXPECT_EQ(plan().walls.size(), 4U);
}

TEST_F(EditorFiles, AMapIsNoPlan) {
  folder_.write("map.yaml", "image: map.pgm\n");
  open(file("map.yaml"));
  EXPECT_THAT(notice("open"), HasSubstr("it cannot be edited as it is: expected .wld"));
  EXPECT_EQ(window_->path(), "");
}

TEST_F(EditorFiles, AFileThatChangedIsLoadedAgain) {
  open(file("room.wld"));
  folder_.write("room.wld", "floor 3000 2000\n");
  ASSERT_TRUE(QTest::qWaitFor([&] { return plan().width == 3.0; }, 60'000));
  EXPECT_FALSE(window_->isWindowModified());
  press_key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(plan().width, 2.0) << "even that can be undone";
}

TEST_F(EditorFiles, OwnEditsAreNotLostToAChangedFile) {
  open(file("room.wld"));
  drag(at(2, 0), at(2, 1));
  folder_.write("room.wld", "floor 3000 2000\n");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !notice("disk").empty(); }, 60'000));
  EXPECT_EQ(plan().width, 2.0);
  EXPECT_FALSE(window_->save()) << "not over somebody's work without a word";
  answer_notice("The file: load it");
  EXPECT_EQ(plan().width, 3.0);
  press_key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(plan().walls.at(0).b, (Vec2{2, 1})) << "the edits are back";
  ASSERT_TRUE(window_->save());
  EXPECT_THAT(text_of("room.wld"), HasSubstr("floor 2000 2000"));
}

TEST_F(EditorFiles, OwnEditsAreKeptWhereOneSaysSo) {
  open(file("room.wld"));
  drag(at(2, 0), at(2, 1));
  folder_.write("room.wld", "floor 3000 2000\n");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !notice("disk").empty(); }, 60'000));
  answer_notice("Keep mine");
  EXPECT_EQ(notice("disk"), "");
  ASSERT_TRUE(window_->save());
  EXPECT_THAT(text_of("room.wld"), HasSubstr("0 0 2000 1000"));
}

TEST_F(EditorFiles, AFileThatGoesWrongOrAwayLeavesThePlan) {
  open(file("room.wld"));
  folder_.write("room.wld", "rubbish\n");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !notice("disk").empty(); }, 60'000));
  EXPECT_THAT(notice("disk"), HasSubstr("room.wld:1:1"));
  EXPECT_EQ(plan().walls.size(), 1U);
  EXPECT_TRUE(window_->isWindowModified());
  answer_notice("Keep mine");
  QFile::remove(file("room.wld"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !notice("disk").empty(); }, 60'000));
  answer_notice("Keep mine");
  ASSERT_TRUE(window_->save());
  EXPECT_THAT(text_of("room.wld"), HasSubstr("0 0 2000 0"));
}

TEST_F(EditorFiles, ClosingAsksWhatBecomesOfEdits) {
  open(file("room.wld"));
  drag(at(2, 0), at(2, 1));
  EXPECT_FALSE(window_->close());
  auto* const box = window_->findChild<QMessageBox*>("unsaved");
  ASSERT_NE(box, nullptr);
  QTest::mouseClick(box->button(QMessageBox::Cancel), Qt::LeftButton);
  EXPECT_TRUE(window_->isVisible());
  EXPECT_FALSE(window_->close());
  window_->answer(EditorWindow::Answer::Save);
  EXPECT_FALSE(window_->isVisible());
  EXPECT_THAT(text_of("room.wld"), HasSubstr("0 0 2000 1000"));
}

TEST_F(EditorFiles, AFloorPlanIsImportedAndCanBeUndone) {
  QImage picture(100, 50, QImage::Format_RGB32);
  picture.fill(Qt::white);
  for (int x = 10; x < 90; ++x) picture.setPixelColor(x, 20, Qt::black);
  ASSERT_TRUE(picture.save(file("plan.png")));
  open("");
  ASSERT_TRUE(window_->import_floor_plan(file("plan.png"), {0.02, {}, 0.5}, true));
  EXPECT_EQ(plan().width, 2.0);
  EXPECT_EQ(plan().walls.size(), 4U);
  press_key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(plan().width, 4.0);
  EXPECT_FALSE(window_->import_floor_plan(file("none.png"), {}, true));
  EXPECT_THAT(notice("import"), HasSubstr("none.png: no picture"));
}

TEST_F(EditorFiles, RobotsOfAFileCanBePlaced) {
  open("");
  EXPECT_FALSE(window_->add_description(file("none.robi")));
  EXPECT_THAT(notice("describe"), HasSubstr("none.robi"));
  ASSERT_TRUE(window_->add_description(file("my.robi")));
  press_key(Qt::Key_R);
  click(at(1, 1));
  EXPECT_EQ(plan().robots.at(0).model, "Mine");
  ASSERT_TRUE(window_->save_as(file("mine.sim"))) << notice("save");
  EXPECT_EQ(notice("run"), "");
  press_key(Qt::Key_Z, Qt::ControlModifier);
  press_key(Qt::Key_Z, Qt::ControlModifier);
  press_key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(plan().rest.robot_files.empty()) << "undone";
}

TEST_F(EditorFiles, ATextureThatIsMissingIsTold) {
  open(file("room.wld"));
  window_->properties().set_value("Texture", "none.png");
  EXPECT_THAT(notice("texture"), HasSubstr("none.png is not found"));
  QImage(8, 8, QImage::Format_RGB32).save(file("grass.png"));
  window_->properties().set_value("Texture", "grass.png");
  EXPECT_EQ(notice("texture"), "");
}

TEST_F(EditorFiles, CommentsThatCannotBeKeptAreTold) {
  folder_.write("c.wld", "# top\nfloor 2000 2000 # here\n\n; between\n0 0 2000 0\n");
  open(file("c.wld"));
  EXPECT_THAT(notice("warnings"), HasSubstr("2 lines have comments"));
}

}  // namespace
}  // namespace eyebridge::gui
