#pragma once

#include <QCoreApplication>
#include <QLabel>
#include <QMainWindow>
#include <QPointer>
#include <QTabWidget>
#include <QTimer>
#include <functional>

#include "code/code_settings.hpp"
#include "code/find_bar.hpp"
#include "code/output_view.hpp"
#include "code/page.hpp"
#include "code/recovery.hpp"
#include "code/run_bar.hpp"
#include "code/runner.hpp"
#include "code/templates.hpp"
#include "widgets/disk_watch.hpp"

namespace eyebridge::gui {

/// The code panel: programs in tabs, a button that builds and runs the one in front, what it
/// prints. Texts that were not saved when the last code panel crashed are there again. For the
/// windows' thread; no call but the last one, which waits for drafts, blocks, and no dialog holds
/// others up.
class CodeWindow final : public QMainWindow {
  Q_DECLARE_TR_FUNCTIONS(CodeWindow)
 public:
  /// Opens the files, or a template when there is nothing else to show.
  CodeWindow(const QStringList& paths, CodeSettings settings);
  ~CodeWindow() override;

  /// Each returns the text's page; open_file() null when it cannot be read, which the status bar
  /// says. A file that is open comes to the front.
  Page* open_file(const QString& path);
  /// Brings the file to the front if it is open; else false.
  bool show_file(const QString& path);
  Page* open_example(const QString& path);
  Page* new_program(const Template& begin);
  /// False when it could not be written: its notice bar says why.
  bool save_as(Page& page, const QString& path);
  /// Builds and runs the program in front, or only builds it. What has a file is saved before.
  void run(bool only_build = false);

  [[nodiscard]] Page* page() const;
  [[nodiscard]] int page_count() const { return tabs_->count(); }
  [[nodiscard]] QTabWidget& tabs() { return *tabs_; }
  [[nodiscard]] OutputView& output() { return *output_; }
  [[nodiscard]] RunBar& run_bar() { return *run_bar_; }
  [[nodiscard]] FindBar& find_bar() { return *find_bar_; }
  [[nodiscard]] Runner& runner() { return *runner_; }
  /// What the status bar says of the last run, or of the last thing that went wrong.
  [[nodiscard]] QString state() const { return state_->text(); }
  /// Keeps texts that are not saved; returns when they are on the disk.
  void keep_now();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  // code_menus.cpp
  QAction* add_action(QMenu& menu, const QString& text, const QList<QKeySequence>& keys,
                      const std::function<void()>& act);
  void add_edit_action(QMenu& menu, const QString& text, const QList<QKeySequence>& keys,
                       const std::function<void(Editor&)>& act);
  void make_file_menu();
  void make_edit_menu();
  void make_view_menu();
  void make_run_menu();
  void add_examples(QMenu& menu);
  void add_generations(QMenu& menu);
  void ask_for_line();

  // code_files.cpp
  [[nodiscard]] Page& page_at(int index) const;
  [[nodiscard]] Page* page_of(const QString& path) const;
  Page& add_page(const QString& name, const QString& text);
  Page& add_page(int number, const QString& name, const QString& text);
  void recover();
  void page_changed(Page& page);
  void show_titles();
  void keep_drafts();
  void tell_of_drafts();
  void ask_for_files();
  void save(Page& page, const std::function<void()>& then = {});
  void save_all(const std::function<void()>& then = {});
  void ask_where(Page& page, const std::function<void()>& then);
  void close_page(Page& page);
  void remove_page(Page& page);
  void ask_about_unsaved(const QStringList& names, const std::function<void()>& save,
                         const std::function<void()>& discard);
  /// Nobody looks at it any more, unless another page is of it.
  void leave_file(const QString& path);
  void disk_changed();

  // code_run.cpp
  [[nodiscard]] bool prepare(Page& page, ProgramSource& source);
  /// Where a text without a file is built.
  [[nodiscard]] QString copy_folder(const Page& page) const;
  void connect_runner();
  void message_came(const Message& message);
  void show_place(const Message& message);
  [[nodiscard]] Page* page_for(const QString& file, bool opens);
  void show_state();

  // code_window.cpp
  void make_parts();
  void show_place_of_cursor();
  void set_zoom(int zoom);

  const CodeSettings settings_;
  Recovery recovery_;
  QTabWidget* tabs_;
  FindBar* find_bar_;
  OutputView* output_;
  RunBar* run_bar_;
  Runner* runner_;
  QLabel* state_;
  QLabel* place_;
  QAction* run_ = nullptr;
  QAction* build_ = nullptr;
  QAction* stop_ = nullptr;
  QList<QKeySequence> keys_;  ///< Of all actions: the editors leave them.
  DiskWatch watch_;
  QTimer draft_timer_;
  int zoom_ = 0;
  QPointer<Page> ran_;  ///< What runs, or ran last …
  ProgramSource source_;
  bool is_closing_ = false;
};

}  // namespace eyebridge::gui
