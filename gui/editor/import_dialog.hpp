#pragma once

#include <QCoreApplication>
#include <QDialog>
#include <functional>

#include "editor/floor_plan.hpp"

namespace eyebridge::gui {

/// Asks for the picture of a floor plan and how it is to be read.
class ImportDialog final : public QDialog {
  Q_DECLARE_TR_FUNCTIONS(ImportDialog)

 public:
  explicit ImportDialog(QWidget* parent);

  /// Told when a person has chosen.
  std::function<void(const QString& picture, const files::FloorPlanOptions& options, bool replaces)>
      on_choice;
};

}  // namespace eyebridge::gui
