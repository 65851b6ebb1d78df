#include "app/gui_windows.hpp"

#include <QApplication>
#include <QFileInfo>
#include <QMessageBox>
#include <QMetaObject>
#include <QObject>
#include <QScreen>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <future>
#include <memory>
#include <utility>

#include <pthread.h>
#include <unistd.h>

#include "editor/editor_window.hpp"
#include "environment/environment_window.hpp"
#ifdef EYEBRIDGE_HAVE_CODE_PANEL
#include "code/code_window.hpp"
#endif
#include "eyebridge/base/deaf_thread.hpp"
#include "hand/hand_window.hpp"
#include "keys.hpp"
#include "panel/panel_window.hpp"

namespace eyebridge::gui {
namespace {

// How far each new panel lies from the one before, pixels.
constexpr int kCascade = 32;
constexpr int kCascadeLength = 10;
constexpr int kPanelStride = 440;  // about that of a panel, and a margin

/// Of this process, which has one at most.
std::atomic<GuiWindows*> the_windows = nullptr;
QtMessageHandler usual_handler = nullptr;

/// Qt counts one user too few of what it has for its main thread when that is not the process's
/// (QThreadData::current() of 6.4), and frees it before the last of its plug-ins' objects go, which
/// is when the process ends. So there is one user more, who never goes.
void keep_thread_data() { [[maybe_unused]] static const auto* const user = new QObject; }

/// Qt calls exit() when its display is gone, and before it has nothing but this to say so.
void take_message(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  usual_handler(type, context, text);
  GuiWindows* const windows = the_windows;
  if (windows != nullptr && text.startsWith("The X11 connection broke")) {
    windows->display_went_away();
  }
}

}  // namespace

GuiWindows::GuiWindows(robios::WindowsStart start) : start_(std::move(start)) {
  thread_ = deaf_thread([this] { run(); });  // and so are Qt's own
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return is_ready_; });
}

GuiWindows::~GuiWindows() {
  post([] { QApplication::quit(); });
  join();
}

void GuiWindows::display_went_away() {
  if (std::this_thread::get_id() != thread_.get_id()) return;
  {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(is_ready_, false)) return;  // nobody waits for us from now on
  }
  std::fputs("eyebridge: the display went away: the run ends\n", stderr);
  keep_all();
  start_.quit();
  // The signal ends the process when motors stand and results are written; going on would end it
  // before.
  while (true) pause();
}

void GuiWindows::keep_all() {
  for (const auto& window : environments_) window->stop_film();
  for (const auto& window : editors_) {
    if (auto* const editor = dynamic_cast<EditorWindow*>(window.data())) editor->keep_now();
#ifdef EYEBRIDGE_HAVE_CODE_PANEL
    if (auto* const code = dynamic_cast<CodeWindow*>(window.data())) code->keep_now();
#endif
  }
}

void GuiWindows::run() {
  pthread_setname_np(pthread_self(), "eb:gui");
  the_windows = this;
  if (usual_handler == nullptr) usual_handler = qInstallMessageHandler(take_message);
  run_application();
  the_windows = nullptr;
  // Not before Qt is done: whoever waits for us ends the process.
  const std::lock_guard lock(mutex_);
  has_ended_ = true;
  changed_.notify_all();
}

void GuiWindows::run_application() {
  int argc = 1;
  std::string name = "eyebridge";
  std::array<char*, 2> argv = {name.data(), nullptr};
  QApplication application(argc, argv.data());
  keep_thread_data();
  QApplication::setApplicationName("eyebridge");
  QApplication::setOrganizationName("eyebridge");
  QApplication::setQuitOnLastWindowClosed(false);
  QObject::connect(&application, &QApplication::lastWindowClosed, [this] { last_window_closed(); });
  QMetaObject::invokeMethod(
      &application,
      [this] {
        const std::lock_guard lock(mutex_);
        is_ready_ = true;
        changed_.notify_all();
      },
      Qt::QueuedConnection);
  QApplication::exec();
  {
    const std::lock_guard lock(mutex_);
    is_ready_ = false;
  }
  panels_.clear();
  hand_views_.clear();
  environments_.clear();
  for (const auto& window : editors_) delete window;
}

bool GuiWindows::post(std::function<void()> action) {
  const std::lock_guard lock(mutex_);
  if (!is_ready_) return false;
  QMetaObject::invokeMethod(qApp, std::move(action), Qt::QueuedConnection);
  return true;
}

void GuiWindows::in_thread(const std::function<void()>& action) {
  QMetaObject::invokeMethod(qApp, action, Qt::BlockingQueuedConnection);
}

void GuiWindows::open_panel(const robios::PanelStart& start) {
  // At once: a program may wait for a key before its panel is there.
  start.keys->set_window(true);
  const bool comes = post([this, start] {
    const auto& panel = panels_.emplace_back(std::make_unique<PanelWindow>(start));
    const int step = kCascade * (static_cast<int>(panels_.size() - 1) % kCascadeLength);
    // The first one is where it was left, if it was.
    if (panel->pos().isNull() || step > 0) panel->move(kCascade + step, kCascade + step);
    show(*panel);
  });
  if (!comes) start.keys->set_window(false);
}

void GuiWindows::close_panel(const robios::Screen& screen) {
  post([this, &screen] {
    is_removing_ = true;
    std::erase_if(panels_, [&](const auto& panel) { return panel->shows(screen); });
    is_removing_ = false;
  });
}

