#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "all_log.hpp"
#include "eyebridge/base/config_error.hpp"
#include "fake_video.hpp"
#include "v4l2/v4l2_source.hpp"

namespace eyebridge::camera::testing {

/// Made-up cameras and the sources on them.
struct Rig {
  /// Opens "v4l2:" and `url`, as the row of the table would.
  std::unique_ptr<V4l2Source> open(const std::string& url) {
    return std::make_unique<V4l2Source>(video, parse_camera_url(url),
                                        SourceContext{&video, nullptr, &log}, video.root());
  }
  /// The text of the error with which opening fails; "" when it does not.
  std::string error_of(const std::string& url) {
    try {
      open(url);
    } catch (const ConfigError& error) {
      return error.where().file == "--camera" ? error.text() : "at " + error.where().file;
    }
    return "";
  }

  FakeVideo video;
  AllLog log;
};

}  // namespace eyebridge::camera::testing
