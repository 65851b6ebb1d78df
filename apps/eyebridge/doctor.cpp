#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "eyebridge/hal/registry.hpp"
#include "machine.hpp"

namespace eyebridge::apps {
namespace {

int doctor() {
  bool all_needed = true;
  for (const Finding& finding : examine_machine()) {
    const char* verdict = finding.found ? "ok" : finding.needed ? "MISSING" : "none";
    std::printf("%-16s %-8s %s\n", finding.what.c_str(), verdict, finding.detail.c_str());
    if (!finding.found && !finding.remedy.empty()) {
      std::printf("%-25s %s\n", "", finding.remedy.c_str());
    }
    all_needed = all_needed && (finding.found || !finding.needed);
  }
  std::puts("\nBackends (--hal):");
  for (const hal::BackendFactory& backend : hal::backend_table()) {
    std::printf("  %-14s %s\n", std::string(backend.scheme).c_str(),
                std::string(backend.summary).c_str());
  }
  return all_needed ? kFine : kFailed;
}

}  // namespace

void add_doctor(CLI::App& root, int& code) {
  CLI::App* command = root.add_subcommand("doctor", "Says what works on this machine");
  command->footer("Exit code 1 when something is missing that every robot program needs.");
  command->callback([&code] { code = doctor(); });
}

}  // namespace eyebridge::apps
