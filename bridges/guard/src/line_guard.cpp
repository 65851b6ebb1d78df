#include "eyebridge/bridges/guard/line_guard.hpp"

#include <cerrno>
#include <cstddef>
#include <span>
#include <system_error>

#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "eyebridge/base/hidden_process.hpp"
#include "eyebridge/base/sent_descriptor.hpp"
#include "eyebridge/base/uncancelled.hpp"
#include "guard_process.hpp"
#include "guard_words.hpp"

namespace eyebridge::bridges {
namespace {

// Well below kSilence: some of them may come late.
constexpr Time kTurningPeriod = std::chrono::milliseconds(50);
constexpr std::size_t kShort = offsetof(GuardWord, device);  // of a word without more

Error no_guard(const char* doing) {
  return {Errc::Disconnected, std::string("the guard, which stops the motors when the program "
                                          "crashes, is missing: ") +
                                  doing + ": " + std::system_category().message(errno)};
}

Result<void> say(int words, const GuardWord& word, std::size_t size, int line = -1) {
  const auto bytes = std::as_bytes(std::span(&word, 1)).first(size);
  if (send_with_descriptor(words, bytes, line) < 0) return tl::unexpected(no_guard("telling it"));
  return {};
}

}  // namespace

Result<std::unique_ptr<LineGuard>> LineGuard::start() {
  const UniqueFd program(static_cast<int>(::syscall(SYS_pidfd_open, ::getpid(), 0)));
  if (!program.valid()) return tl::unexpected(no_guard("pidfd_open"));
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) {
    return tl::unexpected(no_guard("socketpair"));
  }
  UniqueFd ours(ends[0]);
  const UniqueFd theirs(ends[1]);
  const int kept[] = {theirs.get(), program.get(), STDERR_FILENO};
  if (!start_hidden_process("eb:guard", kept, run_guard, nullptr)) {
    return tl::unexpected(no_guard("clone"));
  }
  return std::unique_ptr<LineGuard>(new LineGuard(std::move(ours)));
}

Result<void> LineGuard::hold(int line, std::string_view device, const StopOrders& orders) {
  GuardWord word;
  word.kind = GuardWord::Kind::Hold;
  word.orders = orders;
  device.substr(0, sizeof word.device - 1).copy(word.device, sizeof word.device - 1);
  turns_ = true;
  said_ = Time{0};
  return say(words_.get(), word, sizeof word, line);
}

Result<void> LineGuard::let_go() {
  GuardWord word;
  word.kind = GuardWord::Kind::LetGo;
  const Uncancelled until_answered;  // the next one would have this answer
  return say(words_.get(), word, kShort).and_then([this]() -> Result<void> {
    char answer = 0;
    while (true) {
      const ssize_t count = ::recv(words_.get(), &answer, 1, 0);
      if (count > 0) return {};
      if (count < 0 && errno == EINTR) continue;
      if (count == 0) errno = EPIPE;
      return tl::unexpected(no_guard("waiting for it"));
    }
  });
}

Result<void> LineGuard::turning(Time now) {
  if (turns_ && now - said_ < kTurningPeriod) return {};
  turns_ = true;
  said_ = now;
  GuardWord word;
  word.kind = GuardWord::Kind::Turning;
  return say(words_.get(), word, kShort);
}

Result<void> LineGuard::still() {
  turns_ = false;
  GuardWord word;
  return say(words_.get(), word, kShort);
}

}  // namespace eyebridge::bridges
