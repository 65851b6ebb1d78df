#include "panel/panel_window.hpp"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QScreen>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

#include "keys.hpp"
#include "widgets/frame_image.hpp"
#include "widgets/save_picture.hpp"

namespace eyebridge::gui {
namespace {

constexpr int kLcdRefresh_ms = 33;       // as fast as programs that show pictures
constexpr int kFramesPerInspection = 5;  // six times a second: who reads numbers is slower

QString colour_name(Rgb colour) { return QColor(colour.r, colour.g, colour.b).name(); }

void show_look(QPushButton& key, const robios::SoftKeyLook& look) {
  // An ampersand would name a shortcut.
  QString label = QString::fromStdString(look.label).replace('&', "&&");
  key.setText(label);
  key.setStyleSheet(label.isEmpty() ? QString()
                                    : QString("color: %1; background-color: %2;")
                                          .arg(colour_name(look.ink), colour_name(look.paper)));
}

}  // namespace

PanelWindow::PanelWindow(const robios::PanelStart& start)
    : screen_(*start.screen), presses_(*start.keys) {
  setWindowTitle(QString::fromStdString(start.title));
  setFocusPolicy(Qt::StrongFocus);
  if (start.notes != nullptr) speaker_ = new Speaker(*start.notes, this);
  make_screen();
  make_docks(start);
  make_menus();
  // Qt takes two thirds of the display at most; then as it was left.
  resize(sizeHint().boundedTo(screen()->availableSize()));
  const QSettings settings;
  restoreGeometry(settings.value("panel/geometry").toByteArray());
  restoreState(settings.value("panel/state").toByteArray());
  leave_room_for_the_screen();
  setFocus();
  presses_.set_window(true);
  connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
  timer_.start(kLcdRefresh_ms);
  refresh();
}

PanelWindow::~PanelWindow() {
  if (isVisible()) keep_layout();
  presses_.set_window(false);
}

void PanelWindow::leave_room_for_the_screen() {
  // On a small display the robot's screen and keys go first; F5 to F7 bring the others.
  const QSize room = screen()->availableSize();
  const QSize least = minimumSizeHint();
  if (least.width() <= room.width() && least.height() <= room.height()) return;
  for (QDockWidget* const dock : findChildren<QDockWidget*>()) dock->hide();
  resize(centralWidget()->sizeHint().boundedTo(room));
}

void PanelWindow::keep_layout() {
  QSettings settings;
  settings.setValue("panel/geometry", saveGeometry());
  settings.setValue("panel/state", saveState());
}

void PanelWindow::closeEvent(QCloseEvent* event) {
  // Now: a process whose last window is closed may end without destroying it.
  keep_layout();
  QMainWindow::closeEvent(event);
  // Nobody can press its keys any more. With the last window the whole program ends, politely.
  const auto others = QApplication::topLevelWidgets();
  const bool is_last = std::ranges::none_of(others, [this](const QWidget* other) {
    return other != this && other->isWindow() && other->isVisible();
  });
  if (!is_last) presses_.set_window(false);
}

void PanelWindow::make_screen() {
  auto* middle = new QWidget(this);
  setCentralWidget(middle);
  auto* column = new QVBoxLayout(middle);
  lcd_ = new LcdWidget(screen_, presses_, middle);
  column->addWidget(lcd_, 1);
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  for (int i = 0; i < robios::kSoftKeys; ++i) {
    auto* key = new QPushButton(middle);
    key->setObjectName(QString("key%1").arg(i + 1));
    key->setAccessibleName(tr("KEY%1").arg(i + 1));
    key->setToolTip(tr("KEY%1 (keyboard: %1 or F%1)").arg(i + 1));
    key->setFocusPolicy(Qt::NoFocus);  // Space and Return are the program's
    connect(key, &QPushButton::pressed, this, [this, i] { press(i); });
    row->addWidget(key);
    keys_.at(static_cast<std::size_t>(i)) = key;
  }
  if (speaker_ != nullptr) column->addWidget(speaker_);
  told_ = new QLabel(middle);
  told_->setObjectName("told");
  told_->setWordWrap(true);
  told_->hide();
  column->addWidget(told_);
}

void PanelWindow::make_docks(const robios::PanelStart& start) {
  QDockWidget* first = nullptr;
  if (start.frames != nullptr) {
    camera_ = new CameraView(*start.frames, this);
    add_dock(tr("Camera"), "camera", Qt::Key_F5, camera_);
  }
  if (start.notes != nullptr) {
    inspector_ = new Inspector(*start.notes, presses_, this);
    inspector_->installEventFilter(this);
    first = add_dock(tr("Inspector"), "inspector", Qt::Key_F6, inspector_);
  }
  remote_ = new RemoteControl(presses_, this);
  QDockWidget* const control = add_dock(tr("Remote control"), "remote", Qt::Key_F7, remote_);
  if (camera_ != nullptr) {
    auto* const dock = findChild<QDockWidget*>("camera");
    resizeDocks({dock}, {camera_->sizeHint().width()}, Qt::Horizontal);
  }
  if (first == nullptr) return;
  tabifyDockWidget(first, control);
  first->raise();
}

QDockWidget* PanelWindow::add_dock(const QString& title, const char* name, const QKeySequence& key,
                                   QWidget* widget) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(widget);
  dock->installEventFilter(this);  // one that floats is a window of its own
  dock->toggleViewAction()->setShortcut(key);
  addDockWidget(Qt::RightDockWidgetArea, dock);
  return dock;
}

