#pragma once

#include <memory>
#include <string>

#include "eyebridge/camera/source.hpp"

namespace eyebridge::camera {

/// What the options "rotate=90|180|270" (clockwise) and then "flip=h|v" of a source's URL say, as
/// Exif's orientation (upright()), and the URL without them.
struct MountedUrl {
  std::string url;
  int orientation = 1;
};

/// Throws ConfigError at "--camera".
MountedUrl take_mounting(const std::string& url);

/// `inner` with its pictures turned: for a camera that is mounted on its side or upside down, or
/// that sends what a mirror shows.
std::unique_ptr<Source> turned(std::unique_ptr<Source> inner, int orientation);

}  // namespace eyebridge::camera
