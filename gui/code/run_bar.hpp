#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QToolBar>

#include "code/code_settings.hpp"
#include "code/run_plan.hpp"

namespace eyebridge::gui {

/// In which world a program shall run, and how. Remembers what was chosen last.
class RunBar final : public QToolBar {
  Q_DECLARE_TR_FUNCTIONS(RunBar)
 public:
  RunBar(const CodeSettings& settings, QWidget* parent);
  ~RunBar() override;

  /// What the bar has: the two actions, which get pictures, and the choices.
  void add_parts(QAction& run, QAction& stop);
  [[nodiscard]] RunChoice choice() const;
  /// Chooses a world file, which joins the list if it is not in it; "" is an empty room.
  void choose_world(const QString& path);
  void ask_for_world();
  [[nodiscard]] QComboBox& worlds() { return *worlds_; }
  [[nodiscard]] QCheckBox& fast() { return *fast_; }
  [[nodiscard]] QCheckBox& windows() { return *windows_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void paint_actions();

  QAction* run_ = nullptr;
  QAction* stop_ = nullptr;
  QString folder_;
  QComboBox* worlds_;
  QCheckBox* fast_;
  QCheckBox* windows_;
};

}  // namespace eyebridge::gui
