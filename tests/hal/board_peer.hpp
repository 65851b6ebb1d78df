#pragma once

#include <array>
#include <cstdlib>
#include <map>
#include <string>

#include "../bridges/client/kept_log.hpp"
#include "../bridges/client/scripted_line.hpp"
#include "../bridges/protocol/fake_board.hpp"
#include "board/board_backend.hpp"
#include "board/io7_link.hpp"
#include "borrowed_clock.hpp"

namespace eyebridge::hal::testing {

using namespace std::chrono_literals;
using bridges::testing::FakeClock;
using bridges::testing::KeptLog;
using bridges::testing::ScriptedLine;
using bridges::testing::ScriptedStream;

/// A whole IO7 board on virtual time: what FakeBoard answers, and encoders, motors and servos that
/// remember what they were told. Answers take 1 ms.
struct BoardPeer {
  explicit BoardPeer(std::string more_letters = "M d e s S") : letters(std::move(more_letters)) {
    for (const char letter : letters) {
      if (letter != ' ') board.list += std::string(1, letter) + " more\r\n";
    }
    plug_in();
  }

  void plug_in() {
    line = std::make_shared<ScriptedLine>(clock);
    line->on_write = [this](ScriptedLine& to, const std::string& sent) { answer(to, sent); };
  }

  void answer(ScriptedLine& to, const std::string& sent) {
    std::array<int, 3> number{};
    const bool known = !sent.empty() && letters.find(sent[0]) != std::string::npos;
    if (!known && !sent.starts_with("m ")) {
      const auto reply =
          board.answer({reinterpret_cast<const std::uint8_t*>(sent.data()), sent.size()});
      return to.arrive({reinterpret_cast<const char*>(reply.data()), reply.size()}, 1ms);
    }
    const char* rest = sent.c_str() + 1;
    for (int& value : number) {
      char* end = nullptr;
      value = static_cast<int>(std::strtol(rest, &end, 10));
      rest = end;
    }
    told += sent;
    if (sent[0] == 'm' || sent[0] == 'M') motor[number[0]] = number[1];
    if (sent[0] != 'e' || (mute > 0 && mute-- > 0)) return;
    if (rolls) roll();
    const Time late = number[0] == 2 ? std::exchange(stall, Time{0}) : Time{0};
    if (late > Time{0}) {  // the request is under way for so long
      clock.spend(late);
      roll();
    }
    const auto count = static_cast<unsigned>(encoder[number[0]]);
    const unsigned bits = count ^ std::exchange(flip, 0U);
    const std::array bytes = {static_cast<char>(bits >> 8U & 0xFFU),
                              static_cast<char>(bits & 0xFFU)};
    to.arrive({bytes.data(), bytes.size()}, 1ms);
  }

  /// The wheels turn as they were told last, up to now.
  void roll() {
    const Time passed = clock.now() - std::exchange(rolled, clock.now());
    for (const int id : {1, 2}) {
      turned[id] += motor[id] * to_seconds(passed) * 100;
      encoder[id] = static_cast<int>(std::lround(turned[id]));
    }
  }

  std::unique_ptr<BoardBackend> make_backend(const BoardTables& tables) {
    auto client = std::make_unique<bridges::Io7Client>(
        [this]() -> Result<std::unique_ptr<bridges::ByteStream>> {
          if (line->gone) return fail(Errc::Disconnected, "script: no such device");
          return std::make_unique<ScriptedStream>(line);
        },
        clock, log);
    if (!client->connect()) return nullptr;
    auto link = std::make_unique<Io7Link>(std::move(client), clock, tables);
    return std::make_unique<BoardBackend>(std::make_unique<BorrowedClock>(clock), std::move(link),
                                          tables);
  }
  /// `span` passes, as the backend's thread would live it.
  void live(BoardBackend& backend, Time span) {
    for (const Time end = clock.now() + span; clock.now() < end; clock.spend(10ms)) backend.step();
  }

  FakeClock clock;
  KeptLog log;
  std::string letters;
  bridges::io7::FakeBoard board;
  std::shared_ptr<ScriptedLine> line;
  std::map<int, int> motor;      ///< Last number of `m` or `M`, by motor.
  std::map<int, int> encoder;    ///< Counts, by encoder; 16 bits of them are told.
  bool rolls = false;            ///< The wheels turn with the time; else as a test says.
  Time rolled{0};                ///< Until when they have.
  std::map<int, double> turned;  ///< How far, in ticks.
  int mute = 0;                  ///< So many next counts are not told.
  Time stall{0};                 ///< How late the next count of encoder 2 is.
  unsigned flip = 0;             ///< Bits that are inverted in the next count.
  std::string told;              ///< Everything with letters that FakeBoard has not.
};

}  // namespace eyebridge::hal::testing
