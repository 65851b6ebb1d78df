#pragma once

#include <QAction>
#include <QFileDialog>
#include <QInputDialog>
#include <QTest>
#include <optional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "code/code_window.hpp"
#include "run_program.hpp"

namespace eyebridge::gui::testing {

/// A code panel whose drafts and builds are in a folder of the test's own, and a person before it.
class CodeRoom : public ::testing::Test {
 protected:
  CodeRoom();
  /// Opens the window with these files and waits until it has the keyboard.
  void open(const QStringList& paths = {});
  /// Writes a file and gives its path.
  QString write(const std::string& name, const std::string& text);
  [[nodiscard]] QString path(const std::string& name) const;
  [[nodiscard]] std::string file(const std::string& name) const;

  [[nodiscard]] CodeWindow& window() { return *window_; }
  [[nodiscard]] Page& page() { return *window_->page(); }
  [[nodiscard]] Editor& editor() { return page().editor(); }
  [[nodiscard]] QString output() { return window_->output().toPlainText(); }
  /// Types into the editor; '\n' is Enter.
  void type(const QString& text);
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
  /// The menu's entry of this text, without its '&'.
  [[nodiscard]] QAction& action(const QString& text);
  /// The dialog that is open, whatever it is; it must come within a minute.
  template <class Dialog>
  Dialog& dialog() {
    Dialog* found = nullptr;
    const bool came = QTest::qWaitFor(
        [&] { return (found = window_->findChild<Dialog*>()) != nullptr && found->isVisible(); },
        60'000);
    if (!came) throw std::runtime_error("no dialog came");
    return *found;
  }
  /// Waits until the program has ended.
  void wait_for_end();
  /// Clicks the line of the output that has this in it.
  void click_output(const QString& text);
  void click_notice(const QString& button);

  eyebridge::testing::ScratchFolder folder_;
  CodeSettings settings_;
  std::optional<CodeWindow> window_;
};

}  // namespace eyebridge::gui::testing
