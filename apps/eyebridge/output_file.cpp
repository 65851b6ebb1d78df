#include "output_file.hpp"

#include <cerrno>
#include <cstring>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/own_results.hpp"

namespace eyebridge::apps {

OutputFile open_output(const std::string& path, const OutputKind& kind) {
  if (path.empty()) return {nullptr, &std::fclose};
  try {
    check_replaceable(path, kind.name, kind.header);
  } catch (const ConfigError& error) {
    throw ConfigError({kind.flag}, error.text());
  }
  OutputFile file(std::fopen(path.c_str(), "we"), &std::fclose);
  if (file == nullptr) {
    throw ConfigError({kind.flag}, "cannot write " + path + ": " + std::strerror(errno));
  }
  std::setvbuf(file.get(), nullptr, _IOLBF, BUFSIZ);
  std::fprintf(file.get(), "%s\n", kind.header);
  return file;
}

}  // namespace eyebridge::apps
