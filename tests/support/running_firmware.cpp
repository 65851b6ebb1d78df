#include "running_firmware.hpp"

#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "eyebridge/base/units.hpp"

namespace eyebridge::testing {
namespace {

std::string text_after(const std::string& text, const std::string& before) {
  const std::size_t begin = text.find(before);
  if (begin == std::string::npos) throw std::runtime_error("expected '" + before + "' in " + text);
  return text.substr(begin + before.size());
}

}  // namespace

std::vector<std::string> firmware_command(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {kCommand, "firmware"});
  return arguments;
}

std::string firmware_hdt(std::vector<std::string> arguments) {
  arguments.emplace_back("--hdt");
  const ProgramRun run = run_program({firmware_command(std::move(arguments)), {}, ""});
  if (run.exit_code != 0) throw std::runtime_error(run.err);
  return run.out;
}

RunningFirmware::RunningFirmware(std::vector<std::string> arguments, const std::string& folder)
    : RunningProgram({firmware_command(std::move(arguments)), {}, folder}) {}

std::string RunningFirmware::hal() {
  wait_for("Ctrl-C ends\n");
  // "robot 1: eyebridge run --hal URL PROGRAM", then one line about all.
  const std::string url = text_after(said(), "--hal ");
  if (url.starts_with('\'')) return url.substr(1, url.find('\'', 1) - 1);  // as a shell takes it
  return url.substr(0, url.find(' '));
}

Pose RunningFirmware::stop() {
  finish(SIGTERM);
  const std::string place = text_after(said(), "robot 1 at ");
  double x = 0;
  double y = 0;
  double degrees = 0;
  if (std::sscanf(place.c_str(), "%lf mm %lf mm %lf degrees", &x, &y, &degrees) != 3) {
    throw std::runtime_error("expected the robot's place: " + place);
  }
  return {mm_to_m(x), mm_to_m(y), deg_to_rad(degrees)};
}

}  // namespace eyebridge::testing
