#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "eyebridge/base/log.hpp"
#include "eyebridge/camera/recording/frame_codec.hpp"
#include "replay/ebrec.hpp"

namespace eyebridge::hal {

/// `inner`, every call of whose devices is written to a recording, and every frame that is handed
/// to its frame_sink(), packed as `frames` says; none: frames are not recorded. The world's
/// functions are not in it. When the disk fails the run goes on without, and one error is logged.
/// Throws ConfigError without a place when `path` cannot be written. `log` outlives the backend.
/// `origin` is written down as it is.
std::unique_ptr<Backend> with_recording(
    std::unique_ptr<Backend> inner, const std::filesystem::path& path, LogSink& log,
    const RecordingOrigin& origin = {},
    std::optional<camera::FrameCodec> frames = camera::FrameCodec::Lossless);

}  // namespace eyebridge::hal
