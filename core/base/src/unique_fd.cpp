#include "eyebridge/base/unique_fd.hpp"

#include <cerrno>

#include <unistd.h>

namespace eyebridge {

void UniqueFd::reset(int fd) noexcept {
  const int old = std::exchange(fd_, fd < 0 ? kNone : fd);
  if (old == kNone || old == fd_) return;
  const int kept = errno;
  ::close(old);  // Linux frees the descriptor even when this reports an error: never again.
  errno = kept;
}

}  // namespace eyebridge
