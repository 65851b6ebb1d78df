// One camera for two: the thread of a real one is tested with the robot that a person carries.
#include "eyebridge/camera/shared_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fake_clock.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::ElementsAre;

class Watcher final : public FrameWatcher {
 public:
  void frame(const FramePtr& frame) override {
    sequences.push_back(frame->sequence);
    times.push_back(frame->time);
    width = frame->width;
  }
  void no_frame(const Error& why) override { last_error = why.what; }

  std::vector<std::uint64_t> sequences;
  std::vector<Time> times;
  std::string last_error;
  int width = 0;
};

/// A camera that breaks when it is told to.
class Breakable final : public Source {
 public:
  Breakable(Clock& clock, bool& broken)
      : inner_(open_source("pattern", {&clock, nullptr, nullptr})), broken_(broken) {}
  Result<void> set_size(int width, int height) override { return inner_->set_size(width, height); }
  [[nodiscard]] Size natural_size() const override { return inner_->natural_size(); }
  Result<FramePtr> next(Time deadline) override {
    if (broken_) return fail(Errc::Disconnected, "camera: unplugged");
    return inner_->next(deadline);
  }

 private:
  std::unique_ptr<Source> inner_;
  bool& broken_;
};

struct Shared {
  FakeClock clock;
  Watcher watcher;
  bool broken = false;
  SharedSource source{std::make_unique<Breakable>(clock, broken), clock, watcher};
};

constexpr Time ms(int count) { return std::chrono::milliseconds(count); }

TEST(SharedSource, TheWatcherIsShownEveryFrameAtItsTimeWithoutAProgramThatAsks) {
  Shared shared;
  shared.source.pull(ms(100));
  EXPECT_THAT(shared.watcher.sequences, ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(shared.watcher.times[2], Time(66'666'666));
  EXPECT_EQ(shared.clock.now(), ms(100));
  shared.source.pull(ms(120));
  EXPECT_EQ(shared.watcher.sequences.size(), 4U);
  EXPECT_EQ(shared.clock.now(), ms(120));
}

TEST(SharedSource, TheProgramGetsTheNewestOnce) {
  Shared shared;
  shared.source.pull(ms(90));
  const auto frame = shared.source.next(ms(90));
  ASSERT_TRUE(frame);
  EXPECT_EQ((*frame)->time, Time(66'666'666));
  EXPECT_EQ((*frame)->sequence, 0U) << "the first that it was given";
  const auto again = shared.source.next(ms(95));
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, Errc::Timeout);
  EXPECT_EQ(shared.clock.now(), ms(95));
  const auto next = shared.source.next(ms(200));
  ASSERT_TRUE(next);
  EXPECT_EQ((*next)->sequence, 1U);
  EXPECT_EQ(shared.clock.now(), ms(100));
  EXPECT_EQ(shared.watcher.sequences.size(), 4U) << "the watcher got it, too";
}

TEST(SharedSource, TheProgramsSizeIsItsOwn) {
  Shared shared;
  ASSERT_TRUE(shared.source.set_size(160, 120));
  const auto frame = shared.source.next(ms(50));
  ASSERT_TRUE(frame);
  EXPECT_EQ((*frame)->width, 160);
  EXPECT_EQ((*frame)->height, 120);
  EXPECT_EQ(shared.watcher.width, 320);
  EXPECT_EQ(shared.source.natural_size(), (Size{320, 240}));
  EXPECT_EQ(shared.source.set_size(0, 120).error().code, Errc::OutOfRange);
}

TEST(SharedSource, ACameraThatIsGoneIsToldToBothUntilItIsBack) {
  Shared shared;
  shared.broken = true;
  shared.source.pull(ms(500));
  EXPECT_EQ(shared.clock.now(), ms(500));
  EXPECT_EQ(shared.watcher.last_error, "camera: unplugged");
  const auto frame = shared.source.next(ms(600));
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, Errc::Disconnected);
  shared.broken = false;
  shared.source.pull(ms(600));
  EXPECT_EQ(shared.watcher.sequences.size(), 4U);
  EXPECT_TRUE(shared.source.next(ms(600)));
}

}  // namespace
}  // namespace eyebridge::camera::testing
