#include "environment/scene_view.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "eyebridge/base/config_error.hpp"
#include "plan/viewport.hpp"
#include "widgets/frame_image.hpp"

namespace eyebridge::gui {
namespace {

constexpr int kWidest = 960;  // pixels: more would take too long without a graphics card

}  // namespace

/// What the renderer looks at.
class SceneView::Stage final : public camera::View, public LogSink {
 public:
  explicit Stage(std::string directory) : directory_(std::move(directory)) {}

  [[nodiscard]] world::Scene scene() const override { return scene_; }
  [[nodiscard]] camera::Eye eye() const override { return eye_; }
  [[nodiscard]] std::uint32_t carrier() const override { return carrier_; }
  [[nodiscard]] camera::ImageNoise noise() const override { return {}; }
  [[nodiscard]] std::string texture_directory() const override { return directory_; }
  /// Of textures that are missing: the program's own camera tells of them, and the log of it.
  void write(Severity /*severity*/, std::string_view /*text*/) override {}

  void show(const world::Scene& scene, const camera::Eye& eye, std::uint32_t carrier) {
    scene_ = scene;
    eye_ = eye;
    carrier_ = carrier;
  }

 private:
  const std::string directory_;
  world::Scene scene_;
  camera::Eye eye_;
  std::uint32_t carrier_ = world::kNoBody;
};

SceneView::SceneView(std::string directory, QWidget* parent)
    : QWidget(parent), stage_(std::make_unique<Stage>(std::move(directory))) {
  setMinimumSize(160, 120);
  setAccessibleName(tr("The world in three dimensions"));
  setToolTip(tr("Left button: turn. Right button: move. Wheel: nearer"));
}

SceneView::~SceneView() = default;

void SceneView::fit() { is_placed_ = false; }

void SceneView::open() {
  if (std::exchange(is_opened_, true)) return;
  try {
    source_ = camera::open_source("render", {&clock_, stage_.get(), stage_.get()});
  } catch (const ConfigError& error) {
    trouble_ = QString::fromStdString(error.what());
  }
}

void SceneView::refresh(const hal::WorldLook& look, std::optional<std::size_t> chosen) {
  if (!isVisible()) return;
  if (!is_placed_) {
    is_placed_ = true;
    orbit_ = Orbit::of_floor(look.scene.model->corner, look.scene.model->far_corner());
  }
  const bool has_robot = chosen && *chosen < look.robots.size();
  camera::Eye eye = orbit_.eye();
  std::uint32_t carrier = world::kNoBody;
  if (from_ == From::BehindRobot && has_robot) {
    eye = Orbit::behind(look.robots[*chosen].pose).eye();
  } else if (from_ == From::RobotsCamera && has_robot && look.robots[*chosen].eye) {
    eye = *look.robots[*chosen].eye;
    carrier = look.robots[*chosen].body;
  }
  stage_->show(look.scene, eye, carrier);
  draw();
}

void SceneView::draw() {
  open();
  if (source_) {
    const QSizeF pixels = QSizeF(size()) * devicePixelRatioF();
    const double share = std::min(1.0, kWidest / pixels.width());
    const auto side = [share](double length) {
      return std::max(1, static_cast<int>(length * share));
    };
    const auto frame = source_->set_size(side(pixels.width()), side(pixels.height())).and_then([&] {
      return source_->next(clock_.now() + std::chrono::seconds(1));
    });
    if (frame) {
      picture_ = image_of(**frame);
      ++count_;
    } else {
      trouble_ = QString::fromStdString(frame.error().what);
      source_.reset();
    }
  }
  update();
}

void SceneView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  if (picture_.isNull() || !trouble_.isEmpty()) {
    painter.fillRect(rect(), palette().color(QPalette::Dark));
    painter.setPen(palette().color(QPalette::BrightText));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, trouble_);
    return;
  }
  painter.drawImage(rect(), picture_);
}

void SceneView::mousePressEvent(QMouseEvent* event) { last_ = event->position(); }

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF way = event->position() - last_;
  last_ = event->position();
  if ((event->buttons() & Qt::LeftButton) != 0) {
    constexpr double kTurn = deg_to_rad(0.4);  // a pixel
    orbit_.turn(-kTurn * way.x(), kTurn * way.y());
  } else {
    // About as far as what lies at the target goes with the pointer.
    const double metres = orbit_.distance / std::max(1, width());
    orbit_.shift(-metres * way.x(), metres * way.y());
  }
}

void SceneView::wheelEvent(QWheelEvent* event) {
  constexpr double kFactor = 0.85;
  orbit_.move_away(std::pow(kFactor, notches_of(*event)));
}

}  // namespace eyebridge::gui
