#include "environment/world_view.hpp"

#include <QImageReader>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "hand/uncertainty.hpp"
#include "plan/paint_world.hpp"

namespace eyebridge::gui {
namespace {

constexpr double kSlack = 4.0;  // pixels that one may point beside a small thing

}  // namespace

WorldView::WorldView(hal::Environment& environment, QWidget* parent)
    : QWidget(parent), environment_(environment) {
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);  // the ground covers all
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(200, 150);
  refresh();
  load_texture();
  fit();
}

void WorldView::load_texture() {
  const auto& name = look_.scene.model->floor_texture;
  if (!name) return;
  const auto path = std::filesystem::path(environment_.directory()) / *name;
  QImageReader reader(QString::fromStdString(path.string()));
  texture_ = reader.read();
  if (!texture_.isNull()) return;
  texture_trouble_ = tr("The floor's picture %1 cannot be read: %2; expected a PNG, JPEG or BMP")
                         .arg(reader.fileName(), reader.errorString());
}

void WorldView::refresh() {
  environment_.look(look_);
  if (on_look) on_look(look_);
  mirror_.follow(look_);
  if (guide_ != nullptr && layers_.uncertainty) believed_ = guide_->look();
  trails_.add(look_);
  if (chosen_ && (*chosen_ >= look_.robots.size() || !look_.robots[*chosen_].is_there)) {
    driver_.release_all();
    chosen_.reset();
    follows_ = false;
  }
  if (grip_ && grip_->robot && !look_.robots[*grip_->robot].is_there) grip_.reset();
  if (follows_ && chosen_ && !grip_) view_.centre_on(look_.robots[*chosen_].pose.position());
  update();
}

void WorldView::set_layers(const Layers& layers) {
  layers_ = layers;
  update();
}

void WorldView::clear_trails() {
  trails_.clear();
  update();
}

void WorldView::fit() {
  is_fitted_ = true;
  follows_ = false;
  view_.fit(look_.scene.model->corner, look_.scene.model->far_corner());
  update();
}

void WorldView::change_view(const std::function<void(Viewport&)>& change) {
  is_fitted_ = false;
  change(view_);
  update();
}

void WorldView::zoom(double factor) {
  change_view([&](Viewport& view) { view.zoom_at(QRectF(rect()).center(), factor); });
}

void WorldView::follow(bool follows) {
  follows_ = follows;
  if (follows) is_fitted_ = false;
}

void WorldView::choose(std::optional<std::size_t> robot) {
  if (robot == chosen_) return;
  if (driver_.any()) {  // whoever was driven stops
    driver_.release_all();
    drive();
  }
  chosen_ = robot;
  update();
}

void WorldView::choose_next() {
  const std::size_t count = look_.robots.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = chosen_ ? (*chosen_ + 1 + i) % count : i;
    if (look_.robots[next].is_there) return choose(next);
  }
}

void WorldView::centre_on_robot() {
  if (!chosen_ || *chosen_ >= look_.robots.size()) return;
  change_view([&](Viewport& view) { view.centre_on(look_.robots[*chosen_].pose.position()); });
}

void WorldView::set_tool(Tool tool) {
  tool_ = tool;
  measures_ = false;
  tape_.reset();
  place_.reset();
  grip_.reset();
  if (tool != Tool::Hand) {
    setCursor(Qt::CrossCursor);
  } else {
    unsetCursor();
  }
  update();
}

void WorldView::paintEvent(QPaintEvent* /*event*/) {
  const QSize pixels = size() * devicePixelRatioF();
  if (ground_.isNull() || ground_.size() != pixels || !(ground_view_ == view_)) {
    ground_ = QPixmap(pixels);
    ground_.setDevicePixelRatio(devicePixelRatioF());
    ground_view_ = view_;
    QPainter painter(&ground_);
    paint_ground(painter, view_, *look_.scene.model, texture_);
  }
  QPainter painter(this);
  painter.drawPixmap(0, 0,
                     layers_.trails ? trail_layer_.paint(ground_, view_, trails_, look_) : ground_);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_robots_layers(painter);
  paint_bodies(painter, view_, look_, chosen_);
  if (layers_.bumpers) {
    for (std::size_t i = 0; i < look_.robots.size(); ++i) {
      if (!look_.robots[i].is_there) continue;
      paint_bumpers(painter, view_, look_.robots[i], mirror_.bumpers(i));
    }
  }
  if (guide_ != nullptr && layers_.uncertainty && believed_.pose) {
    paint_uncertainty(painter, view_, *believed_.pose, believed_.covariance);
  }
  if (tape_) paint_tape(painter, view_, *tape_);
  if (place_) paint_place(painter, view_, *place_);
}

void WorldView::paint_robots_layers(QPainter& painter) {
  constexpr double kConeLength = 1.0;  // metres
  for (std::size_t i = 0; i < look_.robots.size(); ++i) {
    const hal::RobotLook& robot = look_.robots[i];
    if (!robot.is_there) continue;
    if (layers_.camera) paint_camera_cone(painter, view_, robot, kConeLength, chosen_ == i);
    if (layers_.lidar) {
      const QColor colour(170, 110, 205);
      const std::vector<SensorRay>& scan = mirror_.lidar_rays(i);
      if (chosen_ == i) {
        paint_rays(painter, view_, scan, colour);
      } else {
        paint_scan(painter, view_, scan, colour);
      }
    }
    if (layers_.distances) paint_rays(painter, view_, mirror_.distance_rays(i), QColor(0, 140, 0));
    if (layers_.proximities) {
      paint_rays(painter, view_, mirror_.proximity_rays(i), QColor(200, 90, 0));
    }
  }
}

