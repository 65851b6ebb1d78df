#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "eyebot.h"
#include "guarded.hpp"

namespace {

using namespace eyebridge;

constexpr std::size_t kOutput = 1024;  // bytes that the older form has for the output

Result<std::string> output_of(const char* command) {
  if (command == nullptr) return robios::null_pointer();
  struct Close {
    void operator()(std::FILE* pipe) const { pclose(pipe); }
  };
  const std::unique_ptr<std::FILE, Close> pipe(popen(command, "r"));
  if (!pipe) return fail(Errc::Unsupported, fmt::format("cannot run '{}'", command));
  std::string output;
  char chunk[4096];
  for (std::size_t n = 0; (n = std::fread(chunk, 1, sizeof chunk, pipe.get())) > 0;) {
    output.append(chunk, n);
  }
  return output;
}

/// What the robot's program was given last.
struct KeptOutput {
  std::string text;
};

}  // namespace

char* OSExecute(const char* command) {
  return robios::guarded(
      "OSExecute", static_cast<char*>(nullptr), [&](robios::Session& session) -> Result<char*> {
        return output_of(command).map([&](std::string output) {
          // Several robots may share a thread: each has its own.
          thread_local std::string of_thread;
          std::string& kept =
              session.runner() != nullptr ? session.own<KeptOutput>().text : of_thread;
          kept = std::move(output);
          return kept.data();
        });
      });
}

int EYEBRIDGEExecute(const char* command, char* output) {
  return robios::guarded("OSExecute", 1, [&](robios::Session&) -> Result<int> {
    if (output == nullptr) return robios::null_pointer();
    output[0] = '\0';
    return output_of(command).map([&](const std::string& text) {
      const std::size_t length = std::min(text.size(), kOutput - 1);
      std::memcpy(output, text.data(), length);
      output[length] = '\0';
      return 0;
    });
  });
}
