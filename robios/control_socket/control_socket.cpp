#include "control_socket.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace eyebridge::robios {
namespace {

namespace fs = std::filesystem;

/// Nothing where the path is too long for a socket.
std::optional<sockaddr_un> address_of(const fs::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.native().size() >= sizeof address.sun_path) return std::nullopt;
  std::memcpy(address.sun_path, path.c_str(), path.native().size());
  return address;
}

UniqueFd new_socket() { return UniqueFd(socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0)); }

}  // namespace

fs::path control_folder() {
  const char* const run_time = std::getenv("XDG_RUNTIME_DIR");
  const fs::path folder = run_time != nullptr && *run_time == '/'
                              ? fs::path(run_time) / "eyebridge"
                              : fs::path(fmt::format("/tmp/eyebridge-{}", getuid()));
  mkdir(folder.c_str(), 0700);
  struct stat facts {};
  // In /tmp somebody else may have been there before.
  const bool is_mine = lstat(folder.c_str(), &facts) == 0 && S_ISDIR(facts.st_mode) &&
                       facts.st_uid == getuid() && (facts.st_mode & 077U) == 0;
  return is_mine ? folder : fs::path();
}

std::vector<pid_t> controllable_runs() {
  std::vector<pid_t> found;
  std::error_code error;  // a folder that is gone holds none
  for (const auto& entry : fs::directory_iterator(control_folder(), error)) {
    const std::string name = entry.path().filename().string();
    pid_t pid = 0;
    const auto [end, bad] = std::from_chars(name.data(), name.data() + name.size(), pid);
    if (bad == std::errc() && end == name.data() + name.size() && pid > 0) found.push_back(pid);
  }
  std::ranges::sort(found);
  return found;
}

fs::path control_socket_of(pid_t pid) {
  const fs::path folder = control_folder();
  return folder.empty() ? folder : folder / std::to_string(pid);
}

UniqueFd open_control_socket() {
  const fs::path path = control_socket_of(getpid());
  // Under its name only once it listens: who is refused takes the name away.
  const fs::path beside = path.native() + ".new";
  const auto address = address_of(beside);
  if (path.empty() || !address) return {};
  unlink(beside.c_str());  // of a process with this number that was killed
  UniqueFd listener = new_socket();
  const auto* const name = reinterpret_cast<const sockaddr*>(&*address);
  if (bind(listener.get(), name, sizeof *address) != 0 || listen(listener.get(), 8) != 0 ||
      rename(beside.c_str(), path.c_str()) != 0) {
    return {};
  }
  return listener;
}

UniqueFd accept_next(const UniqueFd& listener) {
  for (;;) {
    const int socket = accept4(listener.get(), nullptr, nullptr, SOCK_CLOEXEC);
    if (socket >= 0 || (errno != EINTR && errno != ECONNABORTED)) return UniqueFd(socket);
  }
}

void close_control_socket() noexcept {
  try {
    unlink(control_socket_of(getpid()).c_str());
  } catch (
      const std::exception&) {  // what is left of it is taken away by the next one who connects
  }
}

UniqueFd connect_to_run(pid_t pid) {
  const fs::path path = control_socket_of(pid);
  const auto address = address_of(path);
  if (!address) return {};
  UniqueFd socket = new_socket();
  const auto* const name = reinterpret_cast<const sockaddr*>(&*address);
  if (connect(socket.get(), name, sizeof *address) == 0) return socket;
  if (errno == ECONNREFUSED) unlink(path.c_str());
  return {};
}

bool send_words(const UniqueFd& socket, const Words& words) {
  std::string message;
  for (const std::string& word : words) message.append(word).push_back('\0');
  if (message.size() > kLongestMessage) return false;
  const ssize_t sent = send(socket.get(), message.data(), message.size(), MSG_NOSIGNAL);
  return sent == static_cast<ssize_t>(message.size());
}

std::optional<Words> receive_words(const UniqueFd& socket, int patience_s) {
  pollfd waiting{socket.get(), POLLIN, 0};
  if (patience_s > 0 && poll(&waiting, 1, patience_s * 1000) <= 0) return std::nullopt;
  std::string message(kLongestMessage, '\0');
  const ssize_t size = recv(socket.get(), message.data(), message.size(), 0);
  if (size <= 0 || message[static_cast<std::size_t>(size) - 1] != '\0') return std::nullopt;
  message.resize(static_cast<std::size_t>(size));
  Words words;
  for (std::size_t at = 0; at < message.size(); at += words.back().size() + 1) {
    words.emplace_back(message.c_str() + at);
  }
  return words;
}

}  // namespace eyebridge::robios
