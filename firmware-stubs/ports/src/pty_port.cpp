#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include "eyebridge/ports/lines.hpp"
#include "fd_bytes.hpp"

namespace eyebridge::ports {
namespace {

namespace fs = std::filesystem;

/// Neither echo nor line editing: the board must not hear itself.
void make_raw(int fd) {
  termios settings{};
  if (tcgetattr(fd, &settings) != 0) return;
  cfmakeraw(&settings);
  tcsetattr(fd, TCSANOW, &settings);
}

[[noreturn]] void refuse(const SourceLocation& where, const std::string& what) {
  throw ConfigError(where, what);
}

std::string error_text(int code) { return std::generic_category().message(code); }

class PtyPort : public Port {
 public:
  PtyPort(ByteLine line, UniqueFd master, const std::string& device, std::string link)
      : bytes_(std::move(line)),
        master_(std::move(master)),
        device_(device),
        link_(std::move(link)) {}
  ~PtyPort() override {
    std::error_code ignored;
    if (fs::read_symlink(link_, ignored) == device_) fs::remove(link_, ignored);
  }
  PtyPort(const PtyPort&) = delete;
  PtyPort& operator=(const PtyPort&) = delete;

  void pump() override {
    if (!connected_) {
      if (hung_up()) return;
      connected_ = true;
    }
    if (bytes_.pump(master_.get())) return;
    connected_ = false;
    // What the host set or left in the buffers is none of the next one's.
    make_raw(master_.get());
    tcflush(master_.get(), TCIOFLUSH);
  }
  /// A terminal that nobody has open is always "ready": looking at it now and then must do.
  [[nodiscard]] int descriptor() const override { return connected_ ? master_.get() : -1; }
  [[nodiscard]] bool wants_room() const override { return bytes_.wants_room(); }
  [[nodiscard]] bool connected() const override { return connected_; }
  [[nodiscard]] std::string address() const override { return "serial:" + link_; }

 private:
  [[nodiscard]] bool hung_up() const {
    pollfd entry{master_.get(), POLLIN, 0};
    return ::poll(&entry, 1, 0) > 0 && (entry.revents & POLLHUP) != 0;
  }

  FdBytes bytes_;
  UniqueFd master_;
  std::string device_;
  std::string link_;
  bool connected_ = false;
};

/// Whether a killed process left `link`: it points nowhere, or to a terminal without its master,
/// which exists for as long as its host has it open.
bool is_dead(const std::string& link) {
  const UniqueFd fd(::open(link.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  return !fd.valid() && (errno == ENOENT || errno == EIO);
}

void make_link(const std::string& device, const std::string& link, const SourceLocation& where) {
  std::error_code error;
  const bool is_link = fs::is_symlink(fs::symlink_status(link, error));
  if (::symlink(device.c_str(), link.c_str()) == 0) return;
  const int code = errno;
  if (code == EEXIST) {
    refuse(where, "found a file " + link + " there already, expected a free name" +
                      (is_link ? " (another firmware may be running; else remove it)" : ""));
  }
  refuse(where, "cannot make " + link + ": " + error_text(code));
}

}  // namespace

std::unique_ptr<Port> open_pty(ByteLine line, const std::string& link,
                               const SourceLocation& where) {
  if (link.empty()) refuse(where, "found no name, expected one such as ./eyebot.tty");
  // Before there is a terminal of ours: it may get the number of a dead one.
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(link, error)) && is_dead(link)) fs::remove(link, error);
  int master = -1;
  int slave = -1;
  if (::openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) {
    refuse(where, "cannot make a pseudo-terminal: " + error_text(errno));
  }
  UniqueFd owned(master);
  const UniqueFd held(slave);  // closed at the end: from then on the master tells who is there
  make_raw(slave);
  char device[128] = {};
  if (::ttyname_r(slave, device, sizeof device) != 0 || ::fcntl(master, F_SETFL, O_NONBLOCK) != 0 ||
      ::fcntl(master, F_SETFD, FD_CLOEXEC) != 0) {
    refuse(where, "cannot set up a pseudo-terminal: " + error_text(errno));
  }
  make_link(device, link, where);
  return std::make_unique<PtyPort>(std::move(line), std::move(owned), device, link);
}

}  // namespace eyebridge::ports
