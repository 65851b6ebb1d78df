#include "camera_input.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <CLI/CLI.hpp>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "stop_signals.hpp"

namespace eyebridge::apps {
namespace {

// A camera that gives no frame for this long is lost; a person's Ctrl-C is seen sooner.
constexpr Time kCameraPatience = std::chrono::seconds(2);
constexpr Time kLookAround = std::chrono::milliseconds(100);

bool has_scheme(std::string_view url, std::string_view scheme) {
  return url.substr(0, url.find_first_of(":?")) == scheme;
}

camera::Size parse_frame_size(const std::string& text) {
  camera::Size size;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  if (width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x') {
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    if (height.ec == std::errc{} && height.ptr == end) return size;
  }
  throw ConfigError({"--size"},
                    "found " + in_quotes(text) + ", expected WIDTHxHEIGHT in pixels: 640x480");
}

}  // namespace

void add_camera_options(CLI::App& command, CameraOptions& options) {
  command.add_option("--camera", options.url, "A camera's URL: v4l2:/dev/video0, frames:PATH, …")
      ->required()
      ->type_name("CAMERA");
  command.add_option("--size", options.size, "Size of the frames, pixels [the camera's own]")
      ->type_name("WIDTHxHEIGHT");
}

CameraInput::CameraInput(const CameraOptions& options) : url_(options.url) {
  if (has_scheme(url_, "render")) {
    throw ConfigError({"--camera"},
                      "found render, which needs a robot in a world; expected a camera that is its "
                      "own. eyebridge run --camera render --record FILE.ebrec PROGRAM keeps what a "
                      "program sees");
  }
  source_ = camera::open_source(url_, {&clock_, nullptr, nullptr});
  size_ = options.size.empty() ? source_->natural_size() : parse_frame_size(options.size);
  if (Result<void> sized = source_->set_size(size_.width, size_.height); !sized) {
    throw ConfigError({options.size.empty() ? "--camera" : "--size"}, sized.error().what);
  }
}

Result<camera::FramePtr> CameraInput::next() {
  const Time latest = clock_.now() + kCameraPatience;
  while (true) {
    Result<camera::FramePtr> frame = source_->next(std::min(latest, clock_.now() + kLookAround));
    if (stop_asked() && !frame) return camera::FramePtr();
    const bool may_come = !frame && frame.error().code == Errc::Timeout && clock_.now() < latest;
    if (!may_come) return frame;
  }
}

bool CameraInput::is_its_end(const Error& error) const {
  return error.code == Errc::Disconnected && has_scheme(url_, "frames");
}

}  // namespace eyebridge::apps
