#include "sweep/progress.hpp"

#include <fmt/format.h>

#include "eyebridge/base/text.hpp"

namespace eyebridge::apps {
namespace {

constexpr std::size_t kBar = 30;

std::string in_units(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

std::string short_name(const Cell& cell) {
  std::string out;
  for (const auto& [name, value] : cell.coordinates()) {
    const bool path = name == "program" || name == "world";
    const std::string shown = path ? value.substr(value.rfind('/') + 1) : value;
    out += name == "program" ? shown : " " + name + "=" + shown;
  }
  return out;
}

Progress::Progress(std::FILE* out, bool terminal, std::size_t all, std::size_t present)
    : out_(out), terminal_(terminal), all_(all), present_(present), done_(present) {
  if (terminal_) draw(0);
}

void Progress::ended(const Cell& cell, const Outcome& outcome, double elapsed) {
  ++done_;
  if (!outcome.well()) ++bad_;
  const std::string name = printable(short_name(cell));
  const std::string reason = printable(outcome.reason);
  if (!terminal_) {
    fmt::print(out_, "{}/{} {}: {}{}\n", done_, all_, name, outcome.how,
               reason.empty() ? "" : ", " + reason);
  } else {
    // What went wrong stays above the bar.
    if (!outcome.well()) {
      fmt::print(out_, "\r\x1B[K{}: {}, {}\n", name, outcome.how, reason);
    }
    draw(elapsed);
  }
  std::fflush(out_);
}

void Progress::draw(double elapsed) {
  const std::size_t filled = all_ == 0 ? kBar : kBar * done_ / all_;
  std::string rest;
  if (done_ > present_ && done_ < all_) {
    const double each = elapsed / static_cast<double>(done_ - present_);
    rest = ", " + in_units(each * static_cast<double>(all_ - done_)) + " to go";
  }
  if (bad_ > 0) rest = fmt::format(", {} went wrong", bad_) + rest;
  fmt::print(out_, "\r\x1B[K[{:=<{}}{:<{}}] {}/{}{}", "", filled, "", kBar - filled, done_, all_,
             rest);
  std::fflush(out_);
}

void Progress::finish() {
  if (terminal_) fmt::print(out_, "\n");
}

}  // namespace eyebridge::apps
