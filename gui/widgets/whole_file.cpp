#include "widgets/whole_file.hpp"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <memory>
#include <optional>

namespace eyebridge::gui {
namespace {

/// One file on its way to the disk: prepared beside its place, where that can be.
class Writing {
 public:
  explicit Writing(const FileBytes& file) : file_(file), disk_(file.path) {}

  /// Returns "" or why it cannot be written; the file itself has not changed.
  QString prepare() {
    if (!disk_.open(QIODevice::WriteOnly)) {
      // In a folder where no new files may be made the file itself may still be written.
      const QFileInfo there(file_.path);
      const bool is_folder_closed = !QFileInfo(there.absolutePath()).isWritable();
      is_direct_ = is_folder_closed && there.isFile() && there.isWritable();
      if (!is_direct_) return disk_.errorString();
      keep_old();
      // It could not be put back.
      return old_ ? QString() : disk_.errorString();
    }
    // flush(): commit() does not notice when the last of its buffer finds no room.
    if (disk_.write(file_.bytes) == file_.bytes.size() && disk_.flush()) return {};
    QString why = disk_.errorString();
    disk_.cancelWriting();
    return why;
  }

  /// Where the file has to come back if another one fails.
  void keep_old() {
    was_there_ = QFileInfo::exists(file_.path);
    QFile old(file_.path);
    if (QFileInfo(file_.path).isFile() && old.open(QIODevice::ReadOnly)) old_ = old.readAll();
  }

  /// Returns "" or why it is not in its place.
  QString commit() {
    if (!is_direct_) return disk_.commit() ? QString() : disk_.errorString();
    QFile disk(file_.path);
    const bool is_written = disk.open(QIODevice::WriteOnly) &&
                            disk.write(file_.bytes) == file_.bytes.size() && disk.flush();
    if (is_written) return {};
    QString why = disk.errorString();
    disk.close();
    is_torn_ = !put_back();
    return why;
  }

  /// What was there before commit(). False when the disk refuses.
  bool put_back() const {
    if (!was_there_) return QFile::remove(file_.path);
    if (!old_) return false;
    if (!is_direct_) return write_whole(file_.path, *old_).isEmpty();
    QFile disk(file_.path);
    return disk.open(QIODevice::WriteOnly) && disk.write(*old_) == old_->size() && disk.flush();
  }

  [[nodiscard]] const QString& path() const { return file_.path; }
  /// Neither as it was nor as it should be, after commit() failed.
  [[nodiscard]] bool is_torn() const { return is_torn_; }

 private:
  const FileBytes& file_;
  QSaveFile disk_;
  bool is_direct_ = false;
  bool was_there_ = false;
  bool is_torn_ = false;
  std::optional<QByteArray> old_;  ///< None: it cannot be read.
};

}  // namespace

WriteEnd write_all(const std::vector<FileBytes>& files) {
  std::vector<std::unique_ptr<Writing>> all;
  for (const FileBytes& file : files) {
    Writing& writing = *all.emplace_back(std::make_unique<Writing>(file));
    // What was prepared before is cancelled with `all`.
    if (QString why = writing.prepare(); !why.isEmpty()) return {why, file.path, {}};
    if (files.size() > 1) writing.keep_old();
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const QString why = all[i]->commit();
    if (why.isEmpty()) continue;
    QStringList torn;
    if (all[i]->is_torn()) torn << all[i]->path();
    for (std::size_t k = 0; k < i; ++k) {
      if (!all[k]->put_back()) torn << all[k]->path();
    }
    return {why, all[i]->path(), torn};
  }
  return {};
}

QString write_whole(const QString& path, const QByteArray& bytes) {
  return write_all({{path, bytes}}).why;
}

}  // namespace eyebridge::gui
