#include "program.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/exec_words.hpp"
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

void become(const std::vector<std::string>& words, const hal::Config* config) {
  std::map<std::string, std::string> variables = python_variables();
  if (config != nullptr) variables["EYEBRIDGE_PLAN"] = config->plan();
  const std::vector<std::string> environment = environment_with(variables);
  execute(pointers_to(words).data(), pointers_to(environment).data());
  const int error = errno;
  const char* reason = error == ENOEXEC
                           ? "neither a program for this machine nor a script that starts with #!"
                           : std::strerror(error);
  throw ConfigError({words.front()}, std::string("cannot be started: ") + reason);
}

}  // namespace eyebridge::apps
