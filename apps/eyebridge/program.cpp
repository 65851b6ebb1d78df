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
#include "eyebridge/base/robot_program.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code ignored;  // A folder that may not be searched holds nothing for us.
  return fs::exists(path, ignored);
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

fs::path find_program(const std::string& name) {
  if (name.empty()) throw ConfigError({"program"}, "found an empty name, expected a robot program");
  if (name.find('/') != std::string::npos || is_there(name)) {
    fs::path program = name.find('/') != std::string::npos ? fs::path(name) : "." / fs::path(name);
    if (!is_there(program)) throw ConfigError({name}, "no such program");
    if (const std::string why = trouble_with(program); !why.empty()) {
      throw ConfigError({program.string()}, why);
    }
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
  if (config != nullptr) variables[hal::kPlanVariable] = config->plan();
  const std::vector<std::string> environment = environment_with(variables);
  execute(pointers_to(words).data(), pointers_to(environment).data());
  const int error = errno;
  const char* reason = error == ENOEXEC
                           ? "neither a program for this machine nor a script that starts with #!"
                           : std::strerror(error);
  throw ConfigError({words.front()}, std::string("cannot be started: ") + reason);
}

}  // namespace eyebridge::apps
