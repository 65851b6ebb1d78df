#include "remote_robot/line_memory.hpp"

#include <array>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include "eyebridge/base/sent_descriptor.hpp"

namespace eyebridge::hal {
namespace {

constexpr auto kSize = static_cast<off_t>(sizeof(SharedLine));
// Without the seals a program could shorten the memory, and the world would crash with SIGBUS.
constexpr int kSeals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;

[[noreturn]] void refuse() {
  throw std::system_error(errno, std::generic_category(), "memory for a line to a robot's program");
}

tl::unexpected<Error> cannot_be_opened() {
  return fail(Errc::Disconnected,
              "the robot's line cannot be opened: " + std::generic_category().message(errno));
}

bool has_its_size(int descriptor) {
  struct stat status {};
  const int seals = fcntl(descriptor, F_GET_SEALS);
  return seals >= 0 && fstat(descriptor, &status) == 0 && status.st_size == kSize &&
         (seals & kSeals) == kSeals;
}

}  // namespace

LineMemory::LineMemory(int descriptor) {
  void* const place =
      mmap(nullptr, sizeof(SharedLine), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  if (place != MAP_FAILED) line_ = static_cast<SharedLine*>(place);
}

LineMemory::~LineMemory() {
  if (line_ != nullptr) munmap(line_, sizeof(SharedLine));
}

LineMemory::LineMemory(LineMemory&& other) noexcept : line_(std::exchange(other.line_, nullptr)) {}

LineMemory LineMemory::offer(int socket) {
  const UniqueFd file(memfd_create("eyebridge-line", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!file.valid() || ftruncate(file.get(), kSize) != 0 ||
      fcntl(file.get(), F_ADD_SEALS, kSeals) != 0) {
    refuse();
  }
  LineMemory memory(file.get());
  if (memory.line_ == nullptr) refuse();
  const std::array<std::byte, 1> sign{};
  const bool is_sent = send_with_descriptor(socket, sign, file.get()) > 0;
  // When the other end is already gone, the first receive() reports it.
  if (!is_sent && errno != EPIPE && errno != ECONNRESET) refuse();
  return memory;
}

Result<LineMemory> LineMemory::accept(int socket) {
  UniqueFd file;
  std::array<std::byte, 1> sign{};
  const ssize_t count = receive_with_descriptor(socket, sign, file);
  if (count == 0 || (count < 0 && errno == ECONNRESET)) {
    return fail(Errc::Disconnected, "the process at the other end of the robot's line is gone");
  }
  if (count < 0) return cannot_be_opened();
  if (!has_its_size(file.get())) {
    return fail(Errc::Corrupt,
                "what came from the robot's server is no answer: it has another version");
  }
  LineMemory memory(file.get());
  if (memory.line_ == nullptr) return cannot_be_opened();
  return memory;
}

}  // namespace eyebridge::hal