void PanelWindow::refresh() {
  refresh_docks();
  if (!lcd_->refresh() && are_labelled_) return;
  are_labelled_ = true;
  const robios::ScreenShot shot = screen_.shot();
  for (std::size_t i = 0; i < keys_.size(); ++i) show_look(*keys_.at(i), shot.keys.at(i));
}

void PanelWindow::refresh_docks() {
  if (camera_ != nullptr && camera_->isVisible()) camera_->refresh();
  if (speaker_ != nullptr) speaker_->refresh();
  const bool is_turn = frames_++ % kFramesPerInspection == 0;
  if (inspector_ == nullptr) return;
  if (is_turn && inspector_->isVisible()) {
    inspector_->refresh();
  } else {
    inspector_->look();
  }
}

void PanelWindow::press(int index) { presses_.press(1 << index); }

void PanelWindow::tell(const QString& text) {
  told_->setText(text);
  told_->show();
}

void PanelWindow::tell_end(const QString& how) {
  refresh();
  if (inspector_ != nullptr) inspector_->refresh();
  if (speaker_ != nullptr) speaker_->put_out();
  timer_.stop();
  tell(how);
  for (QPushButton* key : keys_) key->setEnabled(false);
  remote_->setEnabled(false);
  for (QAction* action : findChildren<QAction*>()) {
    if (action->property("sends").toBool()) action->setEnabled(false);
  }
}

bool PanelWindow::save_screen(const QString& path) {
  const bool is_saved = save_picture(image_of(screen_.snapshot()), path);
  tell(is_saved ? tr("Saved %1").arg(path) : tr("%1 cannot be written").arg(path));
  return is_saved;
}

bool PanelWindow::press_by_keyboard(const QKeyEvent& event) {
  const auto modifiers = event.modifiers() & ~Qt::KeypadModifier;
  if (event.isAutoRepeat() || modifiers != Qt::NoModifier) return false;
  for (int i = 0; i < robios::kSoftKeys; ++i) {
    if (event.key() != Qt::Key_1 + i && event.key() != Qt::Key_F1 + i) continue;
    if (keys_.at(static_cast<std::size_t>(i))->isEnabled()) press(i);
    return true;
  }
  return false;
}

void PanelWindow::keyPressEvent(QKeyEvent* event) {
  if (!press_by_keyboard(*event)) QMainWindow::keyPressEvent(event);
}

bool PanelWindow::eventFilter(QObject* watched, QEvent* event) {
  // A tree would look for an item of that name.
  const bool is_key = event->type() == QEvent::KeyPress;
  if (is_key && press_by_keyboard(*static_cast<QKeyEvent*>(event))) return true;
  return QMainWindow::eventFilter(watched, event);
}

}  // namespace eyebridge::gui
