#pragma once

#include <QPoint>
#include <memory>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "editor/editor_window.hpp"
#include "run_program.hpp"

class QAction;

namespace eyebridge::gui::testing {

/// A world editor at the display, whose files are in a folder of the test's own.
class EditorRig : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  /// Empty: a new world.
  void open(const QString& path);
  /// `name` in the test's folder.
  [[nodiscard]] QString file(const std::string& name) const;
  [[nodiscard]] std::string text_of(const std::string& name) const;

  /// Of the canvas, where this place is, metres.
  [[nodiscard]] QPoint at(double x, double y) const;
  void click(QPoint place, Qt::KeyboardModifiers keys = {});
  void double_click(QPoint place, Qt::KeyboardModifiers keys = {});
  void drag(QPoint from, QPoint to, Qt::KeyboardModifiers keys = {},
            Qt::MouseButton button = Qt::LeftButton);
  void press_key(int key, Qt::KeyboardModifiers keys = {});
  QAction& action(const QString& text);
  /// Presses the button with this text in the notices.
  void answer_notice(const QString& text);
  [[nodiscard]] const Plan& plan() { return window_->document().settled(); }
  [[nodiscard]] QString message();

  eyebridge::testing::ScratchFolder folder_;
  std::unique_ptr<EditorWindow> window_;
  QByteArray data_home_;
};

}  // namespace eyebridge::gui::testing
