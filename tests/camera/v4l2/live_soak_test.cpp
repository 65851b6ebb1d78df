// Ten minutes of simulated time, or EYEBRIDGE_TEST_SOAK, with a camera that is unplugged again and
// again. Needs vivid, its modules and simulated time: the lab runs it.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "all_log.hpp"
#include "eyebridge/base/random.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"
#include "patience.hpp"
#include "process_memory.hpp"
#include "v4l2/controls.hpp"
#include "v4l2/v4l2_source.hpp"
#include "v4l2/video_handle.hpp"

namespace eyebridge::camera::testing {
namespace {

namespace fs = std::filesystem;

std::chrono::minutes soak() {
  const char* const minutes = std::getenv("EYEBRIDGE_TEST_SOAK");
  return std::chrono::minutes(minutes == nullptr ? 10 : std::atoi(minutes));
}

/// Runs a shell command of the guest's.
void shell(const std::string& command) { ASSERT_EQ(std::system(command.c_str()), 0) << command; }

/// Where the guest's modules are: on its kernel's command line.
std::string modules() {
  std::ifstream line("/proc/cmdline");
  for (std::string word; line >> word;) {
    if (word.starts_with("LAB_MODULES=")) return word.substr(word.find('=') + 1);
  }
  return "";
}

int open_files() {
  const fs::directory_iterator all("/proc/self/fd");
  return static_cast<int>(std::distance(begin(all), end(all)));
}

long resident_kilobytes() { return static_cast<long>(eyebridge::testing::resident_bytes() / 1024); }

class Soak : public ::testing::Test {
 protected:
  Soak()
      : source_(system_video_calls(), parse_camera_url("/dev/video0?size=320x180&fps=30"),
                {&clock_, nullptr, &log_}) {}

  /// The camera says that it is gone, and can be opened again at once.
  static void disconnect() {
    const VideoHandle other(system_video_calls(), "/dev/video0");
    ASSERT_EQ(other.error(), 0);
    set_controls(other, {{"disconnect", "1"}});
  }

  /// Takes a frame and checks that it is newer than all before it and than `since`.
  void take_frame(Time since) {
    const Result<FramePtr> frame = source_.next(clock_.now() + kPatience);
    ASSERT_TRUE(frame) << frame.error().what;
    ASSERT_GT((*frame)->time, last_time_);
    ASSERT_GE((*frame)->time, since);
    ASSERT_GT((*frame)->sequence + 1, next_);
    last_time_ = (*frame)->time;
    next_ = (*frame)->sequence + 1;
    ++frames_;
  }

  /// Unplugs it for `away`: the node goes, too. One call tells, all others until then time out.
  void unplug(Time away) {
    disconnect();
    const Result<FramePtr> lost = source_.next(clock_.now() + kPatience);
    ASSERT_FALSE(lost);
    ASSERT_EQ(lost.error().code, Errc::Disconnected);
    if (away > Time(0)) {
      shell("modprobe -d " + modules() + " -r vivid");
      const Result<FramePtr> still = source_.next(clock_.now() + away);
      ASSERT_FALSE(still);
      ASSERT_EQ(still.error().code, Errc::Timeout);
      shell("modprobe -d " + modules() +
            " vivid n_devs=1 node_types=0x1 num_inputs=1 input_types=0");
    }
    take_frame(clock_.now());
  }

  bridges::MonotonicClock clock_;
  AllLog log_;
  V4l2Source source_;
  Time last_time_{0};
  std::uint64_t next_ = 0;
  std::uint64_t frames_ = 0;
};

TEST_F(Soak, UnpluggingAgainAndAgainLeaksNothingAndGivesNoOldFrame) {
  ASSERT_NO_FATAL_FAILURE(take_frame(Time(0)));
  ASSERT_NO_FATAL_FAILURE(unplug(Time(0)));
  ASSERT_NO_FATAL_FAILURE(unplug(std::chrono::seconds(1)));  // all that is kept has been made
  const int files = open_files();
  const long memory = resident_kilobytes();
  std::uint64_t losses = 2;
  Random random(20);
  Time next_loss = clock_.now() + from_seconds(20.0 * random.uniform());
  while (clock_.now() < soak()) {
    if (clock_.now() < next_loss) {
      ASSERT_NO_FATAL_FAILURE(take_frame(Time(0)));
      continue;
    }
    const bool is_short = random.chance(0.7);
    ASSERT_NO_FATAL_FAILURE(unplug(is_short ? Time(0) : from_seconds(5.0 * random.uniform())));
    ++losses;
    next_loss = clock_.now() + from_seconds(40.0 * random.uniform());
  }
  EXPECT_GE(losses, 2U * static_cast<unsigned>(soak().count()));
  EXPECT_EQ(source_.counts().losses, losses);
  EXPECT_EQ(log_.warnings.size(), 2 * losses) << "one line when it goes, one when it is back";
  EXPECT_EQ(source_.counts().given, frames_);
  EXPECT_EQ(source_.counts().corrupt, 0U);
  EXPECT_EQ(open_files(), files);
  constexpr long kNoise_kB = 1024;
  EXPECT_LE(resident_kilobytes(), memory + kNoise_kB);
  std::printf("%lu frames, %lu losses, %ld kB more\n", static_cast<unsigned long>(frames_),
              static_cast<unsigned long>(losses), resident_kilobytes() - memory);
}

}  // namespace
}  // namespace eyebridge::camera::testing
