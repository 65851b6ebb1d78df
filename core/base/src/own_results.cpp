#include "eyebridge/base/own_results.hpp"

#include <fstream>
#include <string>
#include <system_error>

#include <sys/stat.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge {

void check_replaceable(const std::filesystem::path& path, std::string_view kind,
                       std::string_view beginning) {
  const auto refuse = [&](const std::string& found) {
    throw ConfigError({}, "cannot write " + path.string() + ": found " + found +
                              ", expected a new name, or an earlier " + std::string(kind) +
                              "; nothing else is replaced");
  };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return;
  if (std::filesystem::is_directory(status)) refuse("a folder");
  // A FIFO would wait for a reader; /dev/null and /dev/stdout hold nothing that could be lost.
  if (std::filesystem::is_character_file(status)) return;
  if (!std::filesystem::is_regular_file(status)) refuse("no regular file");
  std::ifstream file(path, std::ios::binary);
  std::string begin(beginning.size(), '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  if (!file.is_open()) refuse("a file that cannot be read");
  if (!begin.empty() && begin != beginning) refuse("another kind of file");
}

void drop_link(const std::filesystem::path& path) {
  std::error_code error;  // what cannot be removed cannot be written, and that is told
  if (!std::filesystem::is_symlink(path, error)) return;
  if (std::filesystem::is_character_file(path, error)) return;
  std::filesystem::remove(path, error);
}

bool is_still_at(const std::filesystem::path& path, int descriptor) {
  struct stat there {};
  struct stat ours {};
  return stat(path.c_str(), &there) == 0 && fstat(descriptor, &ours) == 0 &&
         there.st_dev == ours.st_dev && there.st_ino == ours.st_ino;
}

}  // namespace eyebridge
