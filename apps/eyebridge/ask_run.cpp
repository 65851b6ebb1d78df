#include "ask_run.hpp"

#include <cstdio>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/log.hpp"

namespace eyebridge::apps {
namespace {

/// The control socket of the run `wanted`, or of the only one when that is 0.
UniqueFd find_run(const char* command, pid_t wanted) {
  if (wanted != 0) {
    UniqueFd socket = robios::connect_to_run(wanted);
    if (socket.valid()) return socket;
    throw ConfigError({"--run"}, fmt::format("found {}, expected the process of a run in a "
                                             "simulated world",
                                             wanted));
  }
  UniqueFd found;
  std::vector<pid_t> there;
  for (const pid_t pid : robios::controllable_runs()) {
    UniqueFd socket = robios::connect_to_run(pid);
    if (!socket.valid()) continue;
    there.push_back(pid);
    found = std::move(socket);
  }
  if (there.size() == 1) return found;
  if (there.empty()) {
    throw ConfigError({command},
                      "found no run in a simulated world, expected one of this user: start a "
                      "program first");
  }
  throw ConfigError({command}, fmt::format("found {} runs, expected one: --run {} says which",
                                           there.size(), fmt::join(there, " or --run ")));
}

}  // namespace

int ask_run(const char* command, pid_t wanted, const robios::Words& words) {
  const UniqueFd socket = find_run(command, wanted);
  if (!robios::send_words(socket, words)) {
    throw ConfigError({command}, fmt::format("the run could not be told: expected at most {} bytes "
                                             "of words, and a run that has not ended",
                                             robios::kLongestMessage));
  }
  const auto answer = robios::receive_words(socket);
  if (!answer || answer->size() != 2) {
    tell("the run has ended");
    return kFailed;
  }
  if (answer->front() == "ok") {
    std::printf("%s\n", answer->back().c_str());
    return kFine;
  }
  tell(answer->back());
  return kFailed;
}

}  // namespace eyebridge::apps
