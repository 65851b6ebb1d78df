#include "v4l2/camera_url.hpp"

#include <charconv>
#include <cmath>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/url.hpp"
#include "sources/frame_schedule.hpp"
#include "v4l2/raw_formats.hpp"

namespace eyebridge::camera {
namespace {

const SourceLocation kFlag{"--camera"};

[[noreturn]] void refuse(std::string_view option, const std::string& value, const char* expected) {
  throw ConfigError(kFlag, "v4l2: found " + std::string(option) + "=" + in_quotes(value) +
                               ", expected " + expected);
}

template <class Number>
bool parse_whole(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

Size parse_size(const std::string& value) {
  const std::size_t x = value.find('x');
  Size size;
  const std::string_view text = value;
  const bool good = x != std::string::npos && parse_whole(text.substr(0, x), size.width) &&
                    parse_whole(text.substr(x + 1), size.height) &&
                    FrameSchedule::check_size(size.width, size.height);
  if (!good) refuse("size", value, "WIDTHxHEIGHT in pixels, each 1 ... 4096, such as 640x480");
  return size;
}

double parse_rate(const std::string& value) {
  constexpr double kFastest = 1000.0;
  double rate = 0.0;
  if (!parse_whole(std::string_view(value), rate) || !(rate > 0.0 && rate <= kFastest)) {
    refuse("fps", value, "frames a second, more than 0, at most 1000");
  }
  return rate;
}

}  // namespace

CameraUrl parse_camera_url(std::string_view rest) {
  Url url = parse_url("v4l2:" + std::string(rest), kFlag);
  CameraUrl out;
  out.device = std::move(url.rest);
  for (auto& [key, value] : url.options) {
    if (key == "size") {
      out.size = parse_size(value);
    } else if (key == "fps") {
      out.fps = parse_rate(value);
    } else if (key == "format") {
      if (!raw_format_named(value)) refuse("format", value, kRawFormatNames);
      out.format = value;
    } else {
      out.controls.emplace(key, std::move(value));
    }
  }
  return out;
}

}  // namespace eyebridge::camera
