// The menus of a panel: everything that its mouse can do, by the keyboard.

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

#include "panel/panel_window.hpp"
#include "widgets/save_picture.hpp"

namespace eyebridge::gui {

void PanelWindow::make_menus() {
  make_file_menu(*menuBar()->addMenu(tr("&File")));
  QMenu& view = *menuBar()->addMenu(tr("&View"));
  for (QDockWidget* dock : findChildren<QDockWidget*>()) view.addAction(dock->toggleViewAction());
  make_keys_menu(*menuBar()->addMenu(tr("&Keys")));
  make_remote_menu(*menuBar()->addMenu(tr("Re&mote")));
}

void PanelWindow::make_file_menu(QMenu& menu) {
  QAction* const save = menu.addAction(tr("&Save screen..."), this, [this] { ask_for_picture(); });
  save->setShortcut(QKeySequence::Save);
  menu.addSeparator();
  QAction* const close = menu.addAction(tr("&Close"), this, [this] { this->close(); });
  close->setShortcut(QKeySequence::Close);
}

void PanelWindow::make_keys_menu(QMenu& menu) {
  for (int i = 0; i < robios::kSoftKeys; ++i) {
    // Named, not set: keyPressEvent() takes them, whatever has the focus.
    QAction* const key =
        menu.addAction(tr("KEY&%1\t%1 or F%1").arg(i + 1), this, [this, i] { press(i); });
    key->setProperty("sends", true);
  }
}

void PanelWindow::make_remote_menu(QMenu& menu) {
  for (const RemoteButton& button : remote_buttons()) {
    QAction* const key = menu.addAction(QString("IRTV_%1").arg(button.name), this,
                                        [this, &button] { remote_->press(button.code); });
    key->setShortcut(QKeySequence(button.shortcut));
    key->setProperty("sends", true);
  }
}

void PanelWindow::ask_for_picture() {
  ask_where_to_save_picture(*this, tr("Save screen"), "screen.png",
                            [this](const QString& path) { save_screen(path); });
}

}  // namespace eyebridge::gui
