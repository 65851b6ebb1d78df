#pragma once

#include <QImage>
#include <QString>
#include <memory>

#include "eyebridge/camera/video_writer.hpp"

namespace eyebridge::gui {

/// A film of a view: 25 pictures for each second of the world, so that it shows a paused world for
/// no time. A world that is more than some times faster than real time is shown faster.
class Film {
 public:
  static constexpr double kRate = 25.0;

  /// `.mp4` or `.avi`, of pictures as big as `first`, which it begins with at the world's `time`,
  /// seconds. Throws ConfigError.
  Film(const QString& path, const QImage& first, double time);

  /// Whether a picture is due at `time`.
  [[nodiscard]] bool is_due(double time) const { return time >= next_; }
  /// Adds it as often as is due at `time`; one of another size is drawn in the middle of the
  /// film's.
  void add(const QImage& picture, double time);
  [[nodiscard]] int count() const { return count_; }

 private:
  std::unique_ptr<camera::VideoWriter> video_;
  camera::Size size_;
  double start_;
  double next_;
  int count_ = 0;
};

}  // namespace eyebridge::gui
