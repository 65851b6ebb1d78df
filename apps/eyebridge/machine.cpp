#include "machine.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <initializer_list>

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include "can_state.hpp"
#include "own_files.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

std::string joined(std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : " ") + name;
  return out;
}

/// Names in `folder` that begin with one of `prefixes`.
std::vector<std::string> names_in(const fs::path& folder,
                                  std::initializer_list<std::string_view> prefixes) {
  std::vector<std::string> out;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename();
    const auto begins = [&](std::string_view prefix) { return name.starts_with(prefix); };
    if (std::any_of(prefixes.begin(), prefixes.end(), begins)) out.push_back(name);
  }
  return out;
}

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

Finding devices(const char* what, std::initializer_list<std::string_view> prefixes,
                const char* absent, const char* remedy) {
  const auto names = names_in("/dev", prefixes);
  return {what, false, !names.empty(), names.empty() ? absent : joined(names), remedy};
}

Finding own(const char* what, const fs::path& path, const char* remedy) {
  const bool found = fs::exists(path);
  return {what, true, found, found ? path.string() : "expected " + path.string(), remedy};
}

}  // namespace

std::vector<Finding> examine_machine() {
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
      devices("serial boards", {"ttyACM", "ttyUSB"}, "no /dev/ttyACM* or /dev/ttyUSB*", ""),
  };
  for (Finding& finding : judge_can(look_at_can())) out.push_back(std::move(finding));
  out.push_back(devices("V4L2 cameras", {"video"}, "no /dev/video*",
                        "plug one in; apt install v4l-utils to look at it"));
  return out;
}

}  // namespace eyebridge::apps
