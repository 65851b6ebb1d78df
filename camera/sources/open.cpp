#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/source.hpp"
#include "sources/erring_source.hpp"
#include "sources/sources.hpp"
#include "sources/turned_source.hpp"
#include "sources/undistorted_source.hpp"
#include "sources/url_option.hpp"

namespace eyebridge::camera {
namespace {

constexpr auto kSources = std::to_array<SourceFactory>({
    {"render", "pictures of the simulated world (render:osmesa, render:egl?fiducials=on&light=0.4)",
     &check_render_source, &open_render_source},
    {"frames", "a folder of pictures, a video or a recording: frames:PATH?end=loop|hold|end&fps=30",
     &check_frames_source, &open_frames_source},
    {"pattern", "colour bars with the frame's number, needs no world", &check_pattern_source,
     &open_pattern_source},
    {"v4l2", "a live camera (v4l2:/dev/video0?size=640x480&fps=30&format=YUYV)", &check_v4l2_source,
     &open_v4l2_source},
});

struct Found {
  const SourceFactory& factory;
  std::string_view rest;
};

/// The row that `url` names. `url` is lent for as long as the answer is used.
Found find_source(std::string_view url) {
  const std::size_t end = std::min(url.find_first_of(":?"), url.size());
  const std::string_view scheme = url.substr(0, end);
  // Options may follow the scheme at once: "render?light=0.5".
  const std::string_view rest = url.substr(url.substr(end).starts_with(':') ? end + 1 : end);
  std::string known;
  for (const SourceFactory& factory : kSources) {
    if (factory.scheme == scheme) return {factory, rest};
    known += (known.empty() ? "" : ", ") + std::string(factory.scheme);
  }
  throw ConfigError({"--camera"}, "camera source \"" + std::string(url) +
                                      "\" is not known, expected one of: " + known);
}

/// `url` without the options that all sources have, and what these say.
struct CommonOptions {
  std::string url;
  std::optional<std::string> calibration;  ///< A file.
  std::optional<ImageNoise> noise;
  int orientation = 1;
};

CommonOptions take_common(const std::string& url) {
  const TakenOption calibration = take_option(url, "calibration", "calibration=FILE");
  const ErringUrl erring = take_errors(calibration.url);
  MountedUrl mounted = take_mounting(erring.url);
  return {std::move(mounted.url), calibration.value, erring.noise, mounted.orientation};
}

}  // namespace

std::span<const SourceFactory> source_table() { return kSources; }

void check_source(const std::string& url, const SourceContext& context) {
  const CommonOptions common = take_common(url);
  const Found found = find_source(common.url);
  found.factory.check(found.rest, context);
  if (common.calibration) read_calibration(*common.calibration);
}

std::unique_ptr<Source> open_source(const std::string& url, const SourceContext& context) {
  const CommonOptions common = take_common(url);
  const Found found = find_source(common.url);
  found.factory.check(found.rest, context);
  auto source = found.factory.open(found.rest, context);
  // First, so that all else, a calibration too, is of pictures as they are looked at.
  if (common.orientation != 1) source = turned(std::move(source), common.orientation);
  // The lens bends the light before the sensor errs; a calibration is of the pictures as they come.
  if (common.noise) source = with_errors(std::move(source), *common.noise);
  return common.calibration ? undistort(std::move(source), *common.calibration) : std::move(source);
}

}  // namespace eyebridge::camera
