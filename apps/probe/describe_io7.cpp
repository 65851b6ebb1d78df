// What an IO7 board told, in plain words.
#include <cmath>

#include <fmt/format.h>

#include "eyebridge/base/text.hpp"
#include "eyebridge/bridges/io7/command_table.hpp"
#include "eyebridge/hal/slow_line.hpp"
#include "io7_board.hpp"
#include "opcodes.h"

namespace eyebridge::apps {
namespace {

using namespace bridges::io7;

std::string io7_row(std::string_view name, const std::string& text) {
  return fmt::format("  {:<12} {}\n", name, text);
}

std::string replies(const ProbeReport& report) {
  if (report.profile.reply_form == ReplyForm::Text) return "text, whatever O 0 says";
  return report.was_verbose ? "text (verbose) until O 0 was sent, raw bytes now" : "raw bytes";
}

std::string requests(const ProbeReport& report) {
  const char* end = "CR";
  if (report.profile.terminator == Terminator::Lf) end = "LF";
  if (report.profile.terminator == Terminator::CrLf) end = "CR LF";
  const std::string form = report.profile.request_form == RequestForm::Ascii
                               ? fmt::format("lines of text that end in {}", end)
                               : "letters and bytes";
  return form + (report.request_form_proven
                     ? ""
                     : " (assumed: requests=text or requests=bytes in the URL says which)");
}

std::string byte_order(const ProbeReport& report) {
  if (report.profile.reply_form == ReplyForm::Text) return "of no matter: replies are text";
  const bool msb_first = report.profile.byte_order == ByteOrder::MsbFirst;
  const std::string order = fmt::format("{} significant byte first", msb_first ? "most" : "least");
  const auto& [first, second] = report.witness_bytes;
  const int this_way = msb_first ? first << 8 | second : second << 8 | first;
  const int other_way = msb_first ? second << 8 | first : first << 8 | second;
  const std::string bytes = fmt::format("{:02X} {:02X}", first, second);
  if (report.byte_order_witness == IO7_VOLTAGE) {
    return fmt::format("{}: the supply {} is {:.2f} V, the other way round it would be {:.2f} V",
                       order, bytes, this_way / 100.0, other_way / 100.0);
  }
  if (report.byte_order_witness != 0) {
    return fmt::format("{}: the reading {} of '{}' is {}, the other way round {} of at most {}",
                       order, bytes, report.byte_order_witness, this_way, other_way, IO7_ADC_LAST);
  }
  return order + " (assumed: order=msb or order=lsb in the URL says which)";
}

/// The letters that `take` says yes to, in the order of the command page.
template <class Take>
std::string letters_of(Take&& take) {
  std::string out;
  for (const Command& command : commands()) {
    if (!take(command)) continue;
    out += out.empty() ? "" : " ";
    out += command.letter;
  }
  return out;
}

std::string drive(const LetterSet& letters) {
  const std::string own =
      letters_of([&](const Command& c) { return !c.documented && letters.has(c.letter); });
  const bool by_host = letters.has(IO7_MOTOR_SPEED) && letters.has(IO7_ENCODER);
  std::string out = by_host ? "by the host, over M and e" : "none: the board lists no M or no e";
  if (!own.empty()) out += fmt::format("; the board lists letters of its own: {}", own);
  return out;
}

std::string milliseconds(Time time) { return fmt::format("{:.2f} ms", to_seconds(time) * 1e3); }

std::string exchange(const Io7Board& board) {
  const LineCounts& line = board.line;
  std::string out = fmt::format("{} requests, {} bytes out, {} bytes in, {} of them asked again",
                                line.writes, line.sent, line.received, board.report.repeats);
  if (board.attempts > 1) out += fmt::format("; understood at attempt {}", board.attempts);
  return out;
}

std::string answers(const RoundTrips& trips) {
  std::string share = fmt::format("{} of {} times", trips.answered, trips.asked);
  if (trips.answered == 0) return share;
  return fmt::format("{}, in {} … {}, median {}", share, milliseconds(trips.fastest),
                     milliseconds(trips.slowest), milliseconds(trips.median));
}

/// How well v-omega on the host drives by it.
std::string expected(const RoundTrips& trips, const LetterSet& letters) {
  constexpr double kTopSpeed = 0.6;  // m/s, of a robot whose HDT file says nothing of it
  if (!letters.has(IO7_MOTOR_SPEED) || !letters.has(IO7_ENCODER) || trips.answered == 0) return "";
  const hal::LineOutlook line = hal::outlook(trips.median, kTopSpeed);
  if (!line.drives) {
    return io7_row(
        "to expect",
        fmt::format(
            "no drive: both encoders would be known every {:.0f} ms; expected at most {:.0f} ms",
            to_seconds(line.cycle) * 1e3, to_seconds(hal::kLongestCycle) * 1e3));
  }
  return io7_row("to expect",
                 fmt::format("about {:.0f} mm off after 500 mm, {:.1f} degrees after a turn of 90; "
                             "at most {:.0f} mm/s",
                             std::ceil(line.off * 1e3), line.turned, line.top_speed * 1e3));
}

/// `url` as a shell takes it.
std::string word(const std::string& url) {
  const bool plain = url.find_first_of("?&*[] '\"") == std::string::npos;
  return plain ? url : "'" + url + "'";
}

std::string run_lines(const Io7Board& board, const std::string& url) {
  const LetterSet& letters = board.report.profile.letters;
  if (!board.report.request_form_proven) {
    return fmt::format(
        "Nothing that it lists tells whether it takes lines or bytes. Run a program with it, and "
        "add\n"
        "requests=text or requests=bytes to its URL:\n  eyebridge run --hal {} PROGRAM\n",
        word(url));
  }
  std::string out =
      fmt::format("Run a program with it:\n  eyebridge run --hal {} PROGRAM\n", word(url));
  if (letters.has(IO7_VW_SET_SPEED) && url.find("profile=") == std::string::npos) {
    const char* joint = url.find('?') == std::string::npos ? "?" : "&";
    out += fmt::format(
        "or, to drive by the board's own v-omega letters:\n"
        "  eyebridge run --hal {} PROGRAM\n",
        word(url + joint + "profile=io7vw"));
  }
  return out;
}

}  // namespace

std::string described(const Io7Board& board, const std::string& url) {
  const ProbeReport& report = board.report;
  const LetterSet& letters = report.profile.letters;
  const std::string_view prompt = report.profile.prompt.view();
  std::string out = fmt::format("an EyeBot I/O board (IO7), version {}\n", report.version);
  out += io7_row("supply", report.battery_cv ? fmt::format("{:.2f} V", *report.battery_cv / 100.0)
                                             : "not told");
  out += io7_row("prompt", prompt.empty() ? "none" : in_quotes(prompt));
  out += io7_row("requests", requests(report));
  out += io7_row("replies", replies(report));
  out += io7_row("byte order", byte_order(report));
  out += io7_row("letters", letters_of([&](const Command& c) { return letters.has(c.letter); }));
  const std::string missing =
      letters_of([&](const Command& c) { return c.documented && !letters.has(c.letter); });
  if (!missing.empty()) out += io7_row("missing", missing);
  if (letters.has(IO7_DEMO)) out += io7_row("never sent", "E, which drives the robot");
  out += io7_row("v-omega", drive(letters));
  out += io7_row("exchange", exchange(board));
  out += io7_row("v answered", answers(board.trips));
  out += expected(board.trips, letters);
  return out + run_lines(board, url);
}

}  // namespace eyebridge::apps
