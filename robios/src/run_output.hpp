#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/camera/frame.hpp"
#include "eyebridge/hal/trace.hpp"
#include "eyebridge/world/scene.hpp"

namespace eyebridge::robios {

/// What `--out DIR` gets: trace.csv while the program runs; the trail on the map, the last LCD and
/// the camera's frames as PNG. Any thread.
class RunOutput final : public hal::TraceSink {
 public:
  /// Makes `directory`. Throws ConfigError{"--out"} when it cannot be written.
  RunOutput(std::filesystem::path directory, long long frames_to_keep);
  ~RunOutput() override;

  /// One row of trace.csv every 50 ms of the robot's time. The first row that cannot be written is
  /// the last: finish() tells why.
  void point(const hal::TracePoint& point) noexcept override;
  /// Keeps the first frames as frames/0000.png …
  void frame(const camera::Frame& frame);
  /// Around fork(): the child must not write what the parent has in hand.
  void before_fork();
  void after_fork();
  /// Writes map.png and lcd.png. Throws std::runtime_error.
  void finish(const world::Scene* scene, const camera::Frame& lcd);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void add(const hal::TracePoint& point);

  std::filesystem::path directory_;
  long long frames_left_;
  int frames_written_ = 0;
  std::mutex mutex_;
  std::unique_ptr<std::FILE, Close> trace_;
  Time next_row_{0};
  std::vector<Vec2> trail_;
  std::string trace_failure_;  ///< Empty: none so far.
};

}  // namespace eyebridge::robios
