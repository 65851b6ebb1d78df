#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <vector>

namespace eyebridge::gui {

/// A file to be written.
struct FileBytes {
  QString path;
  QByteArray bytes;
};

/// How writing several files ended.
struct WriteEnd {
  QString why;       ///< "": all are on the disk. Else in the system's words …
  QString path;      ///< … what could not be written …
  QStringList torn;  ///< … and those that could not be put back as they were.
};

/// Writes all bytes of all files, or none: each is as it was, then.
WriteEnd write_all(const std::vector<FileBytes>& files);

/// Writes the bytes, all of them or none. Returns "" or why not, in the system's words.
QString write_whole(const QString& path, const QByteArray& bytes);

}  // namespace eyebridge::gui
