#pragma once

#include <QByteArray>
#include <QString>

namespace eyebridge::gui {

/// A text, and the bytes that it has on disk.
struct TextFile {
  QString text;
  QByteArray bytes;
  bool is_latin1 = false;      ///< It was not UTF-8: it is written as it was read.
  bool has_byte_mark = false;  ///< It began with the byte order mark of UTF-8.
};

/// Reads a text of at most 16 MB. Returns "" or what was wrong, in a sentence for people.
QString read_text(const QString& path, TextFile& file);

/// Writes `file.text` and sets `file.bytes` to what was written: either all of it is on disk then,
/// or what was there before. Letters that Latin-1 does not have make it UTF-8. Returns as
/// read_text().
QString write_text(const QString& path, TextFile& file);

}  // namespace eyebridge::gui
