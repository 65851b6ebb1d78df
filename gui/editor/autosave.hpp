#pragma once

#include <QLockFile>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

#include "editor/plan.hpp"

namespace eyebridge::gui {

/// Unsaved edits, kept in a folder of the user's (QStandardPaths' AppLocalDataLocation, editor/)
/// for the case that the process ends without a word.
class Autosave {
 public:
  /// For the file at `path`; empty: for a plan that has none yet. Locked against other editors
  /// while it lives.
  explicit Autosave(const std::filesystem::path& path);
  ~Autosave() = default;  // what is written stays

  /// False: another editor has this file open, and nothing is kept.
  [[nodiscard]] bool is_ours() const { return !file_.isEmpty(); }
  /// Whether an editor that ended without a word has left something.
  [[nodiscard]] bool has_left() const;
  /// What it left. Throws ConfigError when it cannot be read.
  [[nodiscard]] Plan left() const;
  /// Throws ConfigError when it cannot be written.
  void write(const Plan& plan);
  /// What was left, and cannot be read, gets another name: that one is returned.
  QString set_aside();
  /// Nothing is to be recovered any more.
  void drop();

 private:
  bool take(const QString& name);

  QString file_;
  std::unique_ptr<QLockFile> lock_;
};

}  // namespace eyebridge::gui
