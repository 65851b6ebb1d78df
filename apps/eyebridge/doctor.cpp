#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/hal/registry.hpp"
#include "machine.hpp"
#include "own_files.hpp"

namespace eyebridge::apps {
namespace {

struct DoctorFlags {
  std::string root = "/";
  bool udev = false;
};

void print_below(const std::string& line) { std::printf("%-25s %s\n", "", line.c_str()); }

int examine(const std::string& root) {
  if (!std::filesystem::is_directory(root)) {
    throw ConfigError({"--root"}, "found " + root + ", expected a folder");
  }
  bool all_needed = true;
  for (const Finding& finding : examine_machine(root)) {
    const char* verdict = finding.found ? "ok" : finding.needed ? "MISSING" : "none";
    std::printf("%-16s %-8s %s\n", finding.what.c_str(), verdict, finding.detail.c_str());
    if (!finding.found && !finding.remedy.empty()) print_below(finding.remedy);
    for (const std::string& line : finding.advice) print_below(line);
    all_needed = all_needed && (finding.found || !finding.needed);
  }
  std::puts("\nBackends (--hal):");
  for (const hal::BackendFactory& backend : hal::backend_table()) {
    std::printf("  %-14s %s\n", std::string(backend.scheme).c_str(),
                std::string(backend.summary).c_str());
  }
  return all_needed ? kFine : kFailed;
}

int print_udev_rule() {
  const std::filesystem::path file = own_files().udev;
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  if (text.str().empty()) {
    throw ConfigError({file.string()}, "the rule is not here: the installation is not complete");
  }
  std::fputs(text.str().c_str(), stdout);
  return kFine;
}

}  // namespace

void add_doctor(CLI::App& root, int& code) {
  CLI::App* command = root.add_subcommand("doctor", "Says what works on this machine");
  const auto flags = std::make_shared<DoctorFlags>();
  command->add_flag("--udev", flags->udev, "Prints the rule that lets people use boards");
  command->add_option("--root", flags->root, "Looks at devices below FOLDER instead of /")
      ->type_name("FOLDER");
  command->footer("Exit code 1 when something is missing that every robot program needs.");
  command->callback(
      [flags, &code] { code = flags->udev ? print_udev_rule() : examine(flags->root); });
}

}  // namespace eyebridge::apps
