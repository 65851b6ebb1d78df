#include "eyebridge/bridges/serial.hpp"

#include <cerrno>
#include <utility>

#include <asm/termbits.h>  // termios2: any bit rate; <termios.h> knows only fixed ones
#include <fcntl.h>
#include <linux/serial.h>
#include <sys/file.h>
#include <sys/ioctl.h>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/bridges/fd_stream.hpp"
#include "wait.hpp"

namespace eyebridge::bridges {
namespace {

tl::unexpected<Error> cannot_open(const std::string& device, int error) {
  const std::string start = device + ": ";
  switch (error) {
    case ENOENT:
    case ENXIO:
    case ENODEV:
      return fail(Errc::Disconnected,
                  start + "no such device; expected a board that is plugged in");
    case EACCES:
    case EPERM:
      return fail(Errc::Disconnected,
                  start +
                      "permission denied; expected that you are in the group of the device (often "
                      "dialout): add yourself, then log in again");
    case EBUSY:
      return fail(Errc::Disconnected, start + "in use by another program");
    default:
      return fail(Errc::Disconnected, start + errno_text(error));
  }
}

/// What cfmakeraw() sets, and no hanging up on close: DTR would reset many boards.
void make_raw(termios2& settings, unsigned baud, bool handshake) {
  settings.c_iflag = 0;
  settings.c_oflag = 0;
  settings.c_lflag = 0;
  settings.c_cflag = BOTHER | CS8 | CREAD | CLOCAL;  // without HUPCL, PARENB, CSTOPB
  if (handshake) settings.c_cflag |= CRTSCTS;
  settings.c_ispeed = baud;
  settings.c_ospeed = baud;
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
}

/// FTDI adapters collect what arrives for 16 ms unless they are asked not to. Other drivers refuse,
/// or have nothing to change: `eyebridge probe` tells where it matters.
void ask_for_low_latency(int port) {
  serial_struct line{};
  if (::ioctl(port, TIOCGSERIAL, &line) != 0) return;
  line.flags |= ASYNC_LOW_LATENCY;
  (void)::ioctl(port, TIOCSSERIAL, &line);
}

/// The guard of a program that has just ended may have the port for some milliseconds.
constexpr Time kBusyTime = std::chrono::milliseconds(500);

/// 0, or errno: EBUSY when another program has the port. ENOTTY and EINVAL: not a serial port.
int open_locked(const char* device, UniqueFd& fd, termios2& terminal) {
  // Non-blocking: without it, opening waits for a carrier that most boards never raise.
  fd.reset(::open(device, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!fd.valid() || ::ioctl(fd.get(), TCGETS2, &terminal) != 0) return errno;
  // TIOCEXCL does not bind root and flock() binds only those who ask: both.
  if (::flock(fd.get(), LOCK_EX | LOCK_NB) != 0) return errno == EWOULDBLOCK ? EBUSY : errno;
  return ::ioctl(fd.get(), TIOCEXCL) != 0 ? errno : 0;
}

}  // namespace

Result<std::unique_ptr<ByteStream>> open_serial(const SerialSettings& settings, Clock& clock) {
  constexpr Time kPause = std::chrono::milliseconds(10);
  const std::string& device = settings.device;
  UniqueFd fd;
  termios2 terminal{};
  const Time until = clock.now() + kBusyTime;
  int error = open_locked(device.c_str(), fd, terminal);
  while (error == EBUSY && clock.now() < until) {
    clock.wait_until(clock.now() + kPause);
    error = open_locked(device.c_str(), fd, terminal);
  }
  if (fd.valid() && (error == ENOTTY || error == EINVAL)) {
    return fail(Errc::Unsupported, device + ": not a serial port");
  }
  if (error != 0) return cannot_open(device, error);

  make_raw(terminal, settings.baud, settings.handshake);
  if (::ioctl(fd.get(), TCSETS2, &terminal) != 0 || ::ioctl(fd.get(), TCGETS2, &terminal) != 0) {
    return fail(Errc::Unsupported, device + ": cannot be set to " + std::to_string(settings.baud) +
                                       " bits per second: " + errno_text(errno));
  }
  ask_for_low_latency(fd.get());
  // Drivers take the nearest rate that they have; UARTs stop understanding each other at 3 %.
  const double ratio = static_cast<double>(terminal.c_ospeed) / settings.baud;
  if (ratio < 0.97 || ratio > 1.03) {
    return fail(Errc::Unsupported, device + ": asked for " + std::to_string(settings.baud) +
                                       " bits per second, the port has " +
                                       std::to_string(terminal.c_ospeed));
  }
  if (::ioctl(fd.get(), TCFLSH, TCIOFLUSH) != 0) return cannot_open(device, errno);
  return make_fd_stream(std::move(fd), device, clock);
}

}  // namespace eyebridge::bridges
