#include "widgets/disk_watch.hpp"

#include <QFile>
#include <QFileInfo>
#include <utility>

namespace eyebridge::gui {
namespace {

constexpr int kMoment_ms = 100;          // editors write in several steps
constexpr int kLongest_ms = 1000;        // of writes without a moment between them
constexpr qint64 kMostBytes = 64 << 20;  // no file of ours has more

std::optional<QByteArray> bytes_of(const std::filesystem::path& path) {
  QFile file(QString::fromStdString(path.string()));
  // A pipe that took its place would keep us waiting.
  if (!QFileInfo(file).isFile()) return {};
  if (!file.open(QIODevice::ReadOnly)) return {};
  return file.read(kMostBytes);
}

}  // namespace

DiskWatch::DiskWatch(std::function<void()> on_change) : on_change_(std::move(on_change)) {
  moment_.setSingleShot(true);
  moment_.setInterval(kMoment_ms);
  QObject::connect(&moment_, &QTimer::timeout, [this] { look(); });
  const auto wait = [this] {
    if (!moment_.isActive()) first_.start();
    if (first_.elapsed() < kLongest_ms) moment_.start();
  };
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

void DiskWatch::add(const std::filesystem::path& path) {
  if (path.empty() || known_.contains(path)) return;
  known_[path] = bytes_of(path);
  watch();
}

void DiskWatch::leave(const std::filesystem::path& path) {
  if (known_.erase(path) != 0) watch();
}

void DiskWatch::accept() {
  for (auto& [path, bytes] : known_) bytes = bytes_of(path);
  watch();
}

std::vector<std::filesystem::path> DiskWatch::changed() const {
  std::vector<std::filesystem::path> out;
  for (const auto& [path, bytes] : known_) {
    if (bytes_of(path) != bytes) out.push_back(path);
  }
  return out;
}

std::vector<std::filesystem::path> DiskWatch::take_changed() {
  std::vector<std::filesystem::path> out;
  for (auto& [path, bytes] : known_) {
    auto now = bytes_of(path);
    if (now == bytes) continue;
    bytes = std::move(now);
    out.push_back(path);
  }
  return out;
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
