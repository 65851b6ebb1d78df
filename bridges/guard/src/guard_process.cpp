#include "guard_process.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <span>
#include <string_view>
#include <utility>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "eyebridge/base/sent_descriptor.hpp"
#include "eyebridge/bridges/guard/line_guard.hpp"
#include "guard_words.hpp"
#include "held_line.hpp"
#include "report.hpp"

namespace eyebridge::bridges {
namespace {

using namespace std::chrono_literals;

constexpr int kWords = 0;
constexpr int kProgram = 1;
constexpr Time kRound = 50ms;   // between two attempts to stop a robot that does not answer
constexpr Time kPatience = 1s;  // then it is said that it does not answer
constexpr Time kGiveUp = 2min;  // by then somebody has switched it off
// Of the answers that come two may be to what the program had asked.
constexpr int kAnswers = 3;

Time now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

int milliseconds(Time time) { return time <= Time{0} ? 0 : static_cast<int>((time + 999us) / 1ms); }

/// Finds the robot's answer in what it sends.
class Answer {
 public:
  explicit Answer(const StopOrders& orders) : orders_(orders) {}

  /// How often it came in `read`, the bytes of one read().
  int count_in(std::span<const std::uint8_t> read) {
    const std::size_t size = orders_.answer.size;
    if (size == 0) return 0;
    if (orders_.frames) return read.size() >= size && fits(read.first(size)) ? 1 : 0;
    int count = 0;
    for (const std::uint8_t byte : read) {
      std::memmove(window_.data(), window_.data() + 1, size - 1);
      window_[size - 1] = byte;
      seen_ = seen_ < size ? seen_ + 1 : size;
      if (seen_ < size || !fits({window_.data(), size})) continue;
      ++count;
      seen_ = 0;
    }
    return count;
  }

 private:
  [[nodiscard]] bool fits(std::span<const std::uint8_t> bytes) const {
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      if (((bytes[i] ^ orders_.answer.bytes[i]) & orders_.mask.bytes[i]) != 0) return false;
    }
    return true;
  }

  const StopOrders& orders_;
  decltype(StopOrders::Bytes::bytes) window_{};
  std::size_t seen_ = 0;
};

class Guard {
 public:
  [[noreturn]] void run() {
    while (true) {
      std::array<pollfd, 2> files{{{kWords, POLLIN, 0}, {kProgram, POLLIN, 0}}};
      const bool watches =
          state_ == State::Turning && line_.is_open() && !word_.orders.has_watchdog;
      const int patience = watches ? milliseconds(heard_ + LineGuard::kSilence - now()) : -1;
      const int count = ::poll(files.data(), files.size(), patience);
      if (count < 0) continue;
      if (count == 0) {
        stop_silent();
      } else if (files[0].revents != 0) {
        if (!take_word()) end();
      } else {
        end();
      }
    }
  }

 private:
  enum class State { Fresh, Turning, Still };
  enum class Outcome { Stands, ProgramIsBack, ProgramIsGone, Taken, GaveUp };

  /// False when no more will come.
  bool take_word() {
    GuardWord word;
    UniqueFd line;
    if (receive_with_descriptor(kWords, std::as_writable_bytes(std::span(&word, 1)), line) <= 0) {
      return false;
    }
    heard_ = now();
    switch (word.kind) {
      case GuardWord::Kind::Hold: {
        word_ = word;
        line_.hold(std::move(line), word_.device);
        state_ = State::Fresh;
        break;
      }
      case GuardWord::Kind::LetGo: {
        line_.close();
        const char done = 0;
        static_cast<void>(::send(kWords, &done, 1, MSG_NOSIGNAL));
        break;
      }
      case GuardWord::Kind::Turning:
        state_ = State::Turning;
        break;
      case GuardWord::Kind::Still:
        state_ = State::Still;
        break;
    }
    return true;
  }

  /// Nobody hears the program any more.
  [[noreturn]] void end() {
    const bool says = state_ == State::Turning;
    if (state_ != State::Still && word_.orders.count > 0) {
      began_ = now();
      if (says) say({"the program is gone, and wheels may turn: they are told to stand"});
      if (!says && has_reader()) let_reader_go();
      const Outcome outcome = stop(false, says);
      if (says && outcome == Outcome::Stands) say_stands();
    }
    ::_exit(0);
  }

