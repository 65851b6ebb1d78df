#pragma once

namespace CLI {
class App;
}

namespace eyebridge::apps {

// One function per subcommand of `eyebridge camera`, each in the source of its name: as in
// command.hpp.

void add_camera_record(CLI::App& camera, int& code);
void add_camera_show(CLI::App& camera, int& code);
void add_camera_calibrate(CLI::App& camera, int& code);
void add_camera_markers(CLI::App& camera, int& code);
void add_camera_list(CLI::App& camera, int& code);

}  // namespace eyebridge::apps
