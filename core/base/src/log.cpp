#include "eyebridge/base/log.hpp"

#include <cerrno>
#include <string>

#include <unistd.h>

#include "eyebridge/base/text.hpp"

namespace eyebridge {

// Not by stderr: after wide characters of a program it takes no others.
void tell(std::string_view text) {
  const std::string line = "eyebridge: " + printable(text) + '\n';
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t written = ::write(STDERR_FILENO, line.data() + done, line.size() - done);
    if (written < 0 && errno != EINTR) return;
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

}  // namespace eyebridge
