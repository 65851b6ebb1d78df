#include "code_room.hpp"

#include <QFile>
#include <QMenu>
#include <QPushButton>
#include <QTextBlock>
#include <QTextDocument>
#include <stdexcept>

namespace eyebridge::gui::testing {
namespace {

// Compilers on a busy computer.
constexpr int kBuildPatience_ms = 60'000;

}  // namespace

CodeRoom::CodeRoom() : settings_(CodeSettings::defaults()) {
  settings_.drafts = path("drafts");
  settings_.builds = path("builds");
#ifdef EYEBRIDGE_TEST_PRELOAD
  // Python was built without the sanitizers that are in our libraries: they have to be there first.
  const QString script =
      write("eyebridge.sh", "#!/bin/sh\nLD_PRELOAD='" EYEBRIDGE_TEST_PRELOAD
                            "' ASAN_OPTIONS=detect_leaks=0 exec '" +
                                settings_.eyebridge.toStdString() + "' \"$@\"\n");
  QFile(script).setPermissions(QFile::ReadOwner | QFile::ExeOwner);
  settings_.eyebridge = script;
#endif
}

void CodeRoom::open(const QStringList& paths) {
  window_.emplace(paths, settings_);
  window_->resize(1000, 800);
  window_->show();
  window_->activateWindow();
  if (!QTest::qWaitForWindowActive(&*window_)) throw std::runtime_error("the window is not active");
}

QString CodeRoom::path(const std::string& name) const {
  return QString::fromStdString(folder_.path() + "/" + name);
}

QString CodeRoom::write(const std::string& name, const std::string& text) {
  return QString::fromStdString(folder_.write(name, text));
}

std::string CodeRoom::file(const std::string& name) const {
  return eyebridge::testing::file_text(folder_.path() + "/" + name);
}

void CodeRoom::type(const QString& text) {
  for (const QChar c : text) {
    if (c == '\n') {
      QTest::keyClick(&editor(), Qt::Key_Return);
    } else {
      QTest::keyClick(&editor(), c.toLatin1());
    }
    // The editor is drawn, and what it knows of the text follows.
    QApplication::processEvents();
  }
}

void CodeRoom::press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  QWidget* const focus = QApplication::focusWidget();
  QTest::keyClick(focus == nullptr ? &*window_ : focus, key, modifiers);
}

QAction& CodeRoom::action(const QString& text) {
  for (QAction* const action : window_->findChildren<QAction*>()) {
    if (action->menu() == nullptr && action->text().remove('&') == text) return *action;
  }
  throw std::runtime_error("no action " + text.toStdString());
}

void CodeRoom::wait_for_end() {
  const bool ended = QTest::qWaitFor(
      [&] { return window_->runner().state() == Runner::State::Idle; }, kBuildPatience_ms);
  if (!ended) throw std::runtime_error("it runs on: " + output().toStdString());
}

void CodeRoom::click_output(const QString& text) {
  OutputView& view = window_->output();
  view.flush();
  QTextBlock block = view.document()->firstBlock();
  while (block.isValid() && !block.text().contains(text)) block = block.next();
  if (!block.isValid())
    throw std::runtime_error("no " + text.toStdString() + " in\n" + output().toStdString());
  QTextCursor cursor(block);
  cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::MoveAnchor, 3);
  view.setTextCursor(cursor);
  view.ensureCursorVisible();
  QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, view.cursorRect(cursor).center());
}

void CodeRoom::click_notice(const QString& button) {
  for (QPushButton* const choice : page().notice().findChildren<QPushButton*>()) {
    if (choice->isVisible() && choice->text() == button) {
      QTest::mouseClick(choice, Qt::LeftButton);
      return;
    }
  }
  throw std::runtime_error("no button " + button.toStdString());
}

}  // namespace eyebridge::gui::testing
