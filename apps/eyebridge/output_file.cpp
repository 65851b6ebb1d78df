#include "output_file.hpp"

#include <cerrno>
#include <cstring>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::apps {

OutputFile open_output(const std::string& path, const char* flag) {
  OutputFile file(path.empty() ? nullptr : std::fopen(path.c_str(), "we"), &std::fclose);
  if (file == nullptr && !path.empty()) {
    throw ConfigError({flag}, "cannot write " + path + ": " + std::strerror(errno));
  }
  if (file != nullptr) std::setvbuf(file.get(), nullptr, _IOLBF, BUFSIZ);
  return file;
}

}  // namespace eyebridge::apps
