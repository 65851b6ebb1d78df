#include "generation.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <string>

#include <unistd.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/own_place.hpp"
#include "eyebridge/base/read_file.hpp"
#include "robot_program.hpp"

namespace eyebridge::robios {
namespace {

bool this_is_classic() {
  return own_binary().filename().string().starts_with("libeyebridge_classic");
}

}  // namespace

bool is_of_other_generation(const DynamicNames& names) {
  const char* const other = this_is_classic() ? "libeyebridge.so" : "libeyebridge_classic.so";
  return std::ranges::any_of(names.libraries, [&](std::string_view library) {
    return library.starts_with(other);  // a version may follow
  });
}

bool is_of_other_generation(const std::filesystem::path& program) {
  const auto file = read_file(program, kLargestProgram);
  if (!file) return false;
  const auto names = dynamic_names(*file);
  return names && is_of_other_generation(*names);
}

void become_launcher(bool other_generation, std::vector<std::string> words) {
  const bool is_classic = this_is_classic() != other_generation;
  std::string launcher =
      plugin_folder() / (is_classic ? "eyebridge-robots-classic" : "eyebridge-robots");
  std::vector<char*> argv{launcher.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  execv(launcher.c_str(), argv.data());
  throw ConfigError({launcher}, std::string("cannot be started for several robots: ") +
                                    std::strerror(errno) +
                                    "; expected it where EyeBridge's plug-ins are");
}

}  // namespace eyebridge::robios
