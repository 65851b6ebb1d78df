#include "editor/disk_watch.hpp"

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <utility>

namespace eyebridge::gui {
namespace {

constexpr int kMoment_ms = 100;  // editors write in several steps

std::optional<QByteArray> bytes_of(const std::filesystem::path& path) {
  QFile file(QString::fromStdString(path.string()));
  if (!file.open(QIODevice::ReadOnly)) return {};
  return file.readAll();
}

}  // namespace

DiskWatch::DiskWatch(std::function<void()> on_change) : on_change_(std::move(on_change)) {
  moment_.setSingleShot(true);
  moment_.setInterval(kMoment_ms);
  QObject::connect(&moment_, &QTimer::timeout, [this] { look(); });
  const auto wait = [this] { moment_.start(); };
  QObject::connect(&watcher_, &QFileSystemWatcher::fileChanged, &moment_, wait);
  QObject::connect(&watcher_, &QFileSystemWatcher::directoryChanged, &moment_, wait);
}

void DiskWatch::follow(const std::vector<std::filesystem::path>& paths) {
  known_.clear();
  for (const auto& path : paths) {
    if (!path.empty()) known_[path] = {};
  }
  accept();
}

void DiskWatch::accept() {
  for (auto& [path, bytes] : known_) bytes = bytes_of(path);
  watch();
}

bool DiskWatch::has_changed() const {
  return std::ranges::any_of(known_,
                             [](const auto& file) { return bytes_of(file.first) != file.second; });
}

void DiskWatch::look() {
  watch();
  if (has_changed()) on_change_();
}

void DiskWatch::watch() {
  // A file that was replaced is another one to the system: its folder tells of that.
  const QStringList old = watcher_.files() + watcher_.directories();
  if (!old.isEmpty()) watcher_.removePaths(old);
  for (const auto& [path, bytes] : known_) {
    const QFileInfo info(QString::fromStdString(path.string()));
    if (info.exists()) watcher_.addPath(info.absoluteFilePath());
    watcher_.addPath(info.absolutePath());
  }
}

}  // namespace eyebridge::gui
