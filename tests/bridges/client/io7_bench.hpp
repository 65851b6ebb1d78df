#pragma once

#include <utility>

#include "../protocol/fake_board.hpp"
#include "eyebridge/bridges/client/io7_client.hpp"
#include "kept_log.hpp"
#include "scripted_line.hpp"

namespace eyebridge::bridges::testing {

using namespace std::chrono_literals;

/// A client on virtual time, in front of a board that answers within 1 ms, until told otherwise.
struct Io7Bench {
  Io7Bench() { plug_in(); }

  /// A new line to the board, as after plugging in; the board has booted.
  void plug_in() {
    line = std::make_shared<ScriptedLine>(clock);
    line->on_write = [this](ScriptedLine& its_line, const std::string& sent) {
      const auto answer =
          board.answer({reinterpret_cast<const std::uint8_t*>(sent.data()), sent.size()});
      const std::string text(answer.begin(), answer.end());
      if (damage && !text.empty()) {
        std::exchange(damage, {})(its_line, text);
      } else {
        its_line.arrive(text, 1ms);
      }
    };
  }
  StreamOpener opener() {
    return [this]() -> Result<std::unique_ptr<ByteStream>> {
      ++opened;
      if (line->gone) return fail(Errc::Disconnected, "script: no such device");
      return std::make_unique<ScriptedStream>(line);
    };
  }
  /// What is sent while `act` runs.
  template <class Act>
  std::string sent_by(Act&& act) {
    const std::size_t before = line->sent.size();
    act();
    return line->sent.substr(before);
  }

  FakeClock clock;
  KeptLog log;
  io7::FakeBoard board;
  std::shared_ptr<ScriptedLine> line;
  /// Delivers the next answer instead of the bench.
  std::function<void(ScriptedLine&, const std::string& answer)> damage;
  int opened = 0;
  Io7Settings settings;
  Io7Client client{opener(), clock, log, settings};
};

}  // namespace eyebridge::bridges::testing
