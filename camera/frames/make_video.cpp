#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/camera/video_writer.hpp"
#include "sources/own_library.hpp"

namespace eyebridge::camera {
namespace {

const char* codec_of(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".mp4") return "mp4v";
  if (ending == ".avi") return "MJPG";
  throw ConfigError({file.string()},
                    "found the ending " + in_quotes(ending) + ", expected a video's: .mp4 or .avi");
}

/// OpenCV says only that it did not work. What is there stays as it is.
void check_place(const std::filesystem::path& file) {
  std::FILE* const out = std::fopen(file.c_str(), "ab");
  if (out == nullptr) {
    throw ConfigError({file.string()}, std::string("cannot be written: ") + std::strerror(errno));
  }
  std::fclose(out);
}

}  // namespace

std::unique_ptr<VideoWriter> make_video(const std::filesystem::path& file, Size size, double rate) {
  const char* const codec = codec_of(file);
  const auto make = reinterpret_cast<MakeVideo>(
      own_library_entry("libeyebridge_video.so", "eyebridge_make_video"));
  check_place(file);
  try {
    return std::unique_ptr<VideoWriter>(make(file.c_str(), codec, size, rate));
  } catch (const ConfigError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw ConfigError({file.string()}, error.what());
  }
}

}  // namespace eyebridge::camera
