#include "hand/hand_window.hpp"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>

#include "hand/uncertainty.hpp"
#include "widgets/save_picture.hpp"

namespace eyebridge::gui {
namespace {

constexpr int kHandRefresh_ms = 33;  // as the cameras

}  // namespace

HandWindow::HandWindow(const robios::HandStart& start)
    : guide_(*start.guide),
      frames_(start.frames),
      sign_(new DirectionSign(this)),
      camera_(new MarkerView(this)),
      place_(new QLabel(this)) {
  setWindowTitle(tr("%1 – carried by hand").arg(QString::fromStdString(start.title)));
  setCentralWidget(sign_);
  auto* dock = new QDockWidget(tr("Camera"), this);
  dock->setObjectName("camera");
  dock->setWidget(camera_);
  dock->toggleViewAction()->setShortcut(Qt::Key_F5);
  addDockWidget(Qt::RightDockWidgetArea, dock);
  place_->setObjectName("place");
  QFont large = place_->font();
  large.setPointSizeF(1.4 * large.pointSizeF());
  place_->setFont(large);
  place_->setAccessibleName(tr("Where the robot is"));
  statusBar()->addWidget(place_, 1);
  make_menus(*dock);
  // Qt takes two thirds of the display at most; then as it was left.
  resize(sizeHint().boundedTo(screen()->availableSize()));
  const QSettings settings;
  restoreGeometry(settings.value("hand/geometry").toByteArray());
  restoreState(settings.value("hand/state").toByteArray());
  connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
  timer_.start(kHandRefresh_ms);
  refresh();
}

HandWindow::~HandWindow() {
  if (isVisible()) keep_layout();
}

void HandWindow::closeEvent(QCloseEvent* event) {
  // Now: a process whose last window is closed may end without destroying it.
  keep_layout();
  QMainWindow::closeEvent(event);
}

void HandWindow::keep_layout() {
  QSettings settings;
  settings.setValue("hand/geometry", saveGeometry());
  settings.setValue("hand/state", saveState());
}

void HandWindow::make_menus(QDockWidget& camera) {
  QMenu& file = *menuBar()->addMenu(tr("&File"));
  QAction* const save = file.addAction(tr("&Save picture..."), this, [this] {
    ask_where_to_save_picture(*this, tr("Save picture"), "hand.png",
                              [this](const QString& path) { save_window(path); });
  });
  save->setShortcut(QKeySequence::Save);
  file.addSeparator();
  QAction* const close = file.addAction(tr("&Close"), this, [this] { this->close(); });
  close->setShortcut(QKeySequence::Close);
  QMenu& view = *menuBar()->addMenu(tr("&View"));
  view.addAction(camera.toggleViewAction());
  QAction* const markers = view.addAction(tr("&Markers"));
  markers->setCheckable(true);
  markers->setChecked(true);
  markers->setShortcut(Qt::Key_M);
  connect(markers, &QAction::toggled, this, [this](bool on) { camera_->set_marked(on); });
  QAction* const full = view.addAction(tr("&Full screen"));
  full->setCheckable(true);
  full->setShortcut(Qt::Key_F11);
  connect(full, &QAction::toggled, this,
          [this](bool on) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, on)); });
}

void HandWindow::refresh() {
  const hal::HandLook look = guide_.look();
  sign_->show_words(words_for(look.instruction));
  const bool has_own = look.has_markers || frames_ == nullptr;
  camera_->show_frame(has_own ? look.frame : frames_->get(), look.markers);
  show_place(look);
}

void HandWindow::show_place(const hal::HandLook& look) {
  QString text = tr("Without markers: go as the sign says");
  if (look.has_markers) {
    text =
        look.pose ? pose_text(*look.pose, look.covariance) : tr("Nobody knows where the robot is");
  }
  if (text != place_->text()) place_->setText(text);
}

void HandWindow::tell_end(const QString& how) {
  timer_.stop();
  sign_->show_words({camera::Arrow::None, tr("The run has ended"), how, {}});
}

bool HandWindow::save_window(const QString& path) {
  const bool is_saved = save_picture(grab().toImage(), path);
  const QString text = is_saved ? tr("Saved %1") : tr("%1 cannot be written");
  constexpr int kRead_ms = 5000;
  statusBar()->showMessage(text.arg(path), kRead_ms);
  return is_saved;
}

}  // namespace eyebridge::gui
