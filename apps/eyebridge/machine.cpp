#include "machine.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

#include "eyebridge/base/thread_priority.hpp"
#include "machine/cameras.hpp"
#include "machine/can_state.hpp"
#include "machine/serial_ports.hpp"
#include "machine/system_files.hpp"
#include "own_files.hpp"
#include "parts.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

Finding pseudo_terminals() {
  const int descriptor = posix_openpt(O_RDWR | O_NOCTTY);
  const bool works = descriptor >= 0 && grantpt(descriptor) == 0 && unlockpt(descriptor) == 0;
  const std::string reason = works ? "for tests of serial boards" : std::strerror(errno);
  if (descriptor >= 0) close(descriptor);
  return {"PTY", false, works, reason, "mount devpts on /dev/pts"};
}

/// What the thread that steps a world in real time would be granted.
Finding real_time_priority() {
  ThreadPriority granted;
  std::thread([&granted] { granted = raise_priority(); }).join();
  return {"real-time", false, granted.kind == ThreadPriority::Kind::RealTime,
          granted.str() + ": worlds in real time are " +
              (granted.kind == ThreadPriority::Kind::RealTime ? "not late where others compute"
                                                              : "late where others compute"),
          "echo \"$USER - rtprio 1\" | sudo tee /etc/security/limits.d/eyebridge.conf, and log in "
          "again"};
}

/// Without ModemManager and its like nothing disturbs a board.
Finding udev_rule(const fs::path& root) {
  constexpr const char* kWhat = "udev rule";
  for (const char* folder : {"/etc/udev/rules.d", "/run/udev/rules.d",
                             "/usr/local/lib/udev/rules.d", "/usr/lib/udev/rules.d"}) {
    const auto names = names_in(below(root, folder), {"60-eyebridge"});
    if (!names.empty()) return {kWhat, false, true, std::string(folder) + "/" + names[0], ""};
  }
  return {kWhat, false, false, "lets people use boards, and keeps ModemManager away from them",
          "eyebridge doctor --udev | sudo tee /etc/udev/rules.d/60-eyebridge.rules"};
}

Finding own(const char* what, const fs::path& path, const char* remedy) {
  const bool found = fs::exists(path);
  return {what, true, found, found ? path.string() : "expected " + path.string(), remedy};
}

}  // namespace

std::vector<Finding> examine_machine(const fs::path& root) {
  const OwnFiles files = own_files();
  std::vector<Finding> out = {
      command_in_path("gcc", true, "compiles robot programs in C", "build-essential"),
      command_in_path("g++", true, "compiles robot programs in C++", "build-essential"),
      command_in_path("python3", false, "runs robot programs in Python", "python3"),
      own("libeyebridge", files.library, "build it: cmake --build --preset release"),
      own("eyebot.h", files.header, "the installation is not complete"),
      own("worlds", files.worlds, "the installation is not complete"),
      pseudo_terminals(),
      real_time_priority(),
  };
  const auto add = [&out](std::vector<Finding> findings) {
    for (Finding& finding : findings) out.push_back(std::move(finding));
  };
  add(examine_parts(root));
  add(judge_serial(look_at_serial(root)));
  out.push_back(udev_rule(root));
  const bool is_here = root == "/";
  add(judge_can(is_here ? look_at_can() : CanState{0, 0, can_interfaces(root, {})}));
  add(judge_cameras(look_at_cameras(root)));
  return out;
}

}  // namespace eyebridge::apps
