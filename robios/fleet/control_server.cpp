#include "control_server.hpp"

#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <pthread.h>

#include "eyebridge/base/deaf_thread.hpp"
#include "eyebridge/base/robot_program.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::robios {
namespace {

// Who connects and says nothing must not keep others out.
constexpr int kVisitorPatience_s = 2;
constexpr double kFarthest = 1e7;  // mm or degrees: what is more is a slip of the pen

double number_in(const std::string& word, const char* what) {
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc() && stop == end && std::abs(value) <= kFarthest) return value;
  throw ConfigError({what}, fmt::format("found {}, expected a number -{:.0f} ... {:.0f}",
                                        in_quotes(word), kFarthest, kFarthest));
}

}  // namespace

hal::Newcomer read_newcomer(const Words& words, const hal::SharedWorld& world) {
  if (words.size() < 4)
    throw ConfigError({"robot"}, "expected MODEL x y phi [PROGRAM [ARGUMENTS]]");
  hal::Newcomer newcomer;
  newcomer.pose = {mm_to_m(number_in(words[1], "x")), mm_to_m(number_in(words[2], "y")),
                   wrap_angle(deg_to_rad(number_in(words[3], "phi")))};
  newcomer.model = world.model(words[0]);
  if (words.size() == 4) return newcomer;
  newcomer.program = words[4];
  newcomer.arguments.assign(words.begin() + 5, words.end());
  if (const std::string why = trouble_with(newcomer.program); !why.empty()) {
    throw ConfigError({newcomer.program}, why);
  }
  return newcomer;
}

std::size_t read_leaver(const Words& words) {
  if (words.size() != 2) throw ConfigError({kRemove}, "expected the number of a robot");
  std::size_t number = 0;
  const char* const end = words[1].data() + words[1].size();
  const auto [stop, error] = std::from_chars(words[1].data(), end, number);
  if (error == std::errc() && stop == end && number >= 1) return number - 1;
  throw ConfigError({kRemove}, fmt::format("found {}, expected the number of a robot, from 1",
                                           in_quotes(words[1])));
}

ControlServer::ControlServer(Act act, LogSink& log)
    : act_(std::move(act)), control_(open_control_socket()) {
  if (!control_.valid()) {
    log.write(Severity::Info,
              "no robot can be added: expected $XDG_RUNTIME_DIR/eyebridge, or a folder in /tmp, to "
              "be this user's alone");
    return;
  }
  deaf_thread([this] {
    pthread_setname_np(pthread_self(), "eb:control");
    answer_all();
  }).detach();
}

void ControlServer::answer_all() {
  for (;;) {
    const UniqueFd visitor = accept_next(control_);
    if (!visitor.valid()) return;
    const auto words = receive_words(visitor, kVisitorPatience_s);
    const std::lock_guard lock(answering_);
    if (words) send_words(visitor, answer(*words));
  }
}

Words ControlServer::answer(const Words& words) {
  const Result<std::size_t> index = act_(words);
  if (index) return {"ok", std::to_string(*index + 1)};
  return {"error", index.error().what};
}

}  // namespace eyebridge::robios
