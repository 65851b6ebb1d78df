#include "parts.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include <dlfcn.h>
#include <unistd.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/own_place.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/camera/renderer.hpp"
#include "machine/system_files.hpp"
#include "own_files.hpp"
#include "program.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

/// In a build folder a part comes by building again, elsewhere by a package.
bool is_build_folder() {
  const fs::path share = share_folder();
  std::error_code error;
  return !share.empty() && fs::exists(share / "../../CMakeCache.txt", error);
}

/// The plug-in `name`; empty if it is not there.
fs::path plugin(const char* name) {
  const fs::path folder = plugin_folder();
  std::error_code error;
  return !folder.empty() && fs::exists(folder / name, error) ? folder / name : fs::path();
}

std::string remedy(const char* where_built, const char* where_installed) {
  return is_build_folder() ? where_built : where_installed;
}

std::string in_shell_quotes(std::string_view word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

struct Answer {
  bool is_fine = false;
  std::string last_line;  ///< Of what it printed on both outputs.
};

/// Runs a script with sh and waits for it.
Answer answer_of(const std::string& script) {
  std::string text;
  FILE* const pipe = popen(("{ " + script + "\n} 2>&1 </dev/null").c_str(), "r");
  if (pipe == nullptr) return {false, "sh cannot be started"};
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;) {
    text.append(part.data(), n);
  }
  const bool is_fine = pclose(pipe) == 0;
  const std::string_view all = trimmed(text);
  const std::size_t end = all.rfind('\n');
  return {is_fine, std::string(end == std::string_view::npos ? all : all.substr(end + 1))};
}

/// Why the plug-in `file` cannot be loaded; empty if it can. Not closed: Qt cannot be unloaded.
std::string load_error(const fs::path& file) {
  if (dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL) != nullptr) return "";
  const char* const error = dlerror();
  return error != nullptr ? error : "cannot be loaded";
}

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

Finding find_windows() {
  constexpr const char* kWhat = "windows";
  const fs::path file = plugin("libeyebridge_gui.so");
  if (file.empty()) {
    return {kWhat, false, false, "the environment, the editor and the code panel are not here",
            remedy("./run --gui", "apt install eyebridge-gui")};
  }
  if (const std::string why = load_error(file); !why.empty()) {
    return {kWhat, false, false, why,
            remedy("./run --gui", "apt install --reinstall eyebridge-gui")};
  }
  for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY"}) {
    if (is_set(variable)) return {kWhat, false, true, file.string(), ""};
  }
  return {kWhat, false, false, "no display: neither DISPLAY nor WAYLAND_DISPLAY is set",
          "ssh -X HOST, from a computer with a display"};
}

Finding find_python_module() {
  constexpr const char* kWhat = "import eyebridge";
  const fs::path folder = python_folder();
  if (folder.empty() || names_in(folder / "eyebridge", {"_core"}).empty()) {
    return {kWhat, false, false, "simulations and control files in Python are not here",
            remedy("apt install python3-dev pybind11-dev python3-numpy && ./run",
                   "apt install python3-eyebridge")};
  }
  const std::string python = python_of_modules();
  const Answer answer = answer_of("cd / && PYTHONPATH=" + in_shell_quotes(folder.string()) +
                                  "${PYTHONPATH:+:$PYTHONPATH} " + in_shell_quotes(python) +
                                  " -c 'import eyebridge; print(eyebridge.__file__)'");
  if (answer.is_fine) return {kWhat, false, true, python + ": " + answer.last_line, ""};
  const bool lacks_numpy = answer.last_line.find("numpy") != std::string::npos;
  return {kWhat, false, false, python + ": " + answer.last_line,
          lacks_numpy ? "apt install python3-numpy"
                      : remedy("./run", "apt install --reinstall python3-eyebridge")};
}

Finding find_mpi() {
  constexpr const char* kWhat = "MPI";
  const fs::path file = plugin("libeyebridge_mpi.so");
  if (file.empty()) {
    return {kWhat, false, false, "mpirun eyebridge sweep does not work: built without MPI",
            remedy("apt install libopenmpi-dev openmpi-bin && ./run",
                   "apt install --reinstall eyebridge")};
  }
  const Finding starter =
      command_in_path("mpirun", false, "runs a sweep on several computers", "openmpi-bin");
  if (!starter.found) return {kWhat, false, false, starter.detail, starter.remedy};
  if (const std::string why = load_error(file); !why.empty()) {
    return {kWhat, false, false, why, starter.remedy};
  }
  return {kWhat, false, true, starter.detail, ""};
}

Finding find_renderer() {
  constexpr const char* kWhat = "renderer";
  try {
    return {kWhat, false, true,
            camera::renderer_here() + ": camera pictures of simulated worlds need no display", ""};
  } catch (const ConfigError& error) {
    return {kWhat, false, false, error.text(), "apt install libegl1 libegl-mesa0"};
  }
}

Finding find_lab() {
  constexpr const char* kWhat = "lab";
#if defined(__x86_64__)
  const fs::path scripts = own_files().lab;
  std::error_code error;
  if (!fs::exists(scripts / "place.sh", error)) {
    return {kWhat, false, false, "expected its scripts in " + scripts.string(),
            remedy("./run", "apt install --reinstall eyebridge")};
  }
  // What its own script `run` looks at before it starts the kernel.
  const Answer answer = answer_of("here=" + in_shell_quotes(scripts.string()) + R"sh(
. "$here/place.sh"
for lab in "$cache/lab-$(kernel_hash)-"*; do
  [ -x "$lab/linux" ] && [ -x "$lab/$(init_name)" ] || continue
  has_room "$lab" || continue
  echo "$lab/linux" && exit 0
done
exit 1)sh");
  if (answer.is_fine) return {kWhat, false, true, answer.last_line, ""};
  return {kWhat, false, false,
          "a kernel with CAN and cameras for tests (eyebridge lab) is not built",
          (scripts / "build").string()};
#else
  return {kWhat, false, false, "its kernel exists for x86-64 processors only", ""};
#endif
}

/// ASan and TSan have fixed places for their own memory; a kernel that spreads memory wider puts
/// something there now and then, and the program ends before it starts.
Finding judge_sanitizers(const fs::path& root) {
  constexpr const char* kWhat = "sanitizers";
  constexpr long kMost = 28;
  const auto bits = number_of(below(root, "/proc/sys/vm/mmap_rnd_bits"));
  if (!bits) {
    return {kWhat, false, false,
            "this kernel has no vm.mmap_rnd_bits: programs with ASan or TSan may not start", ""};
  }
  const std::string found = "vm.mmap_rnd_bits is " + std::to_string(*bits);
  if (*bits <= kMost) return {kWhat, false, true, found + ": programs with ASan or TSan start", ""};
  return {kWhat, false, false,
          found + ", expected at most " + std::to_string(kMost) +
              ": programs with ASan or TSan end at their start now and then",
          "sudo sysctl vm.mmap_rnd_bits=" + std::to_string(kMost)};
}

}  // namespace

Finding command_in_path(const char* name, bool needed, const char* use, const char* package) {
  const fs::path found = find_in_path(name);
  if (!found.empty()) return {name, needed, true, found.string(), ""};
  return {name, needed, false, use, std::string("apt install ") + package};
}

std::vector<Finding> examine_parts(const fs::path& root) {
  return {find_windows(),  find_python_module(), find_mpi(),
          find_renderer(), find_lab(),           judge_sanitizers(root)};
}

}  // namespace eyebridge::apps
