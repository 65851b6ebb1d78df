#include "eyebridge/bridges/fd_stream.hpp"

#include <cassert>
#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include "wait.hpp"

namespace eyebridge::bridges {
namespace {

bool is_socket(int fd) {
  struct stat status {};
  return ::fstat(fd, &status) == 0 && S_ISSOCK(status.st_mode);
}

class FdStream final : public ByteStream {
 public:
  FdStream(UniqueFd fd, std::string name, Clock& clock)
      : fd_(std::move(fd)), name_(std::move(name)), clock_(clock), socket_(is_socket(fd_.get())) {
    const int flags = ::fcntl(fd_.get(), F_GETFL);
    ::fcntl(fd_.get(), F_SETFL, flags | O_NONBLOCK);
  }

  Result<std::size_t> read_some(std::span<std::uint8_t> buffer, Time deadline) override {
    assert(!buffer.empty());
    while (fd_.valid()) {
      const ssize_t count = ::read(fd_.get(), buffer.data(), buffer.size());
      if (count > 0) return static_cast<std::size_t>(count);
      if (count == 0) return fail(Errc::Disconnected, name_ + ": closed by the other side");
      if (errno == EINTR) continue;
      if (errno != EAGAIN) return lost("reading");
      if (!wait_ready(fd_.get(), POLLIN, clock_, deadline)) {
        return fail(Errc::Timeout, name_ + ": nothing came in time");
      }
    }
    return closed();
  }

  // As read_some(), but that nothing is there costs no error text: asked before every request.
  Result<std::size_t> read_now(std::span<std::uint8_t> buffer) override {
    while (fd_.valid()) {
      const ssize_t count = ::read(fd_.get(), buffer.data(), buffer.size());
      if (count > 0) return static_cast<std::size_t>(count);
      if (count == 0) return fail(Errc::Disconnected, name_ + ": closed by the other side");
      if (errno == EAGAIN) return std::size_t{0};
      if (errno != EINTR) return lost("reading");
    }
    return closed();
  }

  Result<void> write_all(std::span<const std::uint8_t> bytes, Time deadline) override {
    const std::size_t total = bytes.size();
    while (fd_.valid()) {
      if (bytes.empty()) return {};
      const ssize_t count = write_some(bytes);
      if (count >= 0) {
        bytes = bytes.subspan(static_cast<std::size_t>(count));
        continue;
      }
      if (errno == EINTR) continue;
      if (errno != EAGAIN) return lost("writing");
      if (!wait_ready(fd_.get(), POLLOUT, clock_, deadline)) {
        return fail(Errc::Timeout, name_ + ": the line took " +
                                       std::to_string(total - bytes.size()) + " of " +
                                       std::to_string(total) + " bytes in time");
      }
    }
    return closed();
  }

  void close() override { fd_.reset(); }
  [[nodiscard]] int descriptor() const override { return fd_.get(); }
  [[nodiscard]] std::string_view name() const override { return name_; }

 private:
  ssize_t write_some(std::span<const std::uint8_t> bytes) {
    // A socket whose peer is gone would raise SIGPIPE, which ends programs that do not expect it.
    if (socket_) return ::send(fd_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    return ::write(fd_.get(), bytes.data(), bytes.size());
  }

  [[nodiscard]] tl::unexpected<Error> closed() const {
    return fail(Errc::Disconnected, name_ + ": closed here");
  }

  [[nodiscard]] tl::unexpected<Error> lost(const char* doing) const {
    const int error = errno;
    // Terminals report a hang-up as an input/output error.
    const bool gone = error == EIO || error == EPIPE || error == ECONNRESET || error == ENODEV ||
                      error == ENXIO || error == ENOTCONN;
    return fail(Errc::Disconnected, name_ + ": " + (gone ? "the other side is gone while " : "") +
                                        doing + ": " + errno_text(error));
  }

  UniqueFd fd_;
  std::string name_;
  Clock& clock_;
  bool socket_;
};

}  // namespace

std::unique_ptr<ByteStream> make_fd_stream(UniqueFd fd, std::string name, Clock& clock) {
  return std::make_unique<FdStream>(std::move(fd), std::move(name), clock);
}

}  // namespace eyebridge::bridges
