#include "environment/film.hpp"

#include <QPainter>
#include <cstring>

namespace eyebridge::gui {
namespace {

// A world that is much faster than this window, or jumps, does not hold it up.
constexpr int kMostAtOnce = 5;

camera::Size even(const QImage& picture) { return {picture.width() & ~1, picture.height() & ~1}; }

camera::Frame frame_of(const QImage& picture, camera::Size size) {
  QImage canvas(size.width, size.height, QImage::Format_RGB888);
  canvas.fill(Qt::black);
  {
    QPainter painter(&canvas);
    painter.drawImage((size.width - picture.width()) / 2, (size.height - picture.height()) / 2,
                      picture);
  }
  camera::Frame frame;
  frame.width = size.width;
  frame.height = size.height;
  frame.stride = 3 * size.width;
  frame.bytes.resize(static_cast<std::size_t>(frame.stride) *
                     static_cast<std::size_t>(size.height));
  for (int y = 0; y < size.height; ++y) {
    std::memcpy(frame.bytes.data() + static_cast<std::size_t>(y * frame.stride), canvas.scanLine(y),
                static_cast<std::size_t>(frame.stride));
  }
  return frame;
}

}  // namespace

Film::Film(const QString& path, const QImage& first, double time)
    : video_(camera::make_video(path.toStdString(), even(first), kRate)),
      size_(even(first)),
      start_(time),
      next_(time) {
  add(first, time);
}

void Film::add(const QImage& picture, double time) {
  if (!is_due(time)) return;
  const camera::Frame frame = frame_of(picture, size_);
  for (int i = 0; i < kMostAtOnce && is_due(time); ++i) {
    video_->add(frame);
    next_ = start_ + ++count_ / kRate;
  }
  if (is_due(time)) {  // the film goes on from there
    start_ = time - (count_ - 1) / kRate;
    next_ = start_ + count_ / kRate;
  }
}

}  // namespace eyebridge::gui
