// Files that are written all or none, or in another thread.
#include <QFile>
#include <QTest>
#include <atomic>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "disk_spy.hpp"
#include "run_program.hpp"
#include "widgets/file_keeper.hpp"
#include "widgets/save_picture.hpp"
#include "widgets/whole_file.hpp"

namespace eyebridge::gui {
namespace {

using eyebridge::testing::file_text;
using ::testing::IsEmpty;

class KeptFiles : public ::testing::Test {
 protected:
  [[nodiscard]] QString path(const std::string& name) const {
    return QString::fromStdString(folder_.path() + "/" + name);
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    return file_text(folder_.path() + "/" + name);
  }

  eyebridge::testing::ScratchFolder folder_;
  testing::DiskSpy disk_{folder_.path()};
};

TEST_F(KeptFiles, SeveralAreWrittenTogether) {
  folder_.write("a", "old");
  const WriteEnd end = write_all({{path("a"), "new"}, {path("b"), "more"}});
  EXPECT_EQ(end.why, "");
  EXPECT_EQ(text("a"), "new");
  EXPECT_EQ(text("b"), "more");
}

TEST_F(KeptFiles, NoneIsWrittenWhereOneHasNoPlace) {
  folder_.write("a", "old");
  const WriteEnd end = write_all({{path("a"), "new"}, {path("nowhere/b"), "more"}});
  EXPECT_EQ(end.path, path("nowhere/b"));
  EXPECT_NE(end.why, "");
  EXPECT_THAT(end.torn, IsEmpty());
  EXPECT_EQ(text("a"), "old");
}

TEST_F(KeptFiles, TheFirstOnesComeBackWhereTheLastOneFailsLate) {
  folder_.write("a", "old");
  folder_.write("c", "old c");
  disk_.refuse_name("/c");
  const WriteEnd end = write_all({{path("a"), "new"}, {path("b"), "new b"}, {path("c"), "new c"}});
  EXPECT_EQ(end.path, path("c"));
  EXPECT_NE(end.why, "");
  EXPECT_THAT(end.torn, IsEmpty());
  EXPECT_EQ(text("a"), "old");
  EXPECT_FALSE(QFile::exists(path("b"))) << "it was not there before";
  EXPECT_EQ(text("c"), "old c");
}

TEST_F(KeptFiles, APictureThatCannotBeWrittenLeavesTheOldOne) {
  folder_.write("a.png", "the old picture");
  const QImage picture(8, 8, QImage::Format_RGB32);
  disk_.refuse_name("/a.png");
  EXPECT_FALSE(save_picture(picture, path("a.png")));
  EXPECT_EQ(text("a.png"), "the old picture");
  disk_.refuse_name("");
  EXPECT_TRUE(save_picture(picture, path("a.png")));
  EXPECT_EQ(QImage(path("a.png")).size(), picture.size());
}

TEST_F(KeptFiles, TheDiskIsWaitedForInAnotherThread) {
  QStringList told;
  {
    FileKeeper keeper([&](const QString& file, const QString& why) { told << file + why; });
    keeper.write(path("a"), [] { return QByteArray("first"); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return told.size() == 1; }, 60'000));
    EXPECT_EQ(text("a"), "first");
    EXPECT_EQ(told.at(0), path("a"));
    keeper.write(path("a"), [] { return QByteArray("second"); });
  }
  EXPECT_EQ(text("a"), "second") << "its end waits for it";
  EXPECT_EQ(disk_.own_syncs(), 0);
  EXPECT_GE(disk_.other_syncs(), 2);
}

TEST_F(KeptFiles, OfTextsThatHaveToWaitTheLastOneIsWritten) {
  std::atomic<bool> may_go = false;
  std::atomic<int> made = 0;
  FileKeeper keeper([](const QString&, const QString&) {});
  keeper.write(path("slow"), [&] {
    while (!may_go) std::this_thread::yield();
    return QByteArray("slow");
  });
  for (int i = 0; i < 10; ++i) {
    keeper.write(path("a"), [&made, i] {
      ++made;
      return QByteArray::number(i);
    });
  }
  keeper.write(path("b"), [] { return QByteArray("b"); });
  keeper.remove(path("b"));
  may_go = true;
  keeper.finish();
  EXPECT_EQ(text("a"), "9");
  EXPECT_LE(made, 2) << "once, or twice where the first one came before the slow one";
  EXPECT_FALSE(QFile::exists(path("b")));
}

TEST_F(KeptFiles, WhatCannotBeWrittenIsTold) {
  QString told;
  FileKeeper keeper([&](const QString&, const QString& why) { told = why; });
  keeper.write(path("nowhere/a"), [] { return QByteArray("text"); });
  EXPECT_TRUE(QTest::qWaitFor([&] { return !told.isEmpty(); }, 60'000));
}

}  // namespace
}  // namespace eyebridge::gui
