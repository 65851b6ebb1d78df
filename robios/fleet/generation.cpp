#include "generation.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include <dlfcn.h>
#include <unistd.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::robios {
namespace {

/// The file of the library that this code is in.
std::filesystem::path this_library() {
  Dl_info library{};
  static const char here = 0;
  if (dladdr(&here, &library) == 0) return {};
  return std::filesystem::weakly_canonical(library.dli_fname);
}

bool this_is_classic() {
  return this_library().filename().string().starts_with("libeyebridge_classic");
}

}  // namespace

std::filesystem::path library_folder() { return this_library().parent_path(); }

bool is_of_other_generation(const std::filesystem::path& program) {
  std::ifstream stream(program, std::ios::binary);
  const std::string file{std::istreambuf_iterator<char>(stream), {}};
  // As the names of needed libraries stand in it.
  const std::string other = this_is_classic() ? std::string("\0libeyebridge.so", 16)
                                              : std::string("\0libeyebridge_classic.so", 24);
  return std::search(file.begin(), file.end(),
                     std::boyer_moore_horspool_searcher(other.begin(), other.end())) != file.end();
}

void become_launcher(bool other_generation, std::vector<std::string> words) {
  const bool is_classic = this_is_classic() != other_generation;
  std::string launcher =
      this_library().parent_path() / (is_classic ? "eyebridge-robots-classic" : "eyebridge-robots");
  std::vector<char*> argv{launcher.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  execv(launcher.c_str(), argv.data());
  throw ConfigError({launcher}, std::string("cannot be started for several robots: ") +
                                    std::strerror(errno) + "; expected it beside the library");
}

}  // namespace eyebridge::robios
