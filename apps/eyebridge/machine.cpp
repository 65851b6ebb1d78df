#include "machine.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <thread>

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include "eyebridge/base/thread_priority.hpp"
#include "machine/cameras.hpp"
#include "machine/can_state.hpp"
#include "machine/serial_ports.hpp"
#include "machine/system_files.hpp"
#include "own_files.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

Finding command(const char* name, bool needed, const char* use, const char* package) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const fs::path candidate = fs::path(rest.substr(0, end)) / name;
    if (access(candidate.c_str(), X_OK) == 0) return {name, needed, true, candidate.string(), ""};
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return {name, needed, false, use, std::string("apt install ") + package};
}

Finding library(const char* what, std::initializer_list<const char*> names, const char* use,
                const char* package) {
  for (const char* name : names) {
    if (void* handle = dlopen(name, RTLD_LAZY | RTLD_LOCAL)) {
      dlclose(handle);
      return {what, false, true, name, ""};
    }
  }
  return {what, false, false, use, std::string("apt install ") + package};
}

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
  for (const char* folder : {"/etc/udev/rules.d", "/run/udev/rules.d", "/usr/lib/udev/rules.d"}) {
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
      command("gcc", true, "compiles robot programs in C", "build-essential"),
      command("g++", true, "compiles robot programs in C++", "build-essential"),
      command("python3", false, "runs robot programs in Python", "python3"),
      own("libeyebridge", files.library, "build it: cmake --build --preset release"),
      own("eyebot.h", files.header, "the installation is not complete"),
      own("worlds", files.worlds, "the installation is not complete"),
      library("OSMesa", {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"},
              "renders camera pictures without a display", "libosmesa6"),
      library("EGL", {"libEGL.so.1"}, "renders camera pictures where there is no OSMesa",
              "libegl1"),
      pseudo_terminals(),
      real_time_priority(),
  };
  const auto add = [&out](std::vector<Finding> findings) {
    for (Finding& finding : findings) out.push_back(std::move(finding));
  };
  add(judge_serial(look_at_serial(root)));
  out.push_back(udev_rule(root));
  const bool is_here = root == "/";
  add(judge_can(is_here ? look_at_can() : CanState{0, 0, can_interfaces(root, {})}));
  add(judge_cameras(look_at_cameras(root)));
  return out;
}

}  // namespace eyebridge::apps
