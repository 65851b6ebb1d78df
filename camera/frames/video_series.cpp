#include <algorithm>
#include <stdexcept>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/read_file.hpp"
#include "frames/frame_series.hpp"
#include "frames/video_reader.hpp"
#include "sources/frame_schedule.hpp"
#include "sources/own_library.hpp"

namespace eyebridge::camera {
namespace {

constexpr double kHighestVideoRate = 1000.0;

/// A reader gives one frame at a time; to know when the next is due it must be grabbed, and what
/// was there before is kept as a picture until then.
class VideoSeries final : public FrameSeries {
 public:
  /// `own_rate`: of the file's own times; 0: it has them.
  VideoSeries(std::unique_ptr<VideoReader> reader, std::filesystem::path file, double own_rate)
      : reader_(std::move(reader)), file_(std::move(file)), is_even_(own_rate > 0.0) {
    const double rate = is_even_ ? own_rate : reader_->rate();
    period_ = from_seconds(rate > 0.0 ? 1.0 / std::min(rate, kHighestVideoRate)
                                      : 1.0 / FrameSchedule::kFramesPerSecond);
    here_ = grab();
    if (!here_) throw ConfigError({file_.string()}, "found no frame in this video");
  }

  [[nodiscard]] Size size() const override { return reader_->size(); }
  [[nodiscard]] Time period() const override { return period_; }
  [[nodiscard]] bool is_on_robots_clock() const override { return false; }

  std::optional<SeriesEntry> entry(int ahead) override {
    if (ahead == 0 || !here_) return here_;
    if (!looked_ahead_) {
      picture_ = retrieve();
      next_ = grab();
      looked_ahead_ = true;
    }
    return next_;
  }
  Result<Frame> picture() override { return looked_ahead_ ? picture_ : retrieve(); }
  void advance() override {
    here_ = looked_ahead_ ? next_ : grab();
    looked_ahead_ = false;
  }
  void rewind() override {
    count_ = 0;
    last_.reset();
    looked_ahead_ = false;
    try {
      reader_->rewind();
      here_ = grab();
    } catch (const std::runtime_error&) {
      here_.reset();
    }
  }

 private:
  std::optional<SeriesEntry> grab() {
    const std::optional<Time> time = reader_->grab();
    if (!time) return std::nullopt;
    if (count_ == 0) first_ = *time;
    Time due = is_even_ ? count_ * period_ : *time - first_;
    // Files without times of frames give none, or the same ones again.
    if (last_ && due <= *last_) due = *last_ + period_;
    last_ = due;
    return SeriesEntry{due, due, static_cast<std::uint64_t>(count_++)};
  }
  Result<Frame> retrieve() {
    try {
      return reader_->retrieve();
    } catch (const std::runtime_error& error) {
      return fail(Errc::Corrupt, "camera: " + file_.string() + ": frame " +
                                     std::to_string(here_->number) + ": " + error.what());
    }
  }

  std::unique_ptr<VideoReader> reader_;
  std::filesystem::path file_;
  bool is_even_;  ///< Its frames come at a rate, not at times of theirs.
  Time period_{0};
  Time first_{0};
  std::optional<Time> last_;
  std::int64_t count_ = 0;  ///< Grabbed since the start.
  std::optional<SeriesEntry> here_;
  bool looked_ahead_ = false;  ///< next_ and picture_ are known.
  std::optional<SeriesEntry> next_;
  Result<Frame> picture_;
};

}  // namespace

bool has_no_times(const std::filesystem::path& file) {
  const std::string beginning = first_bytes(file, 4);
  using namespace std::string_view_literals;
  return beginning.starts_with("\xFF\xD8\xFF"sv) || beginning == "\0\0\0\1"sv;
}

std::unique_ptr<FrameSeries> open_video_series(const std::filesystem::path& file, double rate) {
  constexpr double kUsualRate = 25.0;  // of such files, as FFmpeg has it
  const double own_rate = rate > 0.0 ? rate : has_no_times(file) ? kUsualRate : 0.0;
  const auto open = reinterpret_cast<OpenVideo>(
      own_library_entry("libeyebridge_video.so", "eyebridge_open_video"));
  try {
    return std::make_unique<VideoSeries>(std::unique_ptr<VideoReader>(open(file.c_str())), file,
                                         own_rate);
  } catch (const ConfigError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw ConfigError({file.string()},
                      "found " + std::string(error.what()) +
                          ", expected a video, a recording (.ebrec) or a folder of "
                          "pictures");
  }
}

}  // namespace eyebridge::camera
