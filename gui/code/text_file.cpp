#include "code/text_file.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QStringDecoder>
#include <QStringEncoder>

#include "widgets/whole_file.hpp"

namespace eyebridge::gui {
namespace {

constexpr qint64 kLargest = 16 * 1024 * 1024;
const QByteArray kByteMark("\xef\xbb\xbf");

QString sentence(const char* text) { return QCoreApplication::translate("TextFile", text); }

/// A device, a pipe or a socket, or a link to one.
bool is_special(const QString& path) {
  const QFileInfo file(path);
  return file.exists() && !file.isFile() && !file.isDir();
}

}  // namespace

QString read_text(const QString& path, TextFile& file) {
  QFile disk(path);
  if (QFileInfo(path).isDir()) {
    return sentence(QT_TRANSLATE_NOOP("TextFile", "%1 is a folder; expected a text file"))
        .arg(path);
  }
  // A pipe would keep the window waiting.
  if (is_special(path)) {
    return sentence(QT_TRANSLATE_NOOP("TextFile", "%1 is no ordinary file; expected a text file"))
        .arg(path);
  }
  if (!disk.open(QIODevice::ReadOnly)) {
    return sentence(QT_TRANSLATE_NOOP("TextFile", "%1 cannot be read: %2"))
        .arg(path, disk.errorString());
  }
  // One more than is allowed: files of the system do not say how long they are.
  const QByteArray bytes = disk.read(kLargest + 1);
  if (bytes.size() > kLargest) {
    return sentence(QT_TRANSLATE_NOOP("TextFile", "%1 is too long; expected at most 16 MB"))
        .arg(path);
  }
  if (bytes.contains('\0')) {
    return sentence(QT_TRANSLATE_NOOP("TextFile", "%1 is no text: there are zero bytes in it"))
        .arg(path);
  }
  file.bytes = bytes;
  file.has_byte_mark = bytes.startsWith(kByteMark);
  const QByteArray words = file.has_byte_mark ? bytes.mid(kByteMark.size()) : bytes;
  QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
  file.text = decoder.decode(words);
  file.is_latin1 = decoder.hasError();
  if (file.is_latin1) {
    file.has_byte_mark = false;
    file.text = QString::fromLatin1(bytes);
  }
  return "";
}

QString write_text(const QString& path, TextFile& file) {
  QByteArray bytes = file.text.toUtf8();
  bool is_latin1 = false;
  if (file.is_latin1) {
    QStringEncoder encoder(QStringEncoder::Latin1, QStringEncoder::Flag::Stateless);
    const QByteArray latin1 = encoder.encode(file.text);
    is_latin1 = !encoder.hasError();
    if (is_latin1) bytes = latin1;
  }
  if (!is_latin1 && file.has_byte_mark) bytes.prepend(kByteMark);
  const auto trouble = [&](const QString& why) {
    return sentence(
               QT_TRANSLATE_NOOP(
                   "TextFile", "%1 cannot be saved: %2. The text is kept here; save it elsewhere"))
        .arg(path, why);
  };
  if (QFileInfo(path).exists() && !QFileInfo(path).isWritable()) {
    return trouble(sentence(QT_TRANSLATE_NOOP("TextFile", "it is write-protected")));
  }
  // Saving puts a new file in the place of the old one, which no device survives.
  if (is_special(path)) {
    return trouble(sentence(QT_TRANSLATE_NOOP("TextFile", "it is no ordinary file")));
  }
  if (const QString why = write_whole(path, bytes); !why.isEmpty()) return trouble(why);
  file.bytes = bytes;
  file.is_latin1 = is_latin1;
  return "";
}

}  // namespace eyebridge::gui
