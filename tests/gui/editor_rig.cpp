#include "editor_rig.hpp"

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>

namespace eyebridge::gui::testing {

void EditorRig::SetUp() {
  data_home_ = qgetenv("XDG_DATA_HOME");
  qputenv("XDG_DATA_HOME", QByteArray::fromStdString(folder_.path() + "/state"));
}

void EditorRig::TearDown() {
  window_.reset();
  if (data_home_.isNull()) {
    qunsetenv("XDG_DATA_HOME");
  } else {
    qputenv("XDG_DATA_HOME", data_home_);
  }
}

void EditorRig::open(const QString& path) {
  window_.reset();
  window_ = std::make_unique<EditorWindow>(path);
  window_->set_autosave_delay(10);
  window_->resize(1100, 850);
  window_->show();
  window_->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
  window_->canvas().fit();
}

QString EditorRig::file(const std::string& name) const {
  return QString::fromStdString(folder_.path() + "/" + name);
}

std::string EditorRig::text_of(const std::string& name) const {
  return eyebridge::testing::file_text(folder_.path() + "/" + name);
}

QPoint EditorRig::at(double x, double y) const {
  return window_->canvas().viewport().to_pixel({x, y}).toPoint();
}

void EditorRig::click(QPoint place, Qt::KeyboardModifiers keys) {
  QTest::mouseClick(&window_->canvas(), Qt::LeftButton, keys, place);
}

void EditorRig::double_click(QPoint place, Qt::KeyboardModifiers keys) {
  QTest::mouseDClick(&window_->canvas(), Qt::LeftButton, keys, place);
}

void EditorRig::drag(QPoint from, QPoint to, Qt::KeyboardModifiers keys, Qt::MouseButton button) {
  Canvas& canvas = window_->canvas();
  QTest::mousePress(&canvas, button, keys, from);
  for (int i = 1; i <= 10; ++i) {
    const QPoint place = from + (to - from) * i / 10.0;
    QMouseEvent move(QEvent::MouseMove, place, canvas.mapToGlobal(place), Qt::NoButton, button,
                     keys);
    QApplication::sendEvent(&canvas, &move);
  }
  QTest::mouseRelease(&canvas, button, keys, to);
}

void EditorRig::press_key(int key, Qt::KeyboardModifiers keys) {
  QTest::keyClick(&window_->canvas(), static_cast<Qt::Key>(key), keys);
}

QAction& EditorRig::action(const QString& text) {
  for (QAction* action : window_->findChildren<QAction*>()) {
    if (action->text().remove('&') == text) return *action;
  }
  throw std::runtime_error("no action " + text.toStdString());
}

void EditorRig::answer_notice(const QString& text) {
  for (QPushButton* button : window_->notices().findChildren<QPushButton*>()) {
    if (button->text() != text || !button->isVisible()) continue;
    QTest::mouseClick(button, Qt::LeftButton);
    return;
  }
  throw std::runtime_error("no button " + text.toStdString());
}

QString EditorRig::message() { return window_->findChild<QLabel*>("message")->text(); }

}  // namespace eyebridge::gui::testing
