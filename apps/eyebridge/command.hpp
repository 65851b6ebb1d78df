#pragma once

namespace CLI {
class App;
}

namespace eyebridge::apps {

/// What a process ends with: the same numbers for every subcommand and every robot program.
enum ExitCode : int {
  kFine = 0,
  kFailed = 1,    ///< Something went wrong while running.
  kBadInput = 2,  ///< A flag, file or program is wrong; nothing was run.
};

// One function per subcommand, each in the source of its name: adds it to `root`. When it is chosen
// and parsed, it runs and stores its exit code in `code`; a ConfigError passes through to main().

void add_run(CLI::App& root, int& code);
void add_add(CLI::App& root, int& code);
void add_remove(CLI::App& root, int& code);
void add_record(CLI::App& root, int& code);
void add_sweep(CLI::App& root, int& code);
void add_assess(CLI::App& root, int& code);
void add_probe(CLI::App& root, int& code);
void add_firmware(CLI::App& root, int& code);
void add_world(CLI::App& root, int& code);
void add_camera(CLI::App& root, int& code);
void add_trust(CLI::App& root, int& code);
void add_config(CLI::App& root, int& code);
void add_doctor(CLI::App& root, int& code);
void add_lab(CLI::App& root, int& code);
void add_edit(CLI::App& root);
void add_completion(CLI::App& root, int& code);
void add_manual(CLI::App& root, int& code);

}  // namespace eyebridge::apps
