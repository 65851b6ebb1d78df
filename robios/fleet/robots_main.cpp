// What the launcher (launcher.c) runs.

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>  // each image gets a copy of std::cout & co., which must be there by then
#include <string>
#include <vector>

#include <fmt/format.h>

#include "eyebridge/base/log.hpp"
#include "eyebridge/camera/prepare_process.hpp"
#include "fleet.hpp"
#include "program_threads.hpp"

__attribute__((visibility("default"))) int EYEBRIDGERobotsMain(int argc, char** argv,
                                                               eyebridge_robot_calls* calls) {
  using eyebridge::robios::Fleet;
  try {
    eyebridge::robios::leave_program_threads();
    eyebridge::camera::prepare_process();
    std::vector<std::string> words(argv, argv + argc);
    // Never destroyed: threads of programs may still run when the process ends.
    auto* const fleet = new Fleet(
        eyebridge::hal::Config::from_process(words.empty() ? "" : words.front()), words, *calls);
    return fleet->run();
  } catch (const eyebridge::ConfigError& error) {
    eyebridge::tell(error.what());
    return 2;
  } catch (const std::exception& error) {
    eyebridge::tell(fmt::format("the robots cannot be started: {}", error.what()));
    return 1;
  }
}
