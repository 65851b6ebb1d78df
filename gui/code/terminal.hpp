#pragma once

#include <QByteArray>
#include <QSocketNotifier>
#include <functional>
#include <memory>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::gui {

/// A pseudo-terminal that a process writes to: what programs print to one comes line by line and
/// not when it has become 4 kB. For the thread with an event loop that made it.
class Terminal {
 public:
  /// Opens it, `on_bytes` gets what is written. False when the system refuses.
  [[nodiscard]] bool open(std::function<void(const QByteArray&)> on_bytes);
  /// For the child process after fork(): standard output and standard error go here.
  void take_outputs() const;
  /// The parent does not write: after this the end of the last writer can be seen.
  void close_writer() { writer_ = {}; }
  /// Reads what there still is, and closes.
  void finish();

 private:
  /// NothingNow: more may come.
  enum class Got { Bytes, NothingNow, End };
  Got read_some();

  UniqueFd reader_;
  UniqueFd writer_;
  std::unique_ptr<QSocketNotifier> notifier_;
  std::function<void(const QByteArray&)> on_bytes_;
};

}  // namespace eyebridge::gui
