#include <algorithm>
#include <stdexcept>

#include "eyebridge/base/config_error.hpp"
#include "frames/frame_series.hpp"
#include "frames/video_reader.hpp"
#include "sources/frame_schedule.hpp"
#include "sources/own_library.hpp"

namespace eyebridge::camera {
namespace {

/// Counts of containers without an index are estimates.
constexpr std::int64_t kFewMissing = 2;
constexpr double kHighestVideoRate = 1000.0;

/// A reader gives one frame at a time; to know when the next is due it must be grabbed, and what
/// was there before is kept as a picture until then.
class VideoSeries final : public FrameSeries {
 public:
  VideoSeries(std::unique_ptr<VideoReader> reader, std::filesystem::path file)
      : reader_(std::move(reader)), file_(std::move(file)) {
    const double rate = reader_->rate();
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
      here_.reset();  // damage() tells of it
    }
  }
  [[nodiscard]] std::optional<Error> damage() const override {
    if (count_ > 0 && count_ + kFewMissing >= reader_->count()) return std::nullopt;
    return Error{Errc::Corrupt, "camera: " + file_.string() + " ends after " +
                                    std::to_string(count_) + " of " +
                                    std::to_string(reader_->count()) + " frames: cut or damaged"};
  }

 private:
  std::optional<SeriesEntry> grab() {
    const std::optional<Time> time = reader_->grab();
    if (!time) return std::nullopt;
    if (count_ == 0) first_ = *time;
    Time due = *time - first_;
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

std::unique_ptr<FrameSeries> open_video_series(const std::filesystem::path& file) {
  const auto open = reinterpret_cast<OpenVideo>(
      own_library_entry("libeyebridge_video.so", "eyebridge_open_video"));
  try {
    return std::make_unique<VideoSeries>(std::unique_ptr<VideoReader>(open(file.c_str())), file);
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
