#pragma once

#include <QByteArray>
#include <QElapsedTimer>
#include <QFileSystemWatcher>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace eyebridge::gui {

/// Files that others may change, too.
class DiskWatch {
 public:
  /// `on_change` is told when they are no longer as they were known, a moment after the last write,
  /// or a second after the first one.
  explicit DiskWatch(std::function<void()> on_change);

  /// From now on these; as they are now is how they are known. Empty names are left out.
  void follow(const std::vector<std::filesystem::path>& paths);
  /// This one, too, from now on, unless it is followed already; or no longer.
  void add(const std::filesystem::path& path);
  void leave(const std::filesystem::path& path);
  /// Those that are not as known.
  [[nodiscard]] std::vector<std::filesystem::path> changed() const;
  /// The same; as they were read for that is how they are known from now on.
  std::vector<std::filesystem::path> take_changed();
  [[nodiscard]] bool has_changed() const { return !changed().empty(); }
  /// As they are now is how they are known.
  void accept();

 private:
  void look();
  void watch();

  std::function<void()> on_change_;
  QFileSystemWatcher watcher_;
  QTimer moment_;
  QElapsedTimer first_;  ///< Since the first change that nobody was told of.
  std::map<std::filesystem::path, std::optional<QByteArray>> known_;  ///< None: not there.
};

}  // namespace eyebridge::gui
