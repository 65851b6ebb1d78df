#include "check_settings.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "eyebridge/base/log.hpp"
#include "eyebridge/files/error_rules.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/hal/hand.hpp"
#include "eyebridge/hal/registry.hpp"
#include "eyebridge/hal/shared_world.hpp"
#include "key_script.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const SourceLocation& where, const fs::path& path,
                         const std::string& reason) {
  throw ConfigError(where, fmt::format("cannot write {}: {}", path.string(), reason));
}

/// A file that the program will write into a folder that is there.
void check_file(const fs::path& file, const SourceLocation& where) {
  std::error_code error;
  if (!fs::exists(file, error)) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    if (access(folder.c_str(), W_OK | X_OK) != 0) refuse(where, file, std::strerror(errno));
    return;
  }
  if (fs::is_directory(file, error)) refuse(where, file, "it is a folder");
  if (access(file.c_str(), W_OK) != 0) refuse(where, file, std::strerror(errno));
}

/// Makes the folder, as the program would: nothing else tells whether that is possible.
void check_out(const fs::path& out, const SourceLocation& where) {
  std::error_code error;
  fs::create_directories(out, error);
  if (error) refuse(where, out, error.message());
  if (!fs::is_directory(out, error)) refuse(where, out, "it is no folder");
  check_file(out / "trace.csv", where);
}

}  // namespace

bool check_settings(const hal::Config& config) {
  NullLog log;
  files::named_robot(config.text("robot"), config.value("robot").where);
  files::read_error_rules(config.text("errors"), config.value("errors").where);
  hal::from_setting(config, "keys", robios::parse_key_script);
  const bool several = hal::programs_wanted(config) > 1;
  std::unique_ptr<hal::Backend> backend;
  // The program opens it again, which is free for a world but not for a board.
  // Without the person: that camera would be opened, too. Without the report: this world's time may
  // pass, and who runs many programs would take what it says for theirs.
  // With one robot; errors may be those of another one.
  hal::Config alone = config.with("drive", {{}, config.value("drive").where})
                          .with("report", {{}, config.value("report").where});
  if (several) alone = alone.with("errors", {{}, config.value("errors").where});
  if (!hal::opening_has_effects(config)) {
    backend = hal::open_backend({alone, log});
    hal::check_hand({config, log}, *backend);
  }
  hal::check_camera(config, backend.get(), log);
  if (config.is_set("report")) check_file(config.path("report"), config.value("report").where);
  if (config.is_set("out")) check_out(config.path("out"), config.value("out").where);
  return several;
}

}  // namespace eyebridge::apps
