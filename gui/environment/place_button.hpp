#pragma once

#include <QCoreApplication>
#include <QPushButton>

namespace eyebridge::gui {

/// Stays down while a person is to show by mouse where something shall stand.
class PlaceButton final : public QPushButton {
  Q_DECLARE_TR_FUNCTIONS(PlaceButton)
 public:
  PlaceButton(const char* name, QWidget* parent) : QPushButton(parent) {
    setText(tr("Show its place with the mouse"));
    setToolTip(tr("Press where it shall stand, and drag to where it shall look"));
    setObjectName(name);
    setCheckable(true);
  }
};

}  // namespace eyebridge::gui
