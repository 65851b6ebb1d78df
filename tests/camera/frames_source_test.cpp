// Folders of pictures and recordings as cameras: what comes when, and what cannot be one.

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/source.hpp"
#include "fake_clock.hpp"
#include "frame_files.hpp"
#include "frames/frame_series.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr Time kLong = std::chrono::seconds(100);

/// Wall time, as far as a source can tell.
class FakeWallClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override { return now_; }
  void wait_until(Time deadline) override { now_ = std::max(now_, deadline + lateness); }
  void spend(Time) override {}
  [[nodiscard]] bool is_virtual() const override { return false; }
  void pass(Time time) { now_ += time; }
  Time lateness{0};

 private:
  Time now_{0};
};

class Frames : public ::testing::Test {
 protected:
  void open(const std::string& url) {
    source_ = open_source("frames:" + url, {&clock_, nullptr, nullptr});
  }
  /// The number that the next frame shows; -1 when there is none, which error_ then tells.
  int next() {
    const Result<FramePtr> frame = source_->next(clock_.now() + kLong);
    if (!frame) {
      error_ = frame.error();
      return -1;
    }
    last_ = *frame;
    return number_of(**frame);
  }
  std::vector<int> next(int count) {
    std::vector<int> numbers;
    for (int i = 0; i < count; ++i) numbers.push_back(next());
    return numbers;
  }
  /// What is said when `url` is opened; "" when it can be.
  std::string complaint(const std::string& url) {
    try {
      open(url);
      return "";
    } catch (const ConfigError& error) {
      EXPECT_EQ(error.where().file, "--camera");
      return error.text();
    }
  }
  /// The same, found by the check before anything is opened.
  std::string early_complaint(const std::string& url) {
    try {
      check_source("frames:" + url, {&clock_, nullptr, nullptr});
      return "";
    } catch (const ConfigError& error) {
      return error.text();
    }
  }

  FrameFiles files_;
  FakeWallClock clock_;
  std::unique_ptr<Source> source_;
  FramePtr last_;
  Error error_;
};

TEST_F(Frames, PicturesComeInTheNaturalOrderOfTheirNames) {
  open(files_.folder(12));
  EXPECT_THAT(next(12), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11));
}

TEST_F(Frames, OtherFilesOfAFolderAreLeftOut) {
  const std::string folder = files_.folder(2);
  std::ofstream(folder + "/times.txt") << "no picture";
  std::filesystem::rename(folder + "/frame 1.png", folder + "/frame 1.PNG");
  open(folder);
  EXPECT_THAT(next(2), ElementsAre(0, 1));
}

TEST_F(Frames, AFolderBeginsWithTheFirstFrameThatIsAskedFor) {
  open(files_.folder(3) + "?fps=10");
  clock_.pass(std::chrono::seconds(7));
  EXPECT_EQ(next(), 0);
  EXPECT_EQ(last_->time, std::chrono::seconds(7));
  EXPECT_EQ(next(), 1);
  EXPECT_EQ(clock_.now(), std::chrono::milliseconds(7100));
}

TEST_F(Frames, ARecordingKeepsItsTimesOnTheRobotsClock) {
  open(files_.recording(90));
  clock_.pass(std::chrono::seconds(1));
  EXPECT_EQ(next(), 30) << "the newest that is due";
  EXPECT_EQ(last_->time, std::chrono::seconds(1));
  EXPECT_EQ(last_->sequence, 0U);
  clock_.pass(std::chrono::seconds(1));
  EXPECT_EQ(next(), 60);
  EXPECT_EQ(last_->sequence, 30U) << "the gap is what was skipped";
}

TEST_F(Frames, WhoWakesLateGetsTheNewest) {
  open(files_.folder(20));
  EXPECT_EQ(next(), 0);
  clock_.lateness = std::chrono::milliseconds(70);
  EXPECT_EQ(next(), 3);
}

TEST_F(Frames, EachFrameCanBeAskedForHoweverLate) {
  open(files_.recording(90) + "?pick=each");
  clock_.pass(std::chrono::seconds(2));
  EXPECT_THAT(next(3), ElementsAre(0, 1, 2));
  EXPECT_EQ(clock_.now(), std::chrono::seconds(2));
  EXPECT_EQ(last_->time, numbered(2).time);
}

