#include "report.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::bridges {

void report(std::initializer_list<std::string_view> parts) {
  std::array<char, 512> line{};
  std::size_t size = 0;
  const auto add = [&](std::string_view part) {
    const std::size_t count = std::min(part.size(), line.size() - 1 - size);
    part.copy(line.data() + size, count);
    // Not printable(): that takes memory, which a guard has none of when the system has none.
    std::replace_if(
        line.data() + size, line.data() + size + count,
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
    size += count;
  };
  add("eyebridge: ");
  for (const std::string_view part : parts) add(part);
  line[size++] = '\n';
  // A full pipe, or a terminal stopped by Ctrl-S, would block the guard while the motors run.
  pollfd room{STDERR_FILENO, POLLOUT, 0};
  if (::poll(&room, 1, 0) != 1 || (room.revents & POLLOUT) == 0) return;
  static_cast<void>(!::write(STDERR_FILENO, line.data(), size));
}

bool has_reader() {
  struct stat status {};
  return ::fstat(STDERR_FILENO, &status) == 0 &&
         (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode));
}

void let_reader_go() {
  const UniqueFd nothing(::open("/dev/null", O_WRONLY | O_CLOEXEC));
  ::dup2(nothing.get(), STDERR_FILENO);
}

Digits::Digits(std::int64_t number)
    : size_(static_cast<std::size_t>(std::to_chars(std::begin(text_), std::end(text_), number).ptr -
                                     std::begin(text_))) {}

}  // namespace eyebridge::bridges
