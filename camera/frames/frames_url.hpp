#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace eyebridge::camera {

/// What `frames:PATH?end=…&fps=…&pick=…` asks for.
struct FramesUrl {
  enum class Kind { Folder, Recording, Video };
  enum class End {
    Stop,  ///< No more frames: Disconnected.
    Hold,  ///< The last picture goes on, as a new frame in each period.
    Loop,  ///< From the first again; times and sequence go on.
  };
  enum class Pick {
    Newest,  ///< The newest frame that is due; older ones are skipped, as with a live camera.
    Each,    ///< Every frame, however late it is asked for.
  };

  std::filesystem::path path;
  Kind kind = Kind::Folder;
  End end = End::Stop;
  Pick pick = Pick::Newest;
  double rate = 0.0;  ///< Frames a second, of a folder or a video without times; else 0.
};

/// Reads what follows "frames:". Throws ConfigError: nothing is there, a folder has no pictures, an
/// option is unknown or does not fit.
FramesUrl parse_frames_url(std::string_view rest);

}  // namespace eyebridge::camera
