#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "eyebridge/base/log.hpp"
#include "v4l2/camera_url.hpp"
#include "v4l2/capture_stream.hpp"
#include "v4l2/nodes.hpp"
#include "v4l2/video_calls.hpp"

namespace eyebridge::camera {

/// Opens one camera, and the same one again after it was unplugged.
class CameraOpener {
 public:
  /// `calls` and `log` outlive it; devices are looked for below `root`.
  CameraOpener(VideoCalls& calls, CameraUrl wanted, std::filesystem::path root, LogSink& log);

  /// Opens the camera and starts it. Throws ConfigError: one message for each way to fail.
  std::unique_ptr<CaptureStream> open();
  /// The same camera, by its lasting name and its card, in the mode it had. Throws likewise.
  std::unique_ptr<CaptureStream> open_again();

  /// What the camera is called in messages: its lasting name.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  [[nodiscard]] std::string first_camera() const;
  [[nodiscard]] std::string on_disk(const std::string& path) const;
  void check(const VideoHandle& handle, const Identity& identity) const;
  std::unique_ptr<CaptureStream> start(VideoHandle handle, const Mode& mode, bool rate_matters);

  VideoCalls& calls_;
  CameraUrl wanted_;
  std::filesystem::path root_;
  LogSink& log_;
  std::string name_;
  std::string card_;
  Mode mode_;
  bool converting_ = false;  ///< By libv4l.
};

}  // namespace eyebridge::camera
