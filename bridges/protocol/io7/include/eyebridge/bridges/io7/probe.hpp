#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/bridges/io7/profile.hpp"
#include "eyebridge/bridges/io7/request.hpp"

namespace eyebridge::bridges::io7 {

/// What a board turned out to be.
struct ProbeReport {
  Profile profile{};
  std::string list;                  ///< The answer to `h`, verbatim: that firmware's truth.
  std::string version;               ///< The answer to `v`, without label or line end.
  std::optional<int> battery_cv;     ///< Supply in 10 mV, when `V` is listed.
  bool byte_order_proven = false;    ///< False: two readings were possible, most significant first
                                     ///< is assumed. Always false when replies are text.
  bool request_form_proven = false;  ///< False: the board lists nothing harmless to try it with.
  bool was_verbose = false;          ///< It answered in text before `O 0` was sent.
  /// The letter, 'V', 'a' or 'p', whose reading proved the byte order, and its bytes; 0 when none
  /// did.
  char byte_order_witness = 0;
  std::array<std::uint8_t, 2> witness_bytes{};
  /// From a question to the first byte of its answer, the median; 0 where nobody measured it.
  Time usual_answer{0};
  int repeats = 0;  ///< Questions that had to be asked again, or in another way.
};

/// Finds out how a board wants to be spoken to. Pure: says what to send, is told what came.
///
/// The order is: Enter until the prompt repeats; `h`; `v`; `O 0` and `v` again; `V`; one reading
/// with an argument as text, first without its line end: only a board that takes bytes answers
/// that, and only one that takes lines answers the line end; to the former the reading in bytes,
/// twice: the first answer may be a late one to the line. List and version decide what the board
/// can do, and nothing protects them: each is asked until it was heard twice in the same words.
/// `h` goes first, so that no letter is sent that the board does not list; letters that move
/// anything are never sent, `E` least of all. Allocates; not a hot path.
///
///     while (!probe.done()) { write(probe.step().send); probe.answer(read_until_quiet()); }
class Probe {
 public:
  /// What to do next.
  struct Step {
    std::span<const std::uint8_t> send;  ///< Valid until answer().
    std::string_view expect;             ///< In plain words, for logs.
  };

  Probe();

  [[nodiscard]] bool done() const { return state_ == State::Done || state_ == State::Failed; }
  /// The next exchange. Only while not done().
  [[nodiscard]] Step step() const;
  /// Takes all bytes that came until the line was quiet; none at all is an answer, too.
  void answer(std::span<const std::uint8_t> received);
  /// The findings once done(). Fails with Timeout when the board was silent, with Unsupported when
  /// it lists no `v`, with Corrupt when it answers like no such board.
  [[nodiscard]] Result<ProbeReport> report() const;

 private:
  enum class State : std::uint8_t {
    Enter,
    List,
    Version,
    Quieten,
    VersionAgain,
    Voltage,
    OpenLine,
    AsciiForm,
    BinaryForm,
    BinaryAgain,
    LineEnd,
    Done,
    Failed
  };

  void send(std::string_view text);
  void send_line_end();
  void try_bytes();
  bool send(const Request& request);
  void give_up(Errc code, std::string what);
  void answer_enter(std::string_view body);
  void answer_list(std::string_view body);
  void answer_version(std::string_view body);
  /// The letters of most lists that were heard.
  [[nodiscard]] LetterSet mostly_heard() const;
  void answer_voltage(std::string_view body);
  void answer_open_line(std::string_view body);
  void answer_form(std::string_view body);
  /// The form of requests is known.
  void finish();
  void ask_list();
  bool quieten();  ///< False when the board does not list the letter.
  void ask_voltage();
  void ask_form();
  void note_witness(char letter, std::string_view body);
  void retry_or_fail(std::string_view body, std::string_view expected);
  [[nodiscard]] std::string_view without_echo(std::string_view body) const;
  /// `body` without echo, and without the prompt at its end.
  [[nodiscard]] std::string_view without_frame(std::string_view body) const;
  [[nodiscard]] std::optional<int> number_in(std::string_view body, std::size_t width);

  State state_ = State::Enter;
  ProbeReport report_{};
  Error error_{};
  std::string enter_;  ///< What Enter alone gave.
  std::vector<LetterSet> lists_;
  std::vector<std::string> versions_;
  RequestBytes send_{};
  Request form_request_{};
  std::string_view expect_;
  int attempts_ = 0;
  bool heard_ = false;  ///< Anything at all ever came.
};

}  // namespace eyebridge::bridges::io7
