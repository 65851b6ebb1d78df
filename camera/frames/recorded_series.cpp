#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/recording/frame_table.hpp"
#include "frames/frame_series.hpp"
#include "sources/frame_schedule.hpp"

namespace eyebridge::camera {
namespace {

constexpr Time kPeriod{1'000'000'000 / FrameSchedule::kFramesPerSecond};

class RecordedSeries final : public FrameSeries {
 public:
  explicit RecordedSeries(const std::filesystem::path& file) : reader_(file) {
    if (reader_.frames().empty()) {
      throw ConfigError({file.string()},
                        "found a recording without frames, expected one of eyebridge camera record,"
                        " or of a run with a camera and --record");
    }
    // A camera that the program opened again began to count again; here its numbers go on.
    std::uint64_t last = 0;
    for (const RecordedFrame& frame : reader_.frames()) {
      const bool goes_on = !numbers_.empty() && frame.sequence > last;
      const std::uint64_t step = goes_on ? frame.sequence - last : 1;
      numbers_.push_back(numbers_.empty() ? 0 : numbers_.back() + step);
      last = frame.sequence;
    }
  }

  [[nodiscard]] Size size() const override { return reader_.frames().front().size; }
  [[nodiscard]] Time period() const override { return kPeriod; }
  [[nodiscard]] bool is_on_robots_clock() const override { return true; }

  std::optional<SeriesEntry> entry(int ahead) override {
    const std::size_t index = at_ + static_cast<std::size_t>(ahead);
    if (index >= reader_.frames().size()) return std::nullopt;
    const RecordedFrame& frame = reader_.frames()[index];
    return SeriesEntry{frame.given, frame.taken, numbers_[index]};
  }
  Result<Frame> picture() override { return reader_.read(at_); }
  void advance() override { ++at_; }
  void rewind() override { at_ = 0; }

 private:
  FrameReader reader_;
  std::vector<std::uint64_t> numbers_;
  std::size_t at_ = 0;
};

}  // namespace

std::unique_ptr<FrameSeries> open_recorded_series(const std::filesystem::path& file) {
  return std::make_unique<RecordedSeries>(file);
}

}  // namespace eyebridge::camera
