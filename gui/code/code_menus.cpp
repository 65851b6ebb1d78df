// The menus of the code panel.
#include <QDockWidget>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenuBar>
#include <map>

#include "code/code_window.hpp"
#include "code/examples.hpp"
#include "widgets/recent_files.hpp"

namespace eyebridge::gui {

QAction* CodeWindow::add_action(QMenu& menu, const QString& text, const QList<QKeySequence>& keys,
                                const std::function<void()>& act) {
  QAction* const action = menu.addAction(text);
  action->setShortcuts(keys);
  keys_ << keys;
  connect(action, &QAction::triggered, this, [act] { act(); });
  return action;
}

void CodeWindow::add_edit_action(QMenu& menu, const QString& text, const QList<QKeySequence>& keys,
                                 const std::function<void(Editor&)>& act) {
  add_action(menu, text, keys, [this, act] {
    if (page() != nullptr) act(page()->editor());
  });
}

void CodeWindow::make_file_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&File"));
  QMenu& fresh = *menu.addMenu(tr("&New"));
  const std::map<Language, std::pair<QString, QKeySequence>> kinds{
      {Language::C, {tr("&C program"), QKeySequence(Qt::CTRL | Qt::Key_N)}},
      {Language::Cpp, {tr("C&++ program"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N)}},
      {Language::Python, {tr("&Python program"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_N)}}};
  for (const Template& begin : templates()) {
    const auto& [text, key] = kinds.at(begin.language);
    add_action(fresh, text, {key}, [this, begin] { new_program(begin); });
  }
  add_action(menu, tr("&Open..."), {QKeySequence::Open}, [this] { ask_for_files(); });
  offer_recent_files(*menu.addMenu(tr("Open &recent")), {kRecentPrograms},
                     [this](const QString& path) { open_file(path); });
  add_examples(*menu.addMenu(tr("&Examples")));
  menu.addSeparator();
  add_action(menu, tr("&Save"), {QKeySequence::Save}, [this] {
    if (page() != nullptr) save(*page());
  });
  add_action(menu, tr("Save &as..."), {Qt::CTRL | Qt::SHIFT | Qt::Key_S}, [this] {
    if (page() != nullptr) ask_where(*page(), {});
  });
  add_action(menu, tr("Save a&ll"), {Qt::CTRL | Qt::ALT | Qt::Key_S}, [this] { save_all(); });
  menu.addSeparator();
  add_action(menu, tr("&Close tab"), {Qt::CTRL | Qt::Key_W}, [this] {
    if (page() != nullptr) close_page(*page());
  });
  add_action(menu, tr("Close &window"), {Qt::CTRL | Qt::Key_Q}, [this] { close(); });
}

void CodeWindow::add_examples(QMenu& menu) {
  std::map<QString, QMenu*> folders;
  for (const Example& example : find_examples(settings_.examples)) {
    const QString folder = QFileInfo(example.name).path();
    QMenu*& place = folders[folder];
    if (place == nullptr) place = folder == "." ? &menu : menu.addMenu(folder);
    add_action(*place, QFileInfo(example.name).fileName(), {},
               [this, path = example.path] { open_example(path); });
  }
  menu.setEnabled(!menu.isEmpty());
}

void CodeWindow::make_edit_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&Edit"));
  add_edit_action(menu, tr("&Undo"), {QKeySequence::Undo}, [](Editor& e) { e.undo(); });
  add_edit_action(menu, tr("&Redo"), {Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y},
                  [](Editor& e) { e.redo(); });
  menu.addSeparator();
  add_edit_action(menu, tr("Cu&t"), {QKeySequence::Cut}, [](Editor& e) { e.cut(); });
  add_edit_action(menu, tr("&Copy"), {QKeySequence::Copy}, [](Editor& e) { e.copy(); });
  add_edit_action(menu, tr("&Paste"), {QKeySequence::Paste}, [](Editor& e) { e.paste(); });
  add_edit_action(menu, tr("Select &all"), {QKeySequence::SelectAll},
                  [](Editor& e) { e.selectAll(); });
  menu.addSeparator();
  add_action(menu, tr("&Find..."), {QKeySequence::Find}, [this] { find_bar_->open(false); });
  add_action(menu, tr("R&eplace..."), {Qt::CTRL | Qt::Key_H}, [this] { find_bar_->open(true); });
  add_action(menu, tr("Find &next"), {Qt::Key_F3}, [this] { find_bar_->find_next(); });
  add_action(menu, tr("Find pre&vious"), {Qt::SHIFT | Qt::Key_F3},
             [this] { find_bar_->find_previous(); });
  add_action(menu, tr("&Go to line..."), {Qt::CTRL | Qt::Key_G}, [this] { ask_for_line(); });
  add_edit_action(menu, tr("&Matching brace"), {Qt::CTRL | Qt::Key_M},
                  [](Editor& e) { e.moveToMatchingBrace(); });
  menu.addSeparator();
  add_edit_action(menu, tr("C&omment or uncomment"), {Qt::CTRL | Qt::Key_Slash},
                  [](Editor& e) { e.toggle_comment(); });
  add_edit_action(menu, tr("Com&plete"), {Qt::CTRL | Qt::Key_Space},
                  [](Editor& e) { e.autoCompleteFromAll(); });
  add_edit_action(menu, tr("&How it is called"), {Qt::CTRL | Qt::SHIFT | Qt::Key_Space},
                  [](Editor& e) { e.callTip(); });
}

