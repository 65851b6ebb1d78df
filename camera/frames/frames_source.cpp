#include <utility>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/convert.hpp"
#include "frames/frames_url.hpp"
#include "frames/series_player.hpp"
#include "sources/frame_schedule.hpp"
#include "sources/sources.hpp"

namespace eyebridge::camera {
namespace {

std::unique_ptr<FrameSeries> open_series(const FramesUrl& url) {
  switch (url.kind) {
    case FramesUrl::Kind::Folder:
      return open_folder_series(url.path, url.rate);
    case FramesUrl::Kind::Recording:
      return open_recorded_series(url.path);
    case FramesUrl::Kind::Video:
      break;
  }
  return open_video_series(url.path, url.rate);
}

class FramesSource final : public Source {
 public:
  FramesSource(const FramesUrl& url, Clock& clock)
      : clock_(clock), player_(open_series(url), url.end, url.pick, url.path.string()) {
    size_ = player_.size();
  }

  Result<void> set_size(int width, int height) override {
    return FrameSchedule::check_size(width, height).map([&] { size_ = {width, height}; });
  }

  [[nodiscard]] Size natural_size() const override { return player_.size(); }

  Result<FramePtr> next(Time deadline) override {
    return player_.next(clock_, deadline).map([&](Frame frame) -> FramePtr {
      if (frame.format != PixelFormat::Rgb24) frame = to_rgb24(frame);
      if (Size{frame.width, frame.height} != size_) frame = fit(frame, size_.width, size_.height);
      return std::make_shared<const Frame>(std::move(frame));
    });
  }

 private:
  Clock& clock_;
  SeriesPlayer player_;
  Size size_;
};

}  // namespace

void check_frames_source(std::string_view rest, const SourceContext&) {
  try {
    parse_frames_url(rest);
  } catch (const ConfigError& error) {
    // A folder has a place of its own in the message; what is wrong is still the flag.
    if (error.where().file == "--camera") throw;
    throw ConfigError({"--camera"}, error.what());
  }
}

std::unique_ptr<Source> open_frames_source(std::string_view rest, const SourceContext& context) {
  try {
    return std::make_unique<FramesSource>(parse_frames_url(rest), *context.clock);
  } catch (const ConfigError& error) {
    if (error.where().file == "--camera") throw;
    throw ConfigError({"--camera"}, error.what());
  }
}

}  // namespace eyebridge::camera
