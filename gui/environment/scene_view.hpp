#pragma once

#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>

#include "environment/orbit.hpp"
#include "eyebridge/base/jumping_clock.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/camera/source.hpp"
#include "eyebridge/hal/environment.hpp"

namespace eyebridge::gui {

/// The world as the robots' cameras would show it: drawn by the same renderer, from where a person
/// wants it. The left button turns, the right and the middle one move, the wheel comes nearer; or
/// the eye is behind the chosen robot.
class SceneView final : public QWidget {
  Q_OBJECT
 public:
  /// Whose eye it is.
  enum class From { Free, BehindRobot, RobotsCamera };

  /// `directory` is where textures are looked for.
  SceneView(std::string directory, QWidget* parent);
  ~SceneView() override;

  /// Draws the world anew, if anybody can see this. `chosen`: the robot whose eye it is.
  void refresh(const hal::WorldLook& look, std::optional<std::size_t> chosen);
  void set_from(From from) { from_ = from; }
  [[nodiscard]] From from() const { return from_; }
  [[nodiscard]] const Orbit& orbit() const { return orbit_; }
  /// What was drawn last; null before that.
  [[nodiscard]] const QImage& picture() const { return picture_; }
  /// How many have been drawn.
  [[nodiscard]] int count() const { return count_; }
  /// All of the floor.
  void fit();

  [[nodiscard]] QSize sizeHint() const override { return {400, 300}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  class Stage;

  void open();
  void draw();

  const std::unique_ptr<Stage> stage_;
  JumpingClock clock_;
  std::unique_ptr<camera::Source>
      source_;  ///< Null before the first picture, and where it cannot be.
  bool is_opened_ = false;
  QString trouble_;  ///< Why there is no picture.
  QImage picture_;
  int count_ = 0;
  Orbit orbit_;
  bool is_placed_ = false;  ///< The orbit is where it was put, not where it is by default.
  From from_ = From::Free;
  QPointF last_;  ///< Of the mouse.
};

}  // namespace eyebridge::gui