TEST_F(Frames, AtItsEndASeriesSaysSo) {
  open(files_.folder(2));
  next(2);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(next(), -1);
    EXPECT_EQ(error_.code, Errc::Disconnected);
    EXPECT_THAT(error_.what, HasSubstr("pictures has ended at 0.033333 s (end=loop"));
  }
  EXPECT_EQ(clock_.now(), Time(33'333'333)) << "nothing was waited for";
}

TEST_F(Frames, TheLastPictureIsHeldAsNewFrames) {
  open(files_.folder(2) + "?end=hold&fps=10");
  EXPECT_THAT(next(4), ElementsAre(0, 1, 1, 1));
  EXPECT_EQ(last_->sequence, 3U);
  EXPECT_EQ(last_->time, std::chrono::milliseconds(300));
  EXPECT_EQ(clock_.now(), std::chrono::milliseconds(300));
  clock_.pass(std::chrono::seconds(10));
  EXPECT_EQ(next(), 1);
  EXPECT_EQ(last_->time, std::chrono::milliseconds(10300));
  EXPECT_EQ(last_->sequence, 103U);
}

TEST_F(Frames, TwoFramesOfOneMomentDoNotMakeTheHeldOnesComeAtOnce) {
  {
    RecordingFile file(files_.path("pair.ebrec"), {});
    FrameWriter writer(file, FrameCodec::Lossless);
    for (const int i : {0, 1, 2}) writer.add(numbered(i), numbered(std::min(i, 1)).time);
    file.commit();
  }
  open(files_.path("pair.ebrec") + "?end=hold&pick=each");
  EXPECT_THAT(next(3), ElementsAre(0, 1, 2));
  EXPECT_EQ(clock_.now(), numbered(1).time);
  EXPECT_EQ(next(), 2);
  EXPECT_EQ(clock_.now(), 2 * numbered(1).time);
}