void WorldView::resizeEvent(QResizeEvent* /*event*/) {
  view_.resize(size());
  if (is_fitted_) fit();
}

void WorldView::mousePressEvent(QMouseEvent* event) {
  const Vec2 place = view_.to_world(event->position());
  if (event->button() == Qt::LeftButton && tool_ == Tool::Place) {
    place_ = Pose{place.x, place.y, 0.0};
    update();
    return;
  }
  if (event->button() == Qt::LeftButton && tool_ == Tool::Tape) {
    tape_ = Tape{place, place};
    measures_ = true;
    update();
    return;
  }
  if (event->button() == Qt::LeftButton) {
    grip_ = grip_at(look_, place, kSlack / view_.pixels_per_metre());
    if (grip_ && grip_->robot) choose(grip_->robot);
  }
  const bool pans =
      (event->button() == Qt::LeftButton && !grip_) || event->button() == Qt::MiddleButton;
  if (!pans) return;
  pan_from_ = event->position();
  setCursor(Qt::ClosedHandCursor);
}

void WorldView::mouseMoveEvent(QMouseEvent* event) {
  const Vec2 place = view_.to_world(event->position());
  if (on_pointer) on_pointer(place);
  if (grip_) carry(place);
  if (place_ && norm(place - place_->position()) * view_.pixels_per_metre() > kSlack) {
    const Vec2 way = place - place_->position();
    place_->theta = arc_tan2(way.y, way.x);
    update();
  }
  if (measures_) {
    tape_->to = place;
    update();
  }
  if (!pan_from_) return;
  const QPointF way = event->position() - *pan_from_;
  pan_from_ = event->position();
  follows_ = false;
  change_view([&](Viewport& view) { view.pan(way); });
}

void WorldView::mouseReleaseEvent(QMouseEvent* /*event*/) {
  grip_.reset();
  pan_from_.reset();
  measures_ = false;
  setCursor(tool_ == Tool::Hand ? Qt::ArrowCursor : Qt::CrossCursor);
  if (const auto place = std::exchange(place_, {}); place && on_place) on_place(*place);
}

void WorldView::carry(Vec2 place) {
  const Pose pose = moved(*grip_, place);
  // Nothing is put into something else: it stays where it could stand last.
  if (!grip_->turns && !mirror_.is_free(grip_->body, pose.position())) {
    tell_trouble(tr("There is no room here"));
    return;
  }
  hal::WorldControl& control = environment_.control();
  const Result<void> done =
      grip_->robot ? control.set_robot_pose(static_cast<int>(*grip_->robot) + 1, pose)
                   : control.set_object_pose(static_cast<int>(grip_->object) + 1, pose);
  tell_trouble(done ? QString() : QString::fromStdString(done.error().what));
  refresh();
}

void WorldView::tell_trouble(const QString& text) const {
  if (on_trouble) on_trouble(text);
}

void WorldView::set_driving(bool drives) {
  drives_ = drives;
  if (drives) {
    setFocus();
    if (!chosen_) choose_next();
  } else if (driver_.any()) {
    driver_.release_all();
    drive();
  }
}

void WorldView::drive() {
  if (!chosen_ || *chosen_ >= look_.robots.size()) return tell_trouble(tr("Choose a robot first"));
  const Result<void> done =
      environment_.drive(*chosen_, driver_.twist(*look_.robots[*chosen_].model));
  tell_trouble(done ? QString() : QString::fromStdString(done.error().what));
}

void WorldView::keyPressEvent(QKeyEvent* event) {
  if (!drives_ || !KeyboardDriver::knows(event->key())) return QWidget::keyPressEvent(event);
  if (event->isAutoRepeat()) return;
  driver_.press(event->key());
  drive();
}

void WorldView::keyReleaseEvent(QKeyEvent* event) {
  if (!drives_ || !KeyboardDriver::knows(event->key())) return QWidget::keyReleaseEvent(event);
  if (event->isAutoRepeat()) return;
  if (driver_.release(event->key())) drive();
}

void WorldView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  if (!driver_.any()) return;  // nobody would tell us that the key was released
  driver_.release_all();
  drive();
}

void WorldView::contextMenuEvent(QContextMenuEvent* event) {
  const Vec2 place = view_.to_world(event->pos());
  const auto grip = grip_at(look_, place, kSlack / view_.pixels_per_metre());
  if (!grip) return;
  if (!grip->robot) {
    if (on_thing_menu) on_thing_menu(event->globalPos(), grip->object);
    return;
  }
  choose(grip->robot);
  if (on_menu) on_menu(event->globalPos());
}

void WorldView::wheelEvent(QWheelEvent* event) {
  change_view([&](Viewport& view) { view.zoom_at(event->position(), zoom_of(*event)); });
}

}  // namespace eyebridge::gui
