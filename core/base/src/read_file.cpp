#include "eyebridge/base/read_file.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge {
namespace {

tl::unexpected<Error> refused(int error) {
  if (error == ENOENT) return fail(Errc::Unsupported, "no such file");
  return fail(Errc::Unsupported, "cannot be read: " + std::generic_category().message(error));
}

struct Opened {
  UniqueFd file;
  std::uintmax_t size = 0;
};

/// What a name leads to is looked at after it is open: it cannot be exchanged in between.
Result<Opened> open_regular(const std::filesystem::path& path, const std::string& expected) {
  Opened opened{UniqueFd(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC))};
  struct stat status {};
  if (!opened.file.valid() || ::fstat(opened.file.get(), &status) != 0) return refused(errno);
  if (!S_ISREG(status.st_mode)) {
    return fail(Errc::Unsupported,
                expected.empty() ? "is not a file" : "is not a file: expected " + expected);
  }
  opened.size = static_cast<std::uintmax_t>(status.st_size);
  return opened;
}

Result<std::string> read_up_to(const UniqueFd& file, std::uintmax_t count) {
  std::string bytes(static_cast<std::size_t>(count), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::read(file.get(), bytes.data() + done, bytes.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return refused(errno);
    if (got == 0) break;  // it has shrunk meanwhile
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path, std::uintmax_t most,
                              const std::string& expected) {
  return open_regular(path, expected).and_then([&](const Opened& opened) -> Result<std::string> {
    if (opened.size <= most) return read_up_to(opened.file, opened.size);
    return fail(Errc::Unsupported, "has " + std::to_string(opened.size) +
                                       " bytes, expected at most " + std::to_string(most));
  });
}

std::string first_bytes(const std::filesystem::path& path, std::size_t count) {
  return open_regular(path, "")
      .and_then([&](const Opened& opened) {
        return read_up_to(opened.file, std::min<std::uintmax_t>(opened.size, count));
      })
      .value_or("");
}

}  // namespace eyebridge
