#include "program.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/own_place.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code ignored;  // A folder that may not be searched holds nothing for us.
  return fs::exists(path, ignored);
}

/// Throws unless `program` can be started.
void check(const fs::path& program) {
  const SourceLocation where{program.string()};
  std::error_code ignored;
  if (fs::is_directory(program, ignored)) {
    throw ConfigError(where, "found a folder, expected a robot program");
  }
  if (is_python(program)) {
    if (access(program.c_str(), R_OK) != 0) {
      throw ConfigError(where, std::string("cannot be read: ") + std::strerror(errno));
    }
    if (python_folder().empty()) {
      throw ConfigError(where,
                        "found no Python packages of this EyeBridge, which a program in Python "
                        "needs: install python3-eyebridge, or build with EYEBRIDGE_WITH_PYTHON=ON");
    }
  } else if (access(program.c_str(), X_OK) != 0) {
    throw ConfigError(where,
                      std::string("not executable (") + std::strerror(errno) +
                          "); expected a program built with eyebridge-cc, or a Python file (.py)");
  }
}

/// Whatever Python starts from here on, a script with #! too, finds our packages first.
void offer_python_packages() {
  std::string folders = python_folder().string();
  if (folders.empty()) return;
  if (const char* others = std::getenv("PYTHONPATH"); others != nullptr && *others != '\0') {
    folders += std::string(":") + others;
  }
  setenv("PYTHONPATH", folders.c_str(), 1);
}

/// Becomes the program words[0]; python3 is that of PATH.
[[noreturn]] void become_words(std::vector<std::string> words) {
  offer_python_packages();
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  // Not execvp for a program itself: it would hand what the kernel refuses to sh.
  if (words.front().find('/') == std::string::npos) {
    execvp(argv.front(), argv.data());
  } else {
    execv(argv.front(), argv.data());
  }
  const int error = errno;
  const char* reason = error == ENOEXEC
                           ? "neither a program for this machine nor a script that starts with #!"
                           : std::strerror(error);
  throw ConfigError({words.front()}, std::string("cannot be started: ") + reason);
}

}  // namespace

fs::path find_in_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    fs::path candidate = fs::path(rest.substr(0, end)) / name;
    if (end > 0 && access(candidate.c_str(), X_OK) == 0 && !fs::is_directory(candidate)) {
      return candidate;
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return {};
}

std::string python_of_modules() {
  const char* const environment = std::getenv("VIRTUAL_ENV");
  const bool is_own = environment != nullptr && *environment != '\0';
  return !is_own && access(EYEBRIDGE_PYTHON, X_OK) == 0 ? EYEBRIDGE_PYTHON : "python3";
}

bool is_python(const fs::path& program) { return program.extension() == ".py"; }

fs::path find_program(const std::string& name) {
  if (name.empty()) throw ConfigError({"program"}, "found an empty name, expected a robot program");
  if (name.find('/') != std::string::npos || is_there(name)) {
    fs::path program = name.find('/') != std::string::npos ? fs::path(name) : "." / fs::path(name);
    if (!is_there(program)) throw ConfigError({name}, "no such program");
    check(program);
    return program;
  }
  fs::path program = find_in_path(name);
  if (program.empty()) {
    throw ConfigError({name}, "no such program in this folder or in PATH");
  }
  return program;
}

void become(const fs::path& program, const std::vector<std::string>& arguments) {
  std::vector<std::string> words;
  // Through our package, so that it is ours even beside another eye.py, and its time from the
  // start.
  if (is_python(program)) words = {"python3", (python_folder() / "eye").string()};
  words.push_back(program.string());
  words.insert(words.end(), arguments.begin(), arguments.end());
  become_words(std::move(words));
}

void become_control(const fs::path& program, const std::vector<std::string>& arguments) {
  // -P: a folder `eyebridge` where the user is is not our package.
  std::vector<std::string> words{python_of_modules(), "-P", "-m", "eyebridge.control",
                                 program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  become_words(std::move(words));
}

}  // namespace eyebridge::apps
