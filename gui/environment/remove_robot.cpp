// How a robot leaves a run, as a person at the environment's window asks for it.
#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QThreadPool>

#include "environment/environment_window.hpp"

namespace eyebridge::gui {

void EnvironmentWindow::make_removal(QMenu& menu) {
  menu.setToolTipsVisible(true);
  remove_ = add_action(menu, tr("&Remove..."), QKeySequence::Delete, [this] { ask_to_remove(); });
  remove_->setToolTip(crew_ != nullptr
                          ? tr("Ends the chosen robot's program and takes it out of the world")
                          : tr("Robots cannot be removed from a run of this kind"));
}

void EnvironmentWindow::show_robot_menu(QPoint place) {
  auto* const menu = new QMenu(this);
  menu->setObjectName("robot_menu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  remove_->setEnabled(crew_ != nullptr && view_->chosen().has_value());
  menu->addActions({centre_, follow_, drive_});
  menu->addSeparator();
  menu->addAction(remove_);
  menu->popup(place);
}

void EnvironmentWindow::ask_to_remove() {
  if (crew_ == nullptr || !view_->chosen() || findChild<QMessageBox*>("removal") != nullptr) return;
  const std::size_t robot = *view_->chosen();
  auto* const box = new QMessageBox(
      QMessageBox::Question, tr("Remove robot"),
      tr("Remove robot %1? Its program ends and its results are written. This cannot be undone.")
          .arg(robot + 1),
      QMessageBox::Cancel, this);
  box->setObjectName("removal");
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* const yes = box->addButton(tr("&Remove"), QMessageBox::AcceptRole);
  box->setDefaultButton(yes);
  connect(yes, &QPushButton::clicked, this, [this, robot] { remove_robot(robot); });
  box->open();
}

void EnvironmentWindow::remove_robot(std::size_t index) {
  trouble_->setText(environment_.time().is_paused()
                        ? tr("Robot %1 goes when time goes on, in virtual time").arg(index + 1)
                        : QString());
  // Not here: it takes as long as its program takes to end, and a run in virtual time that is
  // paused answers when it goes on.
  QThreadPool::globalInstance()->start([crew = crew_, index, window = QPointer(this)] {
    const Result<void> done = crew->remove(index);
    const QString answer = done ? tr("Robot %1 has been removed").arg(index + 1)
                                : QString::fromStdString(done.error().what);
    QMetaObject::invokeMethod(
        qApp,
        [window, answer] {
          if (window) window->tell(answer);
        },
        Qt::QueuedConnection);
  });
}

}  // namespace eyebridge::gui
