#pragma once

#include <QCoreApplication>
#include <QMainWindow>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "editor/autosave.hpp"
#include "editor/canvas.hpp"
#include "editor/document.hpp"
#include "editor/floor_plan.hpp"
#include "editor/plan_files.hpp"
#include "editor/property_panel.hpp"
#include "widgets/disk_watch.hpp"
#include "widgets/notice_bar.hpp"

class QActionGroup;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QMenu;

namespace eyebridge::gui {

/// The world editor: draws worlds, mazes and simulations, and keeps their files.
class EditorWindow final : public QMainWindow {
  Q_DECLARE_TR_FUNCTIONS(EditorWindow)

 public:
  /// What a person says when unsaved edits would go.
  enum class Answer { Save, Discard, Cancel };

  /// Opens the .wld, .maz or .sim at `path`; empty: a new world of 4 x 4 m with four outer walls.
  /// What cannot be read is told of in the window, which then has a new world.
  explicit EditorWindow(const QString& path);
  ~EditorWindow() override;

  [[nodiscard]] Document& document() { return document_; }
  [[nodiscard]] Canvas& canvas() { return *canvas_; }
  [[nodiscard]] NoticeBar& notices() { return *notices_; }
  [[nodiscard]] PropertyPanel& properties() { return *properties_; }
  /// Empty: none yet.
  [[nodiscard]] QString path() const;

  /// Instead of what there is, without asking; false, and a notice, when it cannot be read.
  bool open(const QString& path);
  void make_new();
  /// To its file; asks for one where it has none. False, and a notice, when that failed.
  bool save();
  /// The ending says the kind.
  bool save_as(const QString& path);
  /// Adds the walls of a picture, or puts them in the place of those there are.
  bool import_floor_plan(const QString& picture, const files::FloorPlanOptions& options,
                         bool replaces);
  /// Robots of a .robi file, or objects of an .esObj file, can be placed then.
  bool add_description(const QString& path);
  /// Takes the files as they are on the disk now, as a step that can be undone.
  void reload();
  /// To the question that closing, opening or a new world with unsaved edits asks; nothing when
  /// there is none.
  void answer(Answer answer);
  /// Milliseconds from an edit to its autosave.
  void set_autosave_delay(int ms) { autosave_timer_.setInterval(ms); }
  /// Keeps edits that are not saved; returns when they are on the disk.
  void keep_now();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  QAction* add_action(QMenu& menu, const QString& text, const QKeySequence& key,
                      const std::function<void()>& act);
  void make_file_menu();
  void make_edit_menu();
  void make_tool_menu();
  void make_view_menu();
  void make_choices();
  void make_status();
  void refresh();
  void take(PlanFiles files);
  void show_files();
  void show_catalogue();
  void show_texture();
  void select_next(int by);
  void ask_for_description();
  void tell_warnings();

  /// Does `act` now, or when a person has said what becomes of unsaved edits.
  void when_free(std::function<void()> act);
  void ask_for_path();
  void ask_to_open();
  void ask_for_picture();
  bool write(const QString& path);
  void check_run();
  void disk_changed();
  void offer_left();
  void keep_edits();
  void edits_were_kept(const QString& why_not);
  void take_autosave();
  /// Forgets what was kept of our edits; not what another editor left, while nobody has answered.
  void drop_own();

  void copy();
  void paste(Vec2 by);

  PlanFiles files_;
  Document document_;
  Canvas* canvas_ = nullptr;
  PropertyPanel* properties_ = nullptr;
  NoticeBar* notices_ = nullptr;
  QActionGroup* tools_ = nullptr;
  QComboBox* things_ = nullptr;
  QComboBox* robots_ = nullptr;
  QDoubleSpinBox* grid_ = nullptr;
  QLabel* pointer_ = nullptr;
  QLabel* message_ = nullptr;
  std::function<void()> waiting_;  ///< For an answer.
  Plan clip_;                      ///< What was copied.
  Catalogue catalogue_;
  files::SimFile described_;             ///< Whose files the catalogue has.
  std::optional<std::string> textured_;  ///< What the canvas shows on the floor.
  std::unique_ptr<Autosave> autosave_;
  QTimer autosave_timer_;
  DiskWatch watch_;
};

}  // namespace eyebridge::gui