void CodeWindow::ask_for_line() {
  if (page() == nullptr) return;
  auto* const dialog = new QInputDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Go to line"));
  dialog->setLabelText(tr("Line:"));
  dialog->setInputMode(QInputDialog::IntInput);
  dialog->setIntRange(1, page()->editor().lines());
  dialog->setIntValue(page()->editor().line());
  connect(dialog, &QInputDialog::intValueSelected, page(), [page = page()](int line) {
    page->editor().go_to(line, 1);
    page->editor().setFocus();
  });
  dialog->open();
}

void CodeWindow::make_view_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&View"));
  add_action(menu, tr("Zoom &in"), {QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")},
             [this] { set_zoom(zoom_ + 1); });
  add_action(menu, tr("Zoom &out"), {QKeySequence("Ctrl+-")}, [this] { set_zoom(zoom_ - 1); });
  add_action(menu, tr("&Usual size"), {QKeySequence("Ctrl+0")}, [this] { set_zoom(0); });
  menu.addSeparator();
  add_edit_action(menu, tr("&Fold or unfold all"), {Qt::CTRL | Qt::ALT | Qt::Key_F},
                  [](Editor& e) { e.foldAll(); });
  add_edit_action(menu, tr("Fold or unfold &here"), {Qt::CTRL | Qt::ALT | Qt::Key_H},
                  [](Editor& e) { e.foldLine(e.line() - 1); });
  menu.addSeparator();
  add_action(menu, tr("&Next tab"), {Qt::CTRL | Qt::Key_PageDown}, [this] {
    if (page() != nullptr) tabs_->setCurrentIndex((tabs_->currentIndex() + 1) % page_count());
  });
  add_action(menu, tr("&Previous tab"), {Qt::CTRL | Qt::Key_PageUp}, [this] {
    if (page() != nullptr) {
      tabs_->setCurrentIndex((tabs_->currentIndex() + page_count() - 1) % page_count());
    }
  });
  menu.addSeparator();
  QAction* const output = findChild<QDockWidget*>("output_dock")->toggleViewAction();
  output->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_U);
  keys_ << output->shortcut();
  menu.addAction(output);
  menu.addAction(run_bar_->toggleViewAction());
}

void CodeWindow::make_run_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&Run"));
  run_ = add_action(menu, tr("&Run"), {Qt::Key_F5}, [this] { run(); });
  stop_ = add_action(menu, tr("&Stop"), {Qt::SHIFT | Qt::Key_F5}, [this] { runner_->stop(); });
  build_ = add_action(menu, tr("&Build"), {Qt::CTRL | Qt::Key_B}, [this] { run(true); });
  menu.addSeparator();
  add_action(menu, tr("&Next message"), {Qt::Key_F8}, [this] { output_->choose_next(true); });
  add_action(menu, tr("&Previous message"), {Qt::SHIFT | Qt::Key_F8},
             [this] { output_->choose_next(false); });
  menu.addSeparator();
  add_action(menu, tr("&World..."), {Qt::CTRL | Qt::SHIFT | Qt::Key_W},
             [this] { run_bar_->ask_for_world(); });
  add_action(menu, tr("&Virtual time or real time"), {Qt::CTRL | Qt::SHIFT | Qt::Key_T},
             [this] { run_bar_->fast().toggle(); });
  add_action(menu, tr("W&indows or none"), {Qt::CTRL | Qt::SHIFT | Qt::Key_G},
             [this] { run_bar_->windows().toggle(); });
  add_generations(*menu.addMenu(tr("R&oBIOS of this program")));
}

void CodeWindow::add_generations(QMenu& menu) {
  const auto add = [&](const QString& text, std::optional<bool> classic, Qt::Key key) {
    add_edit_action(menu, text, {Qt::CTRL | Qt::ALT | key}, [this, classic](Editor& editor) {
      editor.set_classic(classic);
      show_place_of_cursor();
    });
  };
  add(tr("&As it looks"), {}, Qt::Key_0);
  add(tr("RoBIOS-&7"), false, Qt::Key_7);
  add(tr("&Classic RoBIOS"), true, Qt::Key_8);
}

}  // namespace eyebridge::gui
