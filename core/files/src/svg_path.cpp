#include "svg_path.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "eyebridge/base/units.hpp"

namespace eyebridge::files {
namespace {

constexpr int kMostPieces = 1000;  // of one curve
constexpr double kLargestNumber = 1e9;

bool is_svg_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/// Numbers, flags and letters of path data.
class PathScanner {
 public:
  explicit PathScanner(std::string_view text) : text_(text) {}

  [[nodiscard]] std::size_t offset() const { return at_; }
  [[noreturn]] void fail(const std::string& what) const { throw SvgPathError(at_, what); }

  void skip_blanks() {
    while (at_ < text_.size() && is_svg_blank(text_[at_])) ++at_;
  }
  void skip_separator() {
    skip_blanks();
    if (at_ < text_.size() && text_[at_] == ',') {
      ++at_;
      skip_blanks();
    }
  }
  [[nodiscard]] bool at_end() const { return at_ == text_.size(); }
  [[nodiscard]] char peek() const { return at_end() ? '\0' : text_[at_]; }
  [[nodiscard]] bool at_number() const {
    const char c = peek();
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
  }
  char take() { return text_[at_++]; }

  double number() {
    if (!at_number()) {
      fail(at_end() ? "ends where a number is expected" : "expected a number");
    }
    const char* begin = text_.data() + at_;
    if (*begin == '+') ++begin;
    double value = 0;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc{} || !(std::fabs(value) <= kLargestNumber)) {
      fail("expected a number of at most 1e9");
    }
    at_ = static_cast<std::size_t>(end - text_.data());
    skip_separator();
    return value;
  }
  bool flag() {
    const char c = peek();
    if (c != '0' && c != '1') fail("expected 0 or 1, a flag of an arc");
    ++at_;
    skip_separator();
    return c == '1';
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

int pieces_for(double bend, double tolerance) {
  // A piece of a curve whose second difference is `bend` misses it by an eighth of it over n * n.
  const double n = std::ceil(std::sqrt(bend / (8 * tolerance)));
  return n < kMostPieces ? std::max(1, static_cast<int>(n)) : kMostPieces;
}

/// Follows path data and keeps what is drawn.
class PathReader {
 public:
  PathReader(std::string_view data, double tolerance) : scan_(data), tolerance_(tolerance) {}

  std::vector<SvgLine> read() {
    scan_.skip_blanks();
    char command = '\0';
    while (!scan_.at_end()) {
      if (!scan_.at_number()) {
        command = scan_.take();
        scan_.skip_blanks();
        if (lines_.empty() && command != 'M' && command != 'm') {
          scan_.fail("expected M or m, where the path begins");
        }
      } else if (command == '\0' || command == 'Z' || command == 'z') {
        scan_.fail("expected a letter of a command");
      }
      take(command);
      // What follows a place to begin at are lines to more places.
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    std::erase_if(lines_, [](const SvgLine& line) { return line.points.size() < 2; });
    return std::move(lines_);
  }

 private:
  void take(char command) {
    const bool is_relative = command >= 'a';
    base_ = is_relative ? now_ : Vec2{};
    const char kind = is_relative ? static_cast<char>(command - 'a' + 'A') : command;
    const char before = last_;
    last_ = kind;
    switch (kind) {
      case 'M':
        return begin_at(point());
      case 'L':
        return line_to(point());
      case 'H':
        return line_to({base_.x + scan_.number(), now_.y});
      case 'V':
        return line_to({now_.x, base_.y + scan_.number()});
      case 'Z':
        return close();
      case 'C': {
        const Vec2 a = point();
        const Vec2 b = point();
        return cubic(a, b, point());
      }
      case 'S':
        return smooth_cubic(before == 'C' || before == 'S');
      case 'Q': {
        const Vec2 control = point();
        return quadratic(control, point());
      }
      case 'T': {
        const Vec2 control = before == 'Q' || before == 'T' ? 2 * now_ - control_ : now_;
        return quadratic(control, point());
      }
      case 'A':
        return arc();
      default:
        scan_.fail(std::string("no command of a path: '") + command + "'");
    }
  }

  Vec2 point() {
    const double x = scan_.number();
    return base_ + Vec2{x, scan_.number()};
  }

  void begin_at(Vec2 p) {
    lines_.push_back({{p}, false});
    now_ = p;
  }
  void line_to(Vec2 p) {
    // After a Z the next line begins where the closed one did.
    if (lines_.back().closed) begin_at(now_);
    if (++count_ > kMostSvgPoints) scan_.fail("more than a million points");
    if (p != now_) lines_.back().points.push_back(p);
    now_ = p;
  }
  void close() {
    SvgLine& line = lines_.back();
    if (line.closed) return;
    if (line.points.size() > 1 && line.points.back() == line.points.front()) {
      line.points.pop_back();
    }
    line.closed = line.points.size() > 1;
    now_ = line.points.front();
  }

  void smooth_cubic(bool follows_a_cubic) {
    const Vec2 a = follows_a_cubic ? 2 * now_ - control_ : now_;
    const Vec2 b = point();
    cubic(a, b, point());
  }
  void cubic(Vec2 a, Vec2 b, Vec2 end) {
    const Vec2 start = now_;
    const double bend =
        6 * std::max(norm(start - 2 * a + b), norm(a - 2 * b + end));  // of the second derivative
    const int n = pieces_for(bend, tolerance_);
    for (int i = 1; i < n; ++i) {
      const double t = static_cast<double>(i) / n;
      const double s = 1 - t;
      line_to(s * s * s * start + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * end);
    }
    line_to(end);
    control_ = b;
  }
  void quadratic(Vec2 control, Vec2 end) {
    const Vec2 start = now_;
    cubic(start + (2.0 / 3) * (control - start), end + (2.0 / 3) * (control - end), end);
    control_ = control;
  }

  /// From its ends to its centre: SVG 1.1, appendix F.6.5.
  void arc() {
    double rx = std::fabs(scan_.number());
    double ry = std::fabs(scan_.number());
    const Heading axis = Heading::from_angle(scan_.number() * kPi / 180);
    const bool is_large = scan_.flag();
    const bool is_positive = scan_.flag();
    const Vec2 end = point();
    const Vec2 start = now_;
    if (rx == 0 || ry == 0 || start == end) return line_to(end);
    const Vec2 half = 0.5 * (start - end);
    const Vec2 p{axis.cos * half.x + axis.sin * half.y, -axis.sin * half.x + axis.cos * half.y};
    const double reach = (p.x / rx) * (p.x / rx) + (p.y / ry) * (p.y / ry);
    if (reach > 1) {
      rx *= std::sqrt(reach);
      ry *= std::sqrt(reach);
    }
    const double a = rx * rx * p.y * p.y + ry * ry * p.x * p.x;
    const double share = a == 0 ? 0 : std::max(0.0, (rx * rx * ry * ry - a) / a);
    const double k = (is_large == is_positive ? -1 : 1) * std::sqrt(share);
    const Vec2 centre{k * rx * p.y / ry, -k * ry * p.x / rx};
    const double from = arc_tan2((p.y - centre.y) / ry, (p.x - centre.x) / rx);
    const double to = arc_tan2((-p.y - centre.y) / ry, (-p.x - centre.x) / rx);
    double sweep = to - from;
    if (is_positive && sweep < 0) sweep += 2 * kPi;
    if (!is_positive && sweep > 0) sweep -= 2 * kPi;
    const Vec2 middle = 0.5 * (start + end) + axis.rotate(centre);
    const int n = pieces_for(std::max(rx, ry) * sweep * sweep, tolerance_);
    for (int i = 1; i < n; ++i) {
      const Heading at = Heading::from_angle(from + sweep * i / n);
      line_to(middle + axis.rotate({rx * at.cos, ry * at.sin}));
    }
    line_to(end);
  }

  PathScanner scan_;
  double tolerance_;
  std::vector<SvgLine> lines_;
  std::size_t count_ = 0;
  Vec2 now_;
  Vec2 base_;
  Vec2 control_;  ///< The last one of the curve before.
  char last_ = '\0';
};

}  // namespace

std::vector<SvgLine> read_svg_path(std::string_view data, double tolerance) {
  return PathReader(data, tolerance).read();
}

SvgLine svg_ellipse(Vec2 centre, double rx, double ry, double tolerance) {
  SvgLine line{{}, true};
  const int n = std::max(8, pieces_for(std::max(rx, ry) * 4 * kPi * kPi, tolerance));
  for (int i = 0; i < n; ++i) {
    const Heading at = Heading::from_angle(2 * kPi * i / n);
    line.points.push_back(centre + Vec2{rx * at.cos, ry * at.sin});
  }
  return line;
}

std::vector<double> read_svg_numbers(std::string_view text) {
  PathScanner scan(text);
  std::vector<double> numbers;
  scan.skip_blanks();
  while (!scan.at_end()) {
    numbers.push_back(scan.number());
    if (numbers.size() > 2 * kMostSvgPoints) scan.fail("more than a million points");
  }
  return numbers;
}

}  // namespace eyebridge::files