void GuiWindows::open_hand_view(const robios::HandStart& start) {
  post([this, start] {
    hand_views_.push_back(std::make_unique<HandWindow>(start));
    guide_ = start.guide;
    for (const auto& window : environments_) window->view().set_guide(*guide_);
    show(*hand_views_.back());
  });
}

void GuiWindows::open_environment(hal::Environment& environment, robios::Crew* crew) {
  post([this, &environment, crew] {
    const auto& window = environments_.emplace_back(std::make_unique<EnvironmentWindow>(
        environment, QString::fromStdString(start_.program), crew));
    // Beside the panels, unless it was put somewhere before.
    if (window->pos().isNull()) window->move(kPanelStride, kCascade);
    if (guide_ != nullptr) window->view().set_guide(*guide_);
    window->on_edit = [this](const QString& file) { open_editor(file); };
    show(*window);
  });
}

void GuiWindows::open_map(const robios::MapStart& start) {
  post([this, start] {
    if (environments_.empty()) return;
    environments_.back()->show_map(QString::fromStdString(start.title), *start.board);
  });
}

void GuiWindows::edit(const std::string& path) {
  post([this, file = QString::fromStdString(path)] { open_editor(file); });
}

void GuiWindows::open_editor(const QString& file) {
  const QString ending = QFileInfo(file).suffix().toLower();
  const bool is_world = file.isEmpty() || ending == "wld" || ending == "maz" || ending == "sim";
  if (!file.isEmpty()) {
    for (const auto& editor : editors_) {
      if (editor && is_open_in(*editor, file)) return bring_to_front(*editor);
    }
  }
  QWidget* window = nullptr;
  if (is_world) {
    window = new EditorWindow(file);
  } else {
#ifdef EYEBRIDGE_HAVE_CODE_PANEL
    window = new CodeWindow(QStringList(file), CodeSettings::defaults());
#else
    window = new QMessageBox(QMessageBox::Warning, "EyeBridge",
                             QCoreApplication::translate(
                                 "GuiWindows",
                                 "%1 cannot be opened: this EyeBridge was built without QScintilla "
                                 "(libqscintilla2-qt6-dev), which its code panel needs")
                                 .arg(file));
#endif
  }
  window->setAttribute(Qt::WA_DeleteOnClose);
  editors_.emplace_back(window);
  show(*window);
}

bool GuiWindows::is_open_in(QWidget& window, const QString& file) {
  const QString whole = QFileInfo(file).canonicalFilePath();
  if (whole.isEmpty() || !window.isVisible()) return false;  // it may still be deleted
  if (auto* const world = dynamic_cast<EditorWindow*>(&window)) {
    return QFileInfo(world->path()).canonicalFilePath() == whole;
  }
#ifdef EYEBRIDGE_HAVE_CODE_PANEL
  if (auto* const code = dynamic_cast<CodeWindow*>(&window)) return code->show_file(file);
#endif
  return false;
}

void GuiWindows::bring_to_front(QWidget& window) {
  if (window.isMinimized()) window.showNormal();
  window.raise();
  window.activateWindow();
}

void GuiWindows::show(QWidget& window) {
  const QRect screen = window.screen()->availableGeometry();
  if (!screen.contains(window.geometry())) {
    window.resize(window.size().boundedTo(screen.size()));
    const QSize rest = screen.size() - window.size();
    const QPoint from = window.pos() - screen.topLeft();
    // What is larger for good begins at the upper left corner, where its menus are.
    window.move(screen.topLeft() + QPoint(std::clamp(from.x(), 0, std::max(0, rest.width())),
                                          std::clamp(from.y(), 0, std::max(0, rest.height()))));
  }
  window.show();
  window.raise();
}

void GuiWindows::last_window_closed() {
  if (is_removing_) return;  // nobody has asked for the run's end
  if (program_has_ended_) {
    QApplication::quit();
  } else {
    start_.quit();
  }
}

void GuiWindows::complete_files() {
  if (std::this_thread::get_id() == thread_.get_id()) return keep_all();
  auto done = std::make_shared<std::promise<void>>();
  std::future<void> is_done = done->get_future();
  const bool comes = post([this, done] {
    keep_all();
    done->set_value();
  });
  constexpr std::chrono::seconds kPatience(1);  // the windows may hang
  if (comes) is_done.wait_for(kPatience);
}

void GuiWindows::finish(const std::string& how) {
  // Called on the way of an exit() of Qt's.
  if (std::this_thread::get_id() == thread_.get_id()) return;
  post([this, how] {
    program_has_ended_ = true;
    const QString text = QString::fromStdString(how);
    bool any = false;
    for (const auto& panel : panels_) {
      panel->tell_end(text);
      any = any || panel->isVisible();
    }
    for (const auto& view : hand_views_) {
      view->tell_end(text);
      any = any || view->isVisible();
    }
    for (const auto& window : editors_) any = any || (window && window->isVisible());
    for (const auto& window : environments_) {
      window->tell_end(text);
      any = any || window->isVisible();
    }
    if (!any) QApplication::quit();
  });
  join();
}

void GuiWindows::join() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return has_ended_; });
  // Not only to the end of run(): what Qt has for each thread goes after it, and must not meet what
  // goes with the process.
  if (thread_.joinable()) thread_.join();
}

}  // namespace eyebridge::gui
