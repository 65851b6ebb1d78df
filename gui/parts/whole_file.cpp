#include "parts/whole_file.hpp"

#include <QSaveFile>

namespace eyebridge::gui {

QString write_whole(const QString& path, const QByteArray& bytes) {
  QSaveFile disk(path);
  // In a folder where no new files may be made the file itself may still be written.
  disk.setDirectWriteFallback(true);
  // flush(): commit() does not notice when the last of its buffer finds no room.
  if (!disk.open(QIODevice::WriteOnly) || disk.write(bytes) != bytes.size() || !disk.flush()) {
    const QString why = disk.errorString();
    disk.cancelWriting();
    return why;
  }
  return disk.commit() ? "" : disk.errorString();
}

}  // namespace eyebridge::gui
