#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "recording_text.hpp"
#include "run.hpp"

namespace eyebridge::apps {
namespace {

struct RecordFlags {
  SettingFlags settings;
  std::string file;
  std::string show;
  std::vector<std::size_t> calls;  ///< At most one; 0 is all.
};

int show(const RecordFlags& flags, bool with_calls) {
  const hal::Recording recording = hal::read_recording(flags.show);
  const camera::FrameReader frames(flags.show);
  const std::string text = recording_summary(recording, frames.frames(), flags.show);
  std::fputs(printable(text).c_str(), stdout);
  if (with_calls) {
    const std::size_t most = flags.calls.empty() ? 0 : flags.calls.front();
    const std::size_t all = std::numeric_limits<std::size_t>::max();
    const std::string calls = recording_calls(recording, most == 0 ? all : most);
    std::fputs(("\n" + printable(calls)).c_str(), stdout);
  }
  return kFine;
}

[[noreturn]] void record(RecordFlags flags, const std::vector<std::string>& words) {
  if (flags.file.empty() || flags.file.front() == '-') {
    throw ConfigError({"record"},
                      "found no file, expected: eyebridge record FILE.ebrec [OPTIONS] "
                      "PROGRAM [ARGUMENTS], or --show FILE.ebrec");
  }
  if (flags.settings.contains("record")) {
    throw ConfigError({"--record"}, "found a second file, expected " + flags.file + " alone");
  }
  flags.settings["record"] = flags.file;
  run_words("record", flags.settings, words);
}

}  // namespace

void add_record(CLI::App& root, int& code) {
  CLI::App* command = root.add_subcommand(
      "record", "Runs a program and records every exchange: record FILE.ebrec PROGRAM");
  command->footer(
      "eyebridge record FILE.ebrec [OPTIONS] PROGRAM [ARGUMENTS] is the same as eyebridge run\n"
      "--record FILE.ebrec. The program runs again on a recording with --hal replay:FILE.ebrec.");
  command->prefix_command();
  const auto flags = std::make_shared<RecordFlags>();
  command->add_option("FILE", flags->file, "The recording, an SQLite file")->type_name("");
  CLI::Option* shown =
      command->add_option("--show", flags->show, "Shows what a recording holds")->type_name("FILE");
  CLI::Option* calls =
      command->add_option("--calls", flags->calls, "With --show: every call, or the first N")
          ->expected(0, 1)
          ->needs(shown)
          ->type_name("N");
  add_setting_flags(*command, flags->settings);
  command->callback([command, flags, shown, calls, &code] {
    if (shown->count() == 0) record(*flags, command->remaining());
    if (!flags->file.empty() || !command->remaining().empty()) {
      throw ConfigError({"--show"}, "found a program, too; expected eyebridge record --show FILE");
    }
    code = show(*flags, calls->count() > 0);
  });
}

}  // namespace eyebridge::apps
