#include "golden.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace eyebridge::gallery {
namespace {

constexpr std::string_view kReview = "# review: ";
constexpr std::string_view kNotYet = "not yet";
constexpr std::string_view kLine = "| ";

bool in_number(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.'; }

/// True when two lines are equal but for numbers, none of which differ by more than `tolerance`.
bool alike(const std::string& a, const std::string& b, double tolerance) {
  if (a == b) return true;
  if (tolerance == 0.0) return false;
  const char* p = a.c_str();
  const char* q = b.c_str();
  const auto starts_number = [](const char* at) {
    return in_number(*at) || (*at == '-' && in_number(at[1]));
  };
  while (*p != '\0' && *q != '\0') {
    // Columns of numbers are padded by blanks, of which there are more before the shorter number.
    while (*p == ' ') ++p;
    while (*q == ' ') ++q;
    if (starts_number(p) && starts_number(q)) {
      char* after_p = nullptr;
      char* after_q = nullptr;
      if (std::abs(std::strtod(p, &after_p) - std::strtod(q, &after_q)) > tolerance) return false;
      p = after_p;
      q = after_q;
    } else if (*p == *q && *p != '\0') {
      ++p;
      ++q;
    } else if (*p != *q) {
      return false;
    }
  }
  return *p == *q;
}

/// How many characters of two pictures differ, with those that only one of them has.
std::size_t differing_cells(const Lines& a, const Lines& b, std::size_t& cells) {
  std::size_t differing = 0;
  cells = 0;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const std::string_view left = i < a.size() ? std::string_view(a[i]) : "";
    const std::string_view right = i < b.size() ? std::string_view(b[i]) : "";
    for (std::size_t j = 0; j < std::max(left.size(), right.size()); ++j) {
      ++cells;
      if (j >= left.size() || j >= right.size() || left[j] != right[j]) ++differing;
    }
  }
  return differing;
}

void compare_lines(const std::string& name, const Lines& expected, const Lines& actual,
                   double tolerance, Lines& out) {
  constexpr std::size_t kShown = 8;
  std::size_t found = 0;
  for (std::size_t i = 0; i < std::max(expected.size(), actual.size()); ++i) {
    const std::string want = i < expected.size() ? expected[i] : "(nothing)";
    const std::string have = i < actual.size() ? actual[i] : "(nothing)";
    if (alike(want, have, tolerance)) continue;
    if (++found > kShown) continue;
    out.push_back(name + ", line " + std::to_string(i + 1) + "\n  golden: " + want +
                  "\n  run:    " + have);
  }
  if (found > kShown) out.push_back(name + ": " + std::to_string(found - kShown) + " more lines");
}

const Lines* find(const Golden& golden, const std::string& name) {
  for (const auto& [section, lines] : golden.sections) {
    if (section == name) return &lines;
  }
  return nullptr;
}

/// "exit code 3" of "exit code 3 after 12.34 s".
std::string_view exit_code(const Lines& end) {
  const std::string_view line = end.empty() ? "" : std::string_view(end.front());
  return line.substr(0, line.find(" after "));
}

/// What numbers of this section may differ by.
double tolerance_in(const std::string& name, const Lines& expected, const Lines& actual,
                    double tolerance) {
  if (name == "stdout" || name == "stderr" || name == "lcd picture") return 0.0;
  if (name == "end" && exit_code(expected) != exit_code(actual)) return 0.0;
  return tolerance;
}

/// True for pictures of one size, which their first lines tell.
bool comparable(const Lines& a, const Lines& b) {
  return !a.empty() && !b.empty() && a.front() == b.front();
}

}  // namespace

Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string to_text(const Golden& golden) {
  std::string text(kReview);
  text += golden.review.empty() ? std::string(kNotYet) : golden.review;
  text += '\n';
  for (const auto& [name, lines] : golden.sections) {
    text += "[" + name + "]\n";
    for (const std::string& line : lines) {
      text += line.empty() ? "|" : std::string(kLine) + line;
      text += '\n';
    }
  }
  return text;
}

Golden parse_golden(std::string_view text) {
  Golden golden;
  int number = 0;
  for (const std::string& line : lines_of(text)) {
    ++number;
    if (line.starts_with(kReview)) {
      const std::string review = line.substr(kReview.size());
      if (review != kNotYet) golden.review = review;
    } else if (line.starts_with('[') && line.ends_with(']')) {
      golden.sections.emplace_back(line.substr(1, line.size() - 2), Lines{});
    } else if (!golden.sections.empty() && line.starts_with('|')) {
      golden.sections.back().second.emplace_back(
          line.substr(std::min(line.size(), line.starts_with(kLine) ? kLine.size() : 1)));
    } else {
      throw std::runtime_error("line " + std::to_string(number) + " of a golden: '" + line + "'");
    }
  }
  return golden;
}

Lines differences(const Golden& expected, const Golden& actual, const Tolerance& tolerance) {
  Lines out;
  for (const auto& [name, lines] : actual.sections) {
    const Lines* want = find(expected, name);
    if (want == nullptr) {
      out.push_back(name + ": the golden has no such section");
    } else if (name == "lcd picture" && tolerance.cells > 0.0 && comparable(*want, lines)) {
      std::size_t cells = 0;
      const std::size_t differing = differing_cells(*want, lines, cells);
      if (static_cast<double>(differing) > tolerance.cells * static_cast<double>(cells)) {
        out.push_back(name + ": " + std::to_string(differing) + " of " + std::to_string(cells) +
                      " cells differ");
      }
    } else {
      compare_lines(name, *want, lines, tolerance_in(name, *want, lines, tolerance.number), out);
    }
  }
  for (const auto& [name, lines] : expected.sections) {
    if (find(actual, name) == nullptr) out.push_back(name + ": the run has no such section");
  }
  return out;
}

}  // namespace eyebridge::gallery
