#include <CLI/CLI.hpp>

#include "camera_commands.hpp"
#include "command.hpp"

namespace eyebridge::apps {

void add_camera(CLI::App& root, int& code) {
  CLI::App* command = root.add_subcommand("camera", "Cameras: what there is, what they see");
  command->require_subcommand(1);
  add_camera_show(*command, code);
  add_camera_record(*command, code);
  add_camera_calibrate(*command, code);
  add_camera_markers(*command, code);
  add_camera_list(*command, code);
}

}  // namespace eyebridge::apps
