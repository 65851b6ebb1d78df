#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "camera_commands.hpp"
#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "machine/cameras.hpp"

namespace eyebridge::apps {

void add_camera_list(CLI::App& parent, int& code) {
  CLI::App* command =
      parent.add_subcommand("list", "Tells the live cameras, what they offer and who uses them");
  const auto root = std::make_shared<std::string>("/");
  command->add_option("--root", *root, "Looks at devices below FOLDER instead of /")
      ->type_name("FOLDER");
  command->footer("Exit code 1 when there is no camera.");
  command->callback([root, &code] {
    if (!std::filesystem::is_directory(*root)) {
      throw ConfigError({"--root"}, "found " + *root + ", expected a folder");
    }
    const std::vector<Camera> cameras = look_at_cameras(*root);
    std::fputs(printable(table_of(cameras)).c_str(), stdout);
    const bool any = std::ranges::any_of(
        cameras, [](const Camera& one) { return one.device.kind == camera::DeviceKind::Camera; });
    code = any ? kFine : kFailed;
  });
}

}  // namespace eyebridge::apps
