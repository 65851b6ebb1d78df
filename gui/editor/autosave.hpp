#pragma once

#include <QLockFile>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>

#include "editor/plan.hpp"
#include "widgets/file_keeper.hpp"

namespace eyebridge::gui {

/// Unsaved edits, kept in a folder of the user's (QStandardPaths' AppLocalDataLocation, editor/)
/// for the case that the process ends without a word.
class Autosave {
 public:
  /// For the file at `path`; empty: for a plan that has none yet. Locked against other editors
  /// while it lives. `on_written` is told, by this thread's event loop, of each time that edits
  /// were kept, with why they could not be, else "".
  Autosave(const std::filesystem::path& path,
           const std::function<void(const QString& why)>& on_written);
  ~Autosave() = default;  // what is written stays; returns when it is on the disk

  /// False: another editor has this file open, and nothing is kept.
  [[nodiscard]] bool is_ours() const { return !file_.isEmpty(); }
  /// Whether an editor that ended without a word has left something.
  [[nodiscard]] bool has_left() const { return is_there_; }
  /// What it left. Throws ConfigError when it cannot be read.
  [[nodiscard]] Plan left() const;
  /// Soon, in another thread, which waits for the disk. Throws ConfigError where no file can hold
  /// the plan.
  void write(const Plan& plan);
  /// What was left, and cannot be read, gets another name: that one is returned; empty where the
  /// disk refuses.
  QString set_aside();
  /// Nothing is to be recovered any more.
  void drop();
  /// Returns when all is on the disk.
  void finish() { files_.finish(); }

 private:
  bool take(const QString& name);

  QString file_;
  bool is_there_ = false;  ///< The file, or it has been asked for.
  std::unique_ptr<QLockFile> lock_;
  FileKeeper files_;
};

}  // namespace eyebridge::gui