TEST_F(Frames, ALoopBeginsAgainWithTimesThatGoOn) {
  open(files_.folder(3) + "?end=loop&fps=10");
  EXPECT_THAT(next(7), ElementsAre(0, 1, 2, 0, 1, 2, 0));
  EXPECT_EQ(last_->time, std::chrono::milliseconds(600));
  EXPECT_EQ(last_->sequence, 6U);
  clock_.pass(std::chrono::milliseconds(30'150));  // a hundred rounds and more
  EXPECT_EQ(next(), 1) << "of the round that is on now";
  EXPECT_EQ(last_->time, std::chrono::milliseconds(30'700));
  EXPECT_EQ(last_->sequence, 307U);
}

TEST_F(Frames, ARecordingLoopsWithoutAPauseAtItsStart) {
  RecordingFile file(files_.path("late.ebrec"), {});
  FrameWriter writer(file, FrameCodec::Lossless);
  for (int i = 60; i < 63; ++i) writer.add(numbered(i), numbered(i).time);
  file.commit();
  open(files_.path("late.ebrec") + "?end=loop");
  EXPECT_THAT(next(4), ElementsAre(60, 61, 62, 60));
  EXPECT_EQ(clock_.now(), numbered(62).time + (numbered(62).time - numbered(61).time));
  EXPECT_EQ(last_->sequence, 3U);
}

TEST_F(Frames, ACameraThatWasOpenedAgainGoesOnCounting) {
  RecordingFile file(files_.path("twice.ebrec"), {});
  FrameWriter writer(file, FrameCodec::Lossless);
  for (const int i : {0, 1, 3}) writer.add(numbered(i), numbered(i).time);
  Frame again = numbered(9, 4, 4);
  again.sequence = 0;
  writer.add(again, numbered(9).time);
  file.commit();
  open(files_.path("twice.ebrec"));
  std::vector<std::uint64_t> sequences;
  for (int i = 0; i < 4; ++i) {
    next();
    sequences.push_back(last_->sequence);
  }
  EXPECT_THAT(sequences, ElementsAre(0, 1, 3, 4));
}

TEST_F(Frames, PicturesAreFittedToTheSizeThatIsAskedFor) {
  open(files_.folder(2));
  EXPECT_EQ(source_->natural_size(), (Size{8, 6}));
  ASSERT_TRUE(source_->set_size(4, 4));
  EXPECT_EQ(next(), 0);
  EXPECT_EQ(last_->width, 4);
  EXPECT_EQ(last_->height, 4);
  EXPECT_EQ(source_->natural_size(), (Size{8, 6}));
}

TEST_F(Frames, ADamagedPictureIsAnErrorThatNamesItAndTheNextOneComes) {
  const std::string folder = files_.folder(3);
  std::filesystem::resize_file(folder + "/frame 1.png", 60);  // its header is whole
  open(folder);
  EXPECT_EQ(next(), 0);
  EXPECT_EQ(next(), -1);
  EXPECT_EQ(error_.code, Errc::Corrupt);
  EXPECT_THAT(error_.what, HasSubstr("frame 1.png"));
  EXPECT_EQ(next(), 2);
}

TEST_F(Frames, APictureOfAnotherSizeFailsAtItsTurn) {
  const std::string folder = files_.folder(2);
  files_.put(7, "pictures/frame 0b.png", 16, 12);
  open(folder);
  EXPECT_EQ(next(), 0);
  EXPECT_EQ(next(), -1);
  EXPECT_THAT(error_.what, HasSubstr("frame 0b.png has 16 x 12 pixels, expected 8 x 6"));
  EXPECT_EQ(next(), 1);
}

TEST_F(Frames, WhatIsNoPictureFailsAtItsTurnAndHiddenFilesAreLeftOut) {
  const std::string folder = files_.folder(1);
  std::ofstream(folder + "/a.jpg") << "text";  // before the others
  std::ofstream(folder + "/._frame 0.png") << "of another system";
  open(folder);
  EXPECT_EQ(next(), -1);
  EXPECT_THAT(error_.what, HasSubstr("a.jpg: cannot read picture: no picture"));
  EXPECT_EQ(next(), 0);
  std::filesystem::remove(folder + "/frame 0.png");
  EXPECT_THAT(complaint(folder), HasSubstr("a.jpg: cannot read picture: no picture"));
}

TEST_F(Frames, WhatCannotBeACameraIsRefusedBeforeTheRun) {
  std::filesystem::create_directory(files_.path("empty"));
  EXPECT_THAT(early_complaint(""), HasSubstr("found no path, expected frames:PATH"));
  EXPECT_THAT(early_complaint("/no/such"), HasSubstr("found nothing at /no/such"));
  EXPECT_THAT(early_complaint(files_.path("empty")), HasSubstr("found no pictures in this folder"));
  const std::string folder = files_.folder(1);
  EXPECT_EQ(early_complaint(folder), "");
  EXPECT_THAT(early_complaint(folder + "?end=stop"), HasSubstr("expected one of: loop, hold, end"));
  EXPECT_THAT(early_complaint(folder + "?pick=all"), HasSubstr("expected one of: newest, each"));
  for (const char* rate : {"0", "-3", "fast", "30x", "1e9", "nan", ""}) {
    EXPECT_THAT(early_complaint(folder + "?fps=" + rate), HasSubstr("expected 0.01 ... 1000"))
        << rate;
  }
  EXPECT_THAT(early_complaint(folder + "?speed=2"),
              HasSubstr("'speed', expected end, fps or pick"));
  EXPECT_THAT(early_complaint(files_.recording(1) + "?fps=5"), HasSubstr("has times of its own"));
}

TEST_F(Frames, ARecordingWithoutFramesIsRefused) {
  EXPECT_THAT(complaint(files_.recording(0)), HasSubstr("found a recording without frames"));
}

TEST_F(Frames, WhatIsNoRecordingIsRefused) {
  std::ofstream(files_.path("text.ebrec")) << "text";
  EXPECT_THAT(complaint(files_.path("text.ebrec")), HasSubstr("expected a recording (.ebrec)"));
}

TEST(NaturalOrder, ComparesNumbersAsNumbers) {
  EXPECT_TRUE(natural_less("frame2.png", "frame10.png"));
  EXPECT_FALSE(natural_less("frame10.png", "frame2.png"));
  EXPECT_TRUE(natural_less("a9b2", "a10b1"));
  EXPECT_TRUE(natural_less("A1", "b1"));
  EXPECT_TRUE(natural_less("a", "a1"));
  EXPECT_TRUE(natural_less("99999999999999999999", "100000000000000000000"));
  EXPECT_NE(natural_less("01", "1"), natural_less("1", "01")) << "an order, also of equal numbers";
  EXPECT_FALSE(natural_less("a1", "a1"));
}

}  // namespace
}  // namespace eyebridge::camera::testing
