#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/camera/frame.hpp"
#include "eyebridge/hal/trace.hpp"
#include "eyebridge/world/scene.hpp"
#include "trace_file.hpp"

namespace eyebridge::robios {

/// What `--out DIR` gets: trace.csv and collisions.csv while the program runs; the trail on the
/// map, the last LCD and the camera's frames as PNG; the LCD's text. Any thread.
class RunOutput final : public hal::TraceSink {
 public:
  /// Makes `directory`, which is this run's alone meanwhile. Throws ConfigError, without a place,
  /// when it cannot be written or another run writes there.
  RunOutput(std::filesystem::path directory, long long frames_to_keep);
  ~RunOutput() override;

  void point(const hal::TracePoint& point) noexcept override;
  [[nodiscard]] bool is_due(Time time) const noexcept override;
  void contact(const hal::TraceContact& contact) noexcept override;
  /// Keeps the first frames as frames/0000.png … One that cannot be written fails finish(), not the
  /// program.
  void frame(const camera::Frame& frame);
  /// Around fork(): the child must not write what the parent has in hand.
  void before_fork();
  void after_fork();
  /// Writes map.png, lcd.png and `lcd_text` as lcd.txt. Throws std::runtime_error naming the first
  /// file, of the whole run, that could not be written, after trying all others.
  void finish(const world::Scene* scene, const camera::Frame& lcd, const std::string& lcd_text);

 private:
  /// Writes a PNG and remembers why not.
  void write(const camera::Frame& frame, const std::filesystem::path& path);
  void note_failure(const std::string& failure);

  std::filesystem::path directory_;
  mutable std::mutex mutex_;
  UniqueFd lock_;  ///< Of the folder.
  long long frames_left_;
  int frames_taken_ = 0;
  TraceFile trace_;
  CollisionFile collisions_;
  std::vector<Vec2> trail_;
  std::string failure_;  ///< "" while everything could be written.
};

}  // namespace eyebridge::robios
