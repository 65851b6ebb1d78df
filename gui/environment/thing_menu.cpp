// What can be done with a thing, as a person at the environment's window asks for it.
#include <QAction>
#include <QInputDialog>
#include <QMenu>

#include "environment/environment_window.hpp"

namespace eyebridge::gui {

void EnvironmentWindow::show_thing_menu(QPoint place, int number) {
  auto* const menu = new QMenu(this);
  menu->setObjectName("thing_menu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  connect(menu->addAction(tr("&Change...")), &QAction::triggered, this,
          [this, number] { ask_for_change(number); });
  connect(menu->addAction(tr("&Remove")), &QAction::triggered, this, [this, number] {
    tell(environment_.control().remove_object(number), tr("Object %1 is gone").arg(number));
  });
  menu->popup(place);
}

void EnvironmentWindow::ask_for_change(int number) {
  auto* const dialog = new QInputDialog(this);
  dialog->setObjectName("change");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setOption(QInputDialog::UsePlainTextEditForTextInput);
  dialog->setWindowTitle(tr("Object %1").arg(number));
  dialog->setLabelText(
      tr("From now on, a line each: mass KG, friction MU, restitution E, fixed, loose, "
         "path MM/S loop|back x1 y1 ..., follow MM/S, flee MM/S, wander MM/S, "
         "yields MM, still"));
  connect(dialog, &QInputDialog::textValueSelected, this, [this, number](const QString& lines) {
    tell(environment_.control().change_object(number, lines.toStdString()),
         tr("Object %1 has changed").arg(number));
  });
  dialog->open();
}

void EnvironmentWindow::tell(const Result<void>& done, const QString& what) {
  tell(done ? what : QString::fromStdString(done.error().what));
}

}  // namespace eyebridge::gui
