#pragma once

#include <memory>
#include <optional>
#include <string>

#include "eyebridge/camera/source.hpp"

namespace eyebridge::camera {

/// What the options "errors=…" and "error_seed=N" of a source's URL say, and the URL without them.
struct ErringUrl {
  std::string url;
  std::optional<ImageNoise> noise;  ///< None: "errors" is not given.
};

/// Throws ConfigError at "--camera".
ErringUrl take_errors(const std::string& url);

/// `inner` with the errors of `noise` in its frames, which become Rgb24. What a frame suffers
/// follows from the seed and its sequence: a recording errs the same way each time.
std::unique_ptr<Source> with_errors(std::unique_ptr<Source> inner, const ImageNoise& noise);

}  // namespace eyebridge::camera
