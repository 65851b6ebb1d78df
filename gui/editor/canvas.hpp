#pragma once

#include <QCoreApplication>
#include <QImage>
#include <QWidget>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "editor/document.hpp"
#include "editor/pick.hpp"
#include "plan/viewport.hpp"

namespace eyebridge::gui {

/// What the left button does.
enum class PlanTool { Select, Wall, Thing, Marker, Robot, Start, Way, Measure };

/// A point of a way that is picked, to be removed.
struct WayPoint {
  Item item;
  std::size_t point = 0;

  friend bool operator==(const WayPoint&, const WayPoint&) = default;
};

/// The plan from above, and the tools that draw in it. Ctrl switches the grid off; with Shift walls
/// run straight, and a click adds to what is selected. The middle button moves the picture, the
/// wheel zooms to the pointer.
class Canvas final : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(Canvas)

 public:
  /// Both are lent.
  Canvas(Document& document, QWidget* parent);

  void set_catalogue(Catalogue catalogue);
  [[nodiscard]] const Catalogue& catalogue() const { return catalogue_; }
  /// Of the floor; null: plain.
  void set_texture(const QImage& texture);

  [[nodiscard]] PlanTool tool() const { return tool_; }
  void set_tool(PlanTool tool);
  void set_thing(const std::string& name) { thing_ = name; }
  void set_robot(const std::string& model) { robot_ = model; }
  /// Metres; 0: none, places are then whole millimetres.
  [[nodiscard]] double grid() const { return grid_; }
  void set_grid(double step);

  /// Shows all of it.
  void fit();
  void zoom(double factor);
  [[nodiscard]] const Viewport& viewport() const { return view_; }

  /// What the keyboard does to what is selected.
  void remove();
  void split();
  void move(Vec2 by);
  void turn(double by);
  /// Ends what the mouse is doing, without it; then what is selected is let go.
  void cancel();

  /// Told where the pointer is in the world; of lengths and of what cannot be done.
  std::function<void(Vec2)> on_pointer;
  std::function<void(const QString&)> on_message;

  /// The document has changed.
  void refresh();
  [[nodiscard]] QSize sizeHint() const override { return {800, 600}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] double slack() const;
  [[nodiscard]] bool is_tiny(QPointF pixel) const;
  [[nodiscard]] Vec2 snapped(Vec2 place, Qt::KeyboardModifiers keys) const;
  [[nodiscard]] Vec2 wall_end(Vec2 place, Qt::KeyboardModifiers keys) const;
  void say(const QString& text);
  void say_length(Vec2 from, Vec2 to);

  void take_hold(std::optional<Hold> hold);
  void press_select(Vec2 place, Qt::KeyboardModifiers keys);
  void press_wall(Vec2 place, Qt::KeyboardModifiers keys);
  void press_place(Vec2 place, Qt::KeyboardModifiers keys);
  void press_way(Vec2 place, Qt::KeyboardModifiers keys);
  void drag_hold(Vec2 place, Qt::KeyboardModifiers keys);
  void drag_new(Vec2 place, Qt::KeyboardModifiers keys);
  void release_select(Vec2 place, Qt::KeyboardModifiers keys);
  void finish_wall(Vec2 end);
  Item add(Plan& plan, Vec2 at) const;
  Item add_tools_item(Plan& plan, Vec2 at) const;
  [[nodiscard]] QString step_name() const;

  void paint_overlay(QPainter& painter);
  void paint_measure(QPainter& painter);

  Document& document_;
  Catalogue catalogue_;
  QImage texture_;
  PlanTool tool_ = PlanTool::Select;
  std::string thing_ = "golf";
  std::string robot_ = "S4";
  double grid_ = 0.1;
  Viewport view_;
  bool is_fitted_ = true;

  std::optional<Hold> hold_;
  std::uint64_t held_version_ = 0;  ///< Of the document, when hold_ was picked.
  std::optional<WayPoint> way_point_;
  QPointF press_pixel_;
  Vec2 press_place_;
  bool is_down_ = false;
  bool has_moved_ = false;
  bool is_band_ = false;                          ///< A rubber band from press_place_.
  std::optional<Vec2> chain_;                     ///< Where the next wall begins.
  Vec2 chain_first_;                              ///< Where the first one did.
  std::optional<std::pair<Vec2, Vec2>> measure_;  ///< Shown with its length.
  std::optional<Vec2> new_at_;                    ///< What is being placed stands there.
  std::optional<QPointF> pan_from_;
  Vec2 pointer_;
};

}  // namespace eyebridge::gui
