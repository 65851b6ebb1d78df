#include "widgets/file_keeper.hpp"

#include <QFile>
#include <QMetaObject>
#include <utility>

#include "widgets/whole_file.hpp"

namespace eyebridge::gui {

FileKeeper::FileKeeper(std::function<void(const QString& path, const QString& why)> on_written)
    : on_written_(std::move(on_written)) {}

FileKeeper::~FileKeeper() { finish(); }

void FileKeeper::write(const QString& path, Bytes bytes) { ask(path, std::move(bytes)); }

void FileKeeper::remove(const QString& path) { ask(path, {}); }

void FileKeeper::ask(const QString& path, Bytes bytes) {
  {
    const std::lock_guard lock(mutex_);
    wanted_[path] = std::move(bytes);
  }
  worker_.give([this] { do_all(); });
}

void FileKeeper::do_all() {
  std::map<QString, Bytes> wanted;
  {
    const std::lock_guard lock(mutex_);
    wanted.swap(wanted_);
  }
  for (const auto& [path, bytes] : wanted) {
    if (!bytes) {
      QFile::remove(path);
      continue;
    }
    const QString why = write_whole(path, bytes());
    const auto tell = [this, path = path, why] { on_written_(path, why); };
    QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
  }
}

}  // namespace eyebridge::gui
