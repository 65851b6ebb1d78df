#pragma once

#include <QImage>
#include <QPixmap>
#include <QWidget>
#include <functional>
#include <optional>

#include "environment/keyboard_driver.hpp"
#include "environment/tape.hpp"
#include "environment/trail_layer.hpp"
#include "environment/trails.hpp"
#include "eyebridge/hal/hand_guide.hpp"
#include "plan/grip.hpp"
#include "plan/mirror.hpp"
#include "plan/viewport.hpp"

namespace eyebridge::gui {

/// What is drawn beside walls and bodies.
struct Layers {
  bool trails = true;
  bool distances = true;
  bool proximities = true;
  bool lidar = false;
  bool camera = false;
  bool bumpers = true;
  bool uncertainty = true;  ///< Of the pose, where a guide knows it.

  friend bool operator==(const Layers&, const Layers&) = default;
};

/// What the left button is.
enum class Tool {
  Hand,   ///< Takes robots and things, moves the picture.
  Tape,   ///< Measures.
  Place,  ///< Shows where something shall stand, and by dragging where it shall look.
};

/// The world from above. The left button takes a robot by its middle to carry it, or by its rim to
/// turn it, and things likewise; on the floor, and with the middle button, it moves the picture;
/// the wheel zooms to the pointer. With the tape it measures instead. With driving on, the arrow
/// keys drive the chosen robot.
class WorldView final : public QWidget {
  Q_OBJECT
 public:
  /// `environment` is lent.
  WorldView(hal::Environment& environment, QWidget* parent);

  /// Shows what `guide`, lent, believes of the pose of the robot that a person carries.
  void set_guide(const hal::HandGuide& guide) { guide_ = &guide; }
  /// Looks at the world as it is now.
  void refresh();
  [[nodiscard]] const hal::WorldLook& look() const { return look_; }
  [[nodiscard]] Mirror& mirror() { return mirror_; }
  [[nodiscard]] const Viewport& viewport() const { return view_; }

  [[nodiscard]] const Layers& layers() const { return layers_; }
  void set_layers(const Layers& layers);
  void clear_trails();
  /// Why something cannot be shown; empty when all can.
  [[nodiscard]] const QString& missing() const { return texture_trouble_; }
  /// Shows all of it.
  void fit();
  /// About the middle of the view.
  void zoom(double factor);
  /// The view goes with the chosen robot.
  void follow(bool follows);
  /// The one that a person points at, by its index: its readings are wanted. It is there.
  [[nodiscard]] std::optional<std::size_t> chosen() const { return chosen_; }
  void choose(std::optional<std::size_t> robot);
  /// Chooses the one after that which is there.
  void choose_next();
  /// The chosen robot is in the middle.
  void centre_on_robot();
  void set_tool(Tool tool);
  [[nodiscard]] const std::optional<Tape>& tape() const { return tape_; }
  /// Whether the arrow keys drive.
  void set_driving(bool drives);

  /// Told of each look at the world, also of those that a person's doings bring.
  std::function<void(const hal::WorldLook&)> on_look;
  /// Told that a person asks with the right button, at this place of the display, what can be done
  /// with the chosen robot, which she pressed.
  std::function<void(QPoint)> on_menu;
  /// The same of a thing, by its number, from 0.
  std::function<void(QPoint, std::size_t)> on_thing_menu;
  /// Told of a place that was shown.
  std::function<void(const Pose&)> on_place;
  /// Told where the pointer is, in the world; and why something could not be done.
  std::function<void(Vec2)> on_pointer;
  std::function<void(const QString&)> on_trouble;

  [[nodiscard]] QSize sizeHint() const override { return {800, 600}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void tell_trouble(const QString& text) const;
  void load_texture();
  void drive();
  void carry(Vec2 place);
  void change_view(const std::function<void(Viewport&)>& change);
  void paint_robots_layers(QPainter& painter);

  hal::Environment& environment_;
  hal::WorldLook look_;
  Mirror mirror_;
  const hal::HandGuide* guide_ = nullptr;
  hal::HandLook believed_;
  Trails trails_;
  TrailLayer trail_layer_;
  Layers layers_;
  Viewport view_;
  bool is_fitted_ = true;  ///< Nobody has moved the view yet: it fits whatever size it gets.
  bool follows_ = false;
  std::optional<std::size_t> chosen_ = 0;
  std::optional<Grip> grip_;
  std::optional<QPointF> pan_from_;
  Tool tool_ = Tool::Hand;
  std::optional<Tape> tape_;
  std::optional<Pose> place_;  ///< That is being shown.
  bool measures_ = false;      ///< The tape's end is at the pointer.
  bool drives_ = false;
  KeyboardDriver driver_;
  QImage texture_;
  QPixmap ground_;  ///< Of ground_view_, at this widget's size; null: to be painted.
  Viewport ground_view_;
  QString texture_trouble_;  ///< Why the floor's picture is missing.
};

}  // namespace eyebridge::gui
