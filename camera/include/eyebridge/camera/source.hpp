#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/camera/frame.hpp"
#include "eyebridge/camera/view.hpp"

namespace eyebridge::camera {

/// Where frames come from. One thread at a time.
class Source {
 public:
  virtual ~Source() = default;

  /// Asks for frames of `width` x `height` pixels from now on. Fails with Unsupported or
  /// OutOfRange.
  virtual Result<void> set_size(int width, int height) = 0;

  /// The size that costs nothing: a live camera's own, a recording's; the one asked for where
  /// pictures are made to measure.
  [[nodiscard]] virtual Size natural_size() const = 0;

  /// The next frame that has not been given out yet; waits for it, at most until `deadline` on the
  /// robot's clock. Where frames come by themselves (a live camera, files) it is the newest that is
  /// there; pictures of a simulated world are made when the next one is due. Fails with Timeout,
  /// Disconnected, or Corrupt (this one is damaged, the next may not be); an old frame is never
  /// given twice.
  virtual Result<FramePtr> next(Time deadline) = 0;
};

/// What a source may need; pointers are lent for the source's life.
struct SourceContext {
  Clock* clock = nullptr;  ///< Never null.
  View* view = nullptr;    ///< Null when the backend has nothing to render.
  LogSink* log = nullptr;  ///< For warnings; null writes them to standard error.
};

/// One row of the table of sources.
struct SourceFactory {
  std::string_view scheme;   ///< "render", "pattern"
  std::string_view summary;  ///< One line for `eyebridge doctor` and error messages.
  /// Throws ConfigError when `open` could only fail; opens nothing, loads nothing.
  void (*check)(std::string_view rest, const SourceContext& context);
  std::unique_ptr<Source> (*open)(std::string_view rest, const SourceContext& context);
};

/// All sources, in order of preference.
std::span<const SourceFactory> source_table();

/// Throws what open_source() would throw for a bad `url`, without opening anything: at the start of
/// a run, long before the program asks for a frame. A library that is missing shows only on
/// opening.
void check_source(const std::string& url, const SourceContext& context);

/// Opens `url`: "render", "render:egl?fiducials=on&light=0.4", "pattern", … Throws
/// ConfigError{"--camera"} for an unknown scheme (naming the known ones) or a source that cannot
/// work here. With "?calibration=FILE" any source gives straightened pictures: those of a pinhole
/// with the same focal length; set_size() fails with Unsupported where the camera's pictures get
/// another aspect than the calibration's. With "?errors=harsh" or "?errors=sigma=4,blur=1" (what
/// follows `camera` in docs/errors.md) its frames get a camera's errors; "error_seed=N" gives other
/// ones, what one frame suffers follows from that and its sequence. With "?rotate=90" (180, 270:
/// clockwise) and "?flip=h" or "v" (after it) pictures of any source are turned, before all else: a
/// calibration is of turned ones.
std::unique_ptr<Source> open_source(const std::string& url, const SourceContext& context);

}  // namespace eyebridge::camera
