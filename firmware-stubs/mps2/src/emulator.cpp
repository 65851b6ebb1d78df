#include "eyebridge/mps2/emulator.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::mps2 {
namespace {

constexpr int kEndPatience_ms = 2000;
constexpr unsigned char kArm = 40;  // e_machine of an ELF file, its low byte

std::string error_text(int code) { return std::generic_category().message(code); }

void check_elf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw ConfigError(
        {path}, "cannot be read: " + error_text(errno) +
                    "; expected the firmware of the emulated board: install "
                    "gcc-arm-none-eabi and libnewlib-arm-none-eabi and build EyeBridge again");
  }
  std::array<char, 20> head{};
  file.read(head.data(), head.size());
  const std::string_view magic(head.data(), 5);  // 32 bits
  if (file.gcount() < 20 || magic != "\177ELF\1" || head[18] != kArm || head[19] != 0) {
    throw ConfigError({path}, "is no program for an ARM processor; expected eyebridge-mps2.elf");
  }
}

std::pair<UniqueFd, UniqueFd> socket_pair() {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw ConfigError({"--cortex-m3"}, "cannot make a pair of sockets: " + error_text(errno));
  }
  return {UniqueFd(ends[0]), UniqueFd(ends[1])};
}

std::vector<std::string> command_line(const EmulatorSettings& settings, int host, int plant) {
  std::vector<std::string> words{settings.command, "-machine", "mps2-an385", "-kernel",
                                 settings.elf};
  for (const char* word : {"-no-user-config", "-nodefaults", "-display", "none", "-monitor", "none",
                           // The board has an Ethernet port, and QEMU a warning when it is open.
                           "-nic", "user,restrict=on"}) {
    words.emplace_back(word);
  }
  for (const int fd : {host, plant}) {  // in this order: UART0, UART1
    words.insert(words.end(), {"-chardev", fmt::format("socket,id=fd{0},fd={0}", fd), "-serial",
                               fmt::format("chardev:fd{}", fd)});
  }
  return words;
}

/// In the child: becomes the emulator, or tells why not and ends.
[[noreturn]] void become(std::vector<char*>& argv, pid_t parent, int host, int plant, int trouble) {
  // Out of the terminal's foreground group: Ctrl-C is for the parent, which ends this one in order.
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it was gone before it could be watched
  ::fcntl(host, F_SETFD, 0);
  ::fcntl(plant, F_SETFD, 0);
  ::execvp(argv[0], argv.data());
  const int code = errno;
  [[maybe_unused]] const auto told = ::write(trouble, &code, sizeof code);
  ::_exit(1);
}

}  // namespace

Emulator::Emulator(const EmulatorSettings& settings) {
  check_elf(settings.elf);
  auto [host, host_there] = socket_pair();
  auto [plant, plant_there] = socket_pair();
  auto [trouble, trouble_there] = socket_pair();
  std::vector<std::string> words = command_line(settings, host_there.get(), plant_there.get());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0) become(argv, parent, host_there.get(), plant_there.get(), trouble_there.get());
  if (pid_ < 0) throw ConfigError({settings.command}, "cannot start: " + error_text(errno));
  trouble_there.reset();
  int code = 0;
  if (::read(trouble.get(), &code, sizeof code) == sizeof code) {
    end();
    throw ConfigError({settings.command},
                      "cannot start: " + error_text(code) +
                          "; expected the emulator of the Cortex-M3: install qemu-system-arm");
  }
  for (const UniqueFd* line : {&host, &plant}) ::fcntl(line->get(), F_SETFL, O_NONBLOCK);
  host_line_ = std::move(host);
  plant_line_ = std::move(plant);
}

Emulator::~Emulator() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
}

std::string Emulator::end() {
  if (pid_ <= 0) return "has ended";
  // Its lines close a moment before it is over: how it ends is not to be overwritten by us.
  // glibc 2.36 declares its pidfd_open() for C only.
  const UniqueFd process(static_cast<int>(::syscall(SYS_pidfd_open, pid_, 0)));
  pollfd over{process.get(), POLLIN, 0};
  ::poll(&over, 1, kEndPatience_ms);
  ::kill(pid_, SIGKILL);
  int status = 0;
  ::waitpid(std::exchange(pid_, -1), &status, 0);
  return WIFEXITED(status) ? fmt::format("ended with exit code {}", WEXITSTATUS(status))
                           : fmt::format("was killed by signal {}", WTERMSIG(status));
}

}  // namespace eyebridge::mps2
