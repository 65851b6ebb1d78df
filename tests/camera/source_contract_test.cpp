#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/source.hpp"
#include "fake_clock.hpp"
#include "fake_view.hpp"
#include "frame_files.hpp"
#include "scenes.hpp"

namespace eyebridge::camera::testing {
namespace {

using namespace std::string_literals;

using ::testing::AllOf;
using ::testing::HasSubstr;
constexpr Time kLater{2'000'000'000};

struct SourceCase {
  const char* name;
  std::string (*url)(const FrameFiles& files);
  /// A program that was away gets the newest frame of that time; else frames are made when they are
  /// asked for.
  bool keeps_newest = false;
};
void PrintTo(const SourceCase& source, std::ostream* out) { *out << source.name; }

class SourceContract : public ::testing::TestWithParam<SourceCase> {
 protected:
  SourceContract() {
    view_.model = empty_room();
    source_ = open_source(GetParam().url(files_), {&clock_, &view_, &log_});
  }

  FramePtr next() {
    const Result<FramePtr> frame = source_->next(clock_.now() + kLater);
    EXPECT_TRUE(frame) << frame.error().what;
    return frame ? *frame : nullptr;
  }

  FrameFiles files_;
  FakeClock clock_;
  FakeView view_;
  RecordingLog log_;
  std::unique_ptr<Source> source_;
};

TEST_P(SourceContract, FramesComeOnceAndInOrder) {
  for (std::uint64_t i = 0; i < 40; ++i) {
    const FramePtr frame = next();
    ASSERT_NE(frame, nullptr);
    EXPECT_EQ(frame->sequence, i);
    EXPECT_EQ(frame->time, Time(static_cast<Time::rep>(i) * 1'000'000'000 / 30));
    EXPECT_EQ(clock_.now(), frame->time);
  }
}

TEST_P(SourceContract, ASlowProgramMissesFramesAndSeesTheGap) {
  EXPECT_EQ(next()->sequence, 0U);
  clock_.spend(Time(100'000'001));  // just past the time of frame 3
  const FramePtr frame = next();
  const bool keeps = GetParam().keeps_newest;
  EXPECT_EQ(frame->sequence, keeps ? 3U : 4U);
  EXPECT_EQ(frame->time, Time(keeps ? 100'000'000 : 133'333'333));
}

TEST_P(SourceContract, SequenceStartsAtZeroHoweverLateTheFirstFrameIs) {
  clock_.spend(Time(5'010'000'000));
  EXPECT_EQ(next()->sequence, 0U);
  EXPECT_EQ(next()->sequence, 1U);
}

TEST_P(SourceContract, AClockThatWakesLateSkipsWhatItMissed) {
  EXPECT_EQ(next()->sequence, 0U);
  clock_.lateness = Time(70'000'000);  // two frames
  const FramePtr frame = next();
  EXPECT_EQ(frame->sequence, 3U);
  EXPECT_LE(frame->time, clock_.now());
  clock_.lateness = Time(0);
  EXPECT_EQ(next()->sequence, 4U);
}

TEST_P(SourceContract, AFrameDueAfterTheDeadlineIsATimeoutAtTheDeadline) {
  ASSERT_NE(next(), nullptr);
  const Time deadline = clock_.now() + Time(33'000'000);
  const Result<FramePtr> frame = source_->next(deadline);
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, Errc::Timeout);
  EXPECT_EQ(clock_.now(), deadline);
  EXPECT_EQ(next()->sequence, 1U);  // and it is not lost
}

TEST_P(SourceContract, ADeadlineOfNowGivesAFrameOnlyWhenOneIsDueNow) {
  EXPECT_TRUE(source_->next(clock_.now()));
  EXPECT_FALSE(source_->next(clock_.now()));
}

TEST_P(SourceContract, SizeCanChangeBetweenFrames) {
  for (const auto& [width, height] : {std::pair{160, 120}, {640, 480}, {320, 240}, {33, 17}}) {
    ASSERT_TRUE(source_->set_size(width, height));
    const FramePtr frame = next();
    EXPECT_EQ(frame->width, width);
    EXPECT_EQ(frame->height, height);
    EXPECT_EQ(frame->format, PixelFormat::Rgb24);
    EXPECT_GE(frame->stride, 3 * width);
    EXPECT_GE(frame->bytes.size(), static_cast<std::size_t>(frame->stride * height));
  }
}

TEST_P(SourceContract, ASizeThatCannotBeIsRefusedAndTheOldOneStays) {
  ASSERT_TRUE(source_->set_size(160, 120));
  for (const auto& [width, height] : {std::pair{0, 120}, {160, -1}, {5000, 120}, {160, 1 << 30}}) {
    const Result<void> result = source_->set_size(width, height);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Errc::OutOfRange);
  }
  EXPECT_EQ(next()->width, 160);
}

TEST_P(SourceContract, AFrameOutlivesItsSource) {
  const FramePtr frame = next();
  const std::vector<std::uint8_t> bytes = frame->bytes;
  ASSERT_NE(next(), nullptr);
  source_.reset();
  EXPECT_EQ(frame->bytes, bytes);
}

INSTANTIATE_TEST_SUITE_P(
    AllSources, SourceContract,
    ::testing::Values(
        SourceCase{"Render", [](const FrameFiles&) { return "render"s; }},
        SourceCase{"RenderEgl", [](const FrameFiles&) { return "render:egl"s; }},
        SourceCase{"Pattern", [](const FrameFiles&) { return "pattern"s; }},
        SourceCase{
            "Folder",
            [](const FrameFiles& files) { return "frames:" + files.folder(60) + "?end=loop"; },
            true},
        SourceCase{"Recording",
                   [](const FrameFiles& files) { return "frames:" + files.recording(200); }, true}),
    [](const auto& test) { return std::string(test.param.name); });

std::string error_of(const std::string& url, View* view) {
  FakeClock clock;
  RecordingLog log;
  try {
    open_source(url, {&clock, view, &log});
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.where().file, "--camera");
    return error.text();
  }
  return "";
}

TEST(OpenSource, AnUnknownSchemeIsAnErrorThatNamesTheKnownOnes) {
  FakeView view;
  const std::string text = error_of("webcam:3", &view);
  EXPECT_THAT(text, HasSubstr("webcam:3"));
  for (const SourceFactory& factory : source_table()) {
    EXPECT_THAT(text, HasSubstr(std::string(factory.scheme)));
  }
  EXPECT_NE(error_of("", &view), "");
}

TEST(OpenSource, RenderWithoutAWorldIsAnError) {
  EXPECT_THAT(error_of("render", nullptr), HasSubstr("simulated"));
}

TEST(OpenSource, AnUnknownOpenGlMakerIsAnErrorThatNamesTheKnownOnes) {
  FakeView view;
  const std::string text = error_of("render:vulkan", &view);
  EXPECT_THAT(text, HasSubstr("vulkan"));
  for (const GlContextMaker& maker : gl_context_makers()) {
    EXPECT_THAT(text, HasSubstr(std::string(maker.name)));
  }
}

TEST(OpenSource, RenderTakesItsOptionsAfterTheMakerOrAtOnce) {
  FakeView view;
  view.model = empty_room();
  for (const char* url : {"render?light=0.5", "render:?light=0.5", "render:egl?light=0.5"}) {
    EXPECT_EQ(error_of(url, &view), "") << url;
  }
  EXPECT_THAT(error_of("render:?brightness=2", &view),
              AllOf(HasSubstr("brightness"), HasSubstr("light")));
  EXPECT_THAT(error_of("render:vulkan?light=1", &view), HasSubstr("vulkan"));
  for (const char* light : {"", "0", "-1", "4.1", "1x", "nan"}) {
    EXPECT_THAT(error_of("render:?light=" + std::string(light), &view), HasSubstr("0.01 ... 4"));
  }
}

TEST(OpenSource, PatternNeedsNoWorldAndTakesNoArgument) {
  EXPECT_EQ(error_of("pattern", nullptr), "");
  EXPECT_THAT(error_of("pattern:blue", nullptr), HasSubstr("blue"));
}

TEST(Pattern, EachFrameShowsItsNumber) {
  FakeClock clock;
  const auto source = open_source("pattern", {&clock, nullptr, nullptr});
  for (int i = 0; i < 20; ++i) {
    const FramePtr frame = *source->next(kLater);
    const auto row = frame->row(200);  // between 3/4 and 7/8 of the height
    int number = 0;
    for (std::size_t digit = 0; digit < 16; ++digit) {
      number = 2 * number + (row[3 * (20 * digit + 10)] > 128 ? 1 : 0);
    }
    EXPECT_EQ(number, i);
  }
}

TEST(Render, LightScalesAllColours) {
  const auto frame = [](const char* url) {
    FakeClock clock;
    FakeView view;
    view.model = *maze_scene(5, 3).model;
    view.bodies = maze_scene(5, 3).bodies;
    view.eye_ = {0.15, 0.45, 0.12, 0.0, 0.0, 1.0};
    return *open_source(url, {&clock, &view, nullptr})->next(kLater);
  };
  const FramePtr usual = frame("render");
  const FramePtr dim = frame("render:?light=0.4");
  for (std::size_t i = 0; i < usual->bytes.size(); ++i) {
    ASSERT_NEAR(dim->bytes[i], 0.4 * usual->bytes[i], 1.0) << i;
  }
}

TEST(Render, NoiseDiffersFromFrameToFrameButNotFromRunToRun) {
  const auto frames = [](double salt, double sigma) {
    FakeClock clock;
    FakeView view;
    view.model = empty_room();
    view.noise_ = {{salt, sigma}, 42};
    const auto source = open_source("render", {&clock, &view, nullptr});
    return std::pair{*source->next(kLater), *source->next(kLater)};
  };
  const auto clean = frames(0.0, 0.0);
  const auto noisy = frames(0.1, 5.0);
  EXPECT_EQ(clean.first->bytes, clean.second->bytes);
  EXPECT_NE(noisy.first->bytes, noisy.second->bytes);
  EXPECT_NE(noisy.first->bytes, clean.first->bytes);
  EXPECT_EQ(noisy.first->bytes, frames(0.1, 5.0).first->bytes);
}

TEST(Render, SnowDoesNotRepeatForASourceThatIsOpenedAgain) {
  FakeClock clock;
  FakeView view;
  view.model = empty_room();
  view.noise_ = {{0.1, 5.0}, 42};
  const auto first_frame = [&] {
    return *open_source("render", {&clock, &view, nullptr})->next(clock.now() + kLater);
  };
  const FramePtr first = first_frame();
  clock.spend(Time(1'000'000'000));
  const FramePtr second = first_frame();
  EXPECT_EQ(first->sequence, second->sequence);
  EXPECT_NE(first->bytes, second->bytes);
}

}  // namespace
}  // namespace eyebridge::camera::testing
