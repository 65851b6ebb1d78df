#pragma once

#include <QCoreApplication>
#include <QWidget>
#include <functional>
#include <vector>

#include "code/editor.hpp"
#include "code/recovery.hpp"
#include "code/text_file.hpp"
#include "widgets/notice_bar.hpp"

namespace eyebridge::gui {

/// A text in the code panel: its editor, its file, and the bar that tells what became of the file.
class Page final : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(Page)
 public:
  static constexpr const char* kTopic = "file";  ///< Of all notices.

  /// A new text without a file, which will be called `name`.
  Page(int number, const QString& name, const QString& text, QWidget* parent);

  /// Reads a file. Returns "" or why it cannot be read, and nothing has changed then.
  [[nodiscard]] QString open(const QString& path);
  /// The text of an example as one without a file: it is never written where it was read.
  [[nodiscard]] QString open_copy(const QString& path);
  /// The file of a text that was recovered: it counts as changed.
  void restore(const Draft& draft);
  /// Writes the text. When the file has changed on disk meanwhile, or cannot be written, the notice
  /// bar says so and the answer is false.
  [[nodiscard]] bool save();
  [[nodiscard]] bool save_as(const QString& path);
  /// Looks whether the file on disk is still the one that was read or written.
  void look_at_disk();

  [[nodiscard]] Editor& editor() { return *editor_; }
  /// Says something about the file, in the place of what was said before; a person can put it away.
  void tell(const QString& text, std::vector<NoticeBar::Answer> answers);
  [[nodiscard]] NoticeBar& notice() { return *notice_; }
  /// "" until the text has a file.
  [[nodiscard]] const QString& path() const { return path_; }
  [[nodiscard]] const QString& name() const { return name_; }
  /// The example that this is a copy of; "" when it is none, or has been saved.
  [[nodiscard]] const QString& example() const { return example_; }
  [[nodiscard]] bool is_modified() const { return is_unsaved_ || editor_->isModified(); }
  [[nodiscard]] Draft draft() const { return {number_, name_, path_, editor_->text()}; }
  [[nodiscard]] int number() const { return number_; }

  /// Called when it has another file, or was changed or saved.
  std::function<void()> on_change;
  /// Called when a person wants to choose another file for the text.
  std::function<void()> on_save_as;

 private:
  void set_path(const QString& path);
  [[nodiscard]] bool write(const QString& path);
  void reload();

  const int number_;
  QString name_;
  QString path_;
  QString example_;
  TextFile file_;
  bool was_removed_ = false;
  bool is_unsaved_ = false;  ///< Though nothing was typed: its file is gone, or it was recovered.
  NoticeBar* notice_;
  Editor* editor_;
};

}  // namespace eyebridge::gui
