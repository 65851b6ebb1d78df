#pragma once

#include <QImage>
#include <QWidget>

#include "eyebridge/camera/latest_frame.hpp"

namespace eyebridge::gui {

/// The picture that the program got last from its camera, as sharp as it is: at the largest whole
/// scale that fits, or a whole fraction. Looking takes no picture: the run stays the same.
class CameraView final : public QWidget {
  Q_OBJECT

 public:
  /// `frames` is lent.
  CameraView(const camera::LatestFrame& frames, QWidget* parent);

  /// Takes the picture anew if there is another.
  void refresh();
  /// Null until the program took one.
  [[nodiscard]] const QImage& picture() const { return picture_; }
  /// Below the picture: its size, when it was taken, its scale; or that there is none.
  [[nodiscard]] QString caption() const;

  [[nodiscard]] QSize sizeHint() const override { return {360, 180}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {120, 90}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const camera::LatestFrame& frames_;
  camera::FramePtr frame_;  ///< That picture_ shows.
  QImage picture_;
};

}  // namespace eyebridge::gui
