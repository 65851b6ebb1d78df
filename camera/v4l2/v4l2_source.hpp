#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "eyebridge/camera/source.hpp"
#include "pixels/pixel_decoder.hpp"
#include "v4l2/camera_opener.hpp"

namespace eyebridge::camera {

/// Frames of a live camera: always the newest, each once.
///
/// next() fails, besides Timeout, with Corrupt for a frame that came damaged (the next one goes
/// on), and once with Disconnected when the camera is unplugged. From then on it looks for it twice
/// a second while it waits; frames go on when it is back, with a gap in their sequence. When a
/// camera stops sending, streaming is started again after a second (or ten frames, if that is
/// longer).
class V4l2Source final : public Source {
 public:
  /// What became of the frames so far.
  struct Counts {
    std::uint64_t given = 0;
    std::uint64_t dropped = 0;   ///< Taken by the camera but never asked for.
    std::uint64_t corrupt = 0;   ///< Came damaged.
    std::uint64_t odd = 0;       ///< JPEGs with something odd, whose rows were all there.
    std::uint64_t restarts = 0;  ///< By the watchdog, or after an error of the driver's.
    std::uint64_t losses = 0;    ///< Unplugged.
  };

  /// Opens the camera. Throws ConfigError. `calls` outlives the source.
  V4l2Source(VideoCalls& calls, CameraUrl wanted, const SourceContext& context,
             std::filesystem::path root = "/");
  ~V4l2Source() override;

  Result<void> set_size(int width, int height) override;
  [[nodiscard]] Size natural_size() const override { return mode_.size; }
  Result<FramePtr> next(Time deadline) override;

  [[nodiscard]] const Mode& mode() const { return mode_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  void look_again();
  Result<void> revive(const Error& error);
  Result<void> watch();
  tl::unexpected<Error> lose(const std::string& reason);
  void note(const Oddities& odd);
  Result<FramePtr> picture_of(const RawFrame& raw);
  std::uint64_t number_of(const RawFrame& raw);
  [[nodiscard]] Error timeout(Time deadline) const;
  void say(Severity severity, const std::string& text) const;

  VideoCalls& calls_;
  Clock& clock_;
  LogSink& log_;
  CameraOpener opener_;
  std::unique_ptr<CaptureStream> stream_;  ///< Null while it is unplugged.
  Mode mode_;
  Size size_;  ///< Of the frames given out.
  PixelDecoder decoder_;
  Counts counts_;

  std::uint64_t next_number_ = 0;    ///< The least that the next frame may have.
  bool is_first_ = true;             ///< Since streaming was started.
  std::uint32_t last_sequence_ = 0;  ///< The driver's.
  Time last_time_{0};                ///< Of the frames given out.
  Time last_sign_{0};                ///< Of life of the camera, CLOCK_MONOTONIC.
  Time last_restart_{0};
  Time last_look_{0};
  std::string trouble_;  ///< Why there are no frames now; "": they come.
};

}  // namespace eyebridge::camera
