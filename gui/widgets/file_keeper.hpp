#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <mutex>

#include "widgets/worker.hpp"

namespace eyebridge::gui {

/// Writes files again and again, each as a whole, in a thread of its own: what is kept so that
/// kill -9 or a power failure loses none of it waits for the disk, and nobody waits for that.
class FileKeeper final : public QObject {
 public:
  /// `on_written` is told of each file that was written, with why it could not be, else ""; by the
  /// event loop of the thread that makes this object.
  explicit FileKeeper(std::function<void(const QString& path, const QString& why)> on_written);
  /// Returns when all is on the disk that was asked for.
  ~FileKeeper() override;

  /// The file gets these bytes, which may be computed in the other thread. Where it was asked for
  /// before and has not been written yet, the newer ones count.
  void write(const QString& path, std::function<QByteArray()> bytes);
  /// The file goes, whatever was asked for before.
  void remove(const QString& path);
  /// Returns when all that was asked for is done.
  void finish() { worker_.finish(); }

 private:
  using Bytes = std::function<QByteArray()>;  ///< Empty: the file is to go.

  void ask(const QString& path, Bytes bytes);
  void do_all();

  const std::function<void(const QString& path, const QString& why)> on_written_;
  std::mutex mutex_;
  std::map<QString, Bytes> wanted_;
  Worker worker_;  ///< Last: it uses the others.
};

}  // namespace eyebridge::gui