  void stop_silent() {
    began_ = now();
    say(
        {"the program has been silent for half a second while wheels turn: they are told to "
         "stand"});
    const Outcome outcome = stop(true, true);
    if (outcome == Outcome::ProgramIsGone) return;  // and wheels may still turn
    if (outcome == Outcome::Stands) say_stands();
    if (outcome == Outcome::ProgramIsBack) say({"the program is back"});
    // Until it says that they turn again.
    state_ = State::Fresh;
  }

  Outcome stop(bool until_word, bool says) {
    Answer answer(word_.orders);
    int answers = 0;
    bool told = !says;
    bool is_known = true;  ///< That the line leads to the robot.
    if (!until_word) line_.yield();
    while (now() - began_ < kGiveUp) {
      const Time start = now();
      if (until_word) {
        pollfd word{kWords, POLLIN, 0};
        if (::poll(&word, 1, 0) > 0) {
          return (word.revents & POLLHUP) != 0 ? Outcome::ProgramIsGone : Outcome::ProgramIsBack;
        }
      }
      const bool was_open = line_.is_open();
      if (line_.reopen()) {
        if (!until_word && (is_taken_ || line_.is_taken())) {
          if (says) say({"another program has the robot now"});
          return Outcome::Taken;
        }
        is_known = is_known && was_open;
        if (!is_known && word_.orders.question.size > 0) {
          line_.write(word_.orders.question.view());
          is_known = listen(answer, start + kRound) > 0;
          continue;
        }
        for (std::size_t i = 0; i < word_.orders.count; ++i) {
          line_.write(word_.orders.writes[i].view());
        }
        const int found = listen(answer, start + kRound);
        answers += found;
        if (answers >= kAnswers) return Outcome::Stands;
        if (found == 0 && word_.orders.completion.size > 0) {
          line_.write(word_.orders.completion.view());
          answers += listen(answer, now() + kRound);
        }
      }
      if (answers == 0 && !told && now() - began_ > kPatience) {
        told = true;
        tell_of_silence(until_word);
      }
      if (!line_.is_open()) ::poll(nullptr, 0, milliseconds(start + kRound - now()));
    }
    if (says) say({"it has not answered for two minutes; its motors may still run"});
    return Outcome::GaveUp;
  }

  /// Until an answer has come, another program has the robot, or `end`; how many answers came.
  int listen(Answer& answer, Time end) {
    std::array<std::uint8_t, 256> buffer{};
    while (line_.is_open()) {
      pollfd line{line_.descriptor(), POLLIN, 0};
      if (::poll(&line, 1, milliseconds(end - now())) == 0) return 0;
      const std::size_t count = line_.read(buffer);
      const std::span<const std::uint8_t> read(buffer.data(), count);
      const std::size_t taken = word_.orders.taken.size;
      is_taken_ = taken > 0 && count >= taken &&
                  std::memcmp(read.data(), word_.orders.taken.bytes.data(), taken) == 0;
      if (is_taken_) return 0;
      const int found = answer.count_in(read);
      if (found > 0) return found;
    }
    return 0;
  }

  void say(std::initializer_list<std::string_view> parts) const {
    report({"guard of ", word_.device, ": ", *parts.begin(),
            parts.size() > 1 ? *(parts.begin() + 1) : std::string_view{},
            parts.size() > 2 ? *(parts.begin() + 2) : std::string_view{}});
  }
  /// A reader of our pipe that waits for the end of file does not have to wait two minutes.
  void tell_of_silence(bool has_program) const {
    const bool lets_go = !has_program && has_reader();
    say({"it does not answer; it is told again and again, for two minutes",
         lets_go ? ", of which nothing more is said here" : ""});
    if (lets_go) let_reader_go();
  }
  void say_stands() const {
    const Digits took((now() - began_) / 1ms);
    say({"the robot stands, confirmed after ", took.view(), " ms"});
  }

  HeldLine line_;
  GuardWord word_;
  State state_ = State::Fresh;
  Time heard_{0};
  Time began_{0};  ///< To stop the robot.
  bool is_taken_ = false;
};

}  // namespace

void run_guard(const void* /*unused*/) {
  Guard guard;
  guard.run();
}

}  // namespace eyebridge::bridges
