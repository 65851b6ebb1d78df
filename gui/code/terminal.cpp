#include "code/terminal.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <utility>

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

namespace eyebridge::gui {

bool Terminal::open(std::function<void(const QByteArray&)> on_bytes) {
  on_bytes_ = std::move(on_bytes);
  // O_NOCTTY: it shall be nobody's terminal, or its end would be a SIGHUP for us.
  reader_ = UniqueFd(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK));
  std::array<char, 128> name{};
  if (reader_.get() < 0 || grantpt(reader_.get()) != 0 || unlockpt(reader_.get()) != 0 ||
      ptsname_r(reader_.get(), name.data(), name.size()) != 0) {
    return false;
  }
  writer_ = UniqueFd(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  termios mode{};
  if (writer_.get() < 0 || tcgetattr(writer_.get(), &mode) != 0) return false;
  cfmakeraw(&mode);  // bytes as they were written
  if (tcsetattr(writer_.get(), TCSANOW, &mode) != 0) return false;
  notifier_ = std::make_unique<QSocketNotifier>(reader_.get(), QSocketNotifier::Read);
  QObject::connect(notifier_.get(), &QSocketNotifier::activated, notifier_.get(), [this] {
    // Once: other events want their turn, too.
    if (read_some() == Got::End) notifier_->setEnabled(false);
  });
  return true;
}

void Terminal::take_outputs() const {
  dup2(writer_.get(), STDOUT_FILENO);
  dup2(writer_.get(), STDERR_FILENO);
}

Terminal::Got Terminal::read_some() {
  std::array<char, 65536> bytes;
  ssize_t got = 0;
  do {
    got = read(reader_.get(), bytes.data(), bytes.size());
  } while (got < 0 && errno == EINTR);
  if (got < 0 && errno == EAGAIN) return Got::NothingNow;
  if (got <= 0) return Got::End;  // EIO: the last writer has closed it
  on_bytes_(QByteArray(bytes.data(), static_cast<qsizetype>(got)));
  return Got::Bytes;
}

void Terminal::finish() {
  if (reader_.get() < 0) return;
  notifier_->setEnabled(false);
  // Somebody in the background may write for ever.
  constexpr int kMostReads = 1000;
  for (int i = 0; i < kMostReads && read_some() == Got::Bytes; ++i) {
  }
  notifier_.reset();
  reader_ = {};
  writer_ = {};
}

}  // namespace eyebridge::gui
