#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "commit.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/log.hpp"

namespace {

int run(int argc, char** argv) {
  using namespace eyebridge::apps;
  int code = kFine;
  CLI::App app{"Runs programs for small mobile robots (RoBIOS) in a simulated world.", "eyebridge"};
  app.set_version_flag("--version",
                       "eyebridge " EYEBRIDGE_VERSION " (" + std::string(commit()) + ")");
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 fine, 1 failed while running, 2 bad input (nothing was run).\n"
      "eyebridge COMMAND --help says more.");
  add_run(app, code);
  add_add(app, code);
  add_remove(app, code);
  add_record(app, code);
  add_sweep(app, code);
  add_assess(app, code);
  add_probe(app, code);
  add_firmware(app, code);
  add_world(app, code);
  add_camera(app, code);
  add_trust(app, code);
  add_config(app, code);
  add_doctor(app, code);
  add_lab(app, code);
  add_edit(app);
  add_completion(app, code);
  add_manual(app, code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {  // --help, --version
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    eyebridge::tell(std::string(error.what()) + "\nSee eyebridge --help.");
    return kBadInput;
  }
  return code;
}

/// `code`, or a failure where what was printed did not arrive: a full disk behind "> FILE".
int told(int code) {
  const bool arrived = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (arrived || code != eyebridge::apps::kFine) return code;
  eyebridge::tell("what it printed could not be written in full: is the disk full?");
  return eyebridge::apps::kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return told(run(argc, argv));
  } catch (const eyebridge::ConfigError& error) {
    eyebridge::tell(error.what());
    return eyebridge::apps::kBadInput;
  } catch (const std::exception& error) {
    eyebridge::tell(error.what());
    return eyebridge::apps::kFailed;
  }
}
