#include "sweep/plot.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>

#include <cairo.h>
#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/own_results.hpp"
#include "eyebridge/base/text.hpp"

namespace eyebridge::apps {
namespace {

// Pixels.
constexpr double kLeft = 260;  // labels of the groups
constexpr double kWidth = 900;
constexpr double kTop = 50;
constexpr double kRow = 34;
constexpr double kBottom = 50;
constexpr std::size_t kMostGroups = 500;
constexpr std::size_t kLongestLabel = 40;

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

/// A round number near to a fifth of `span`: 1, 2 or 5 times a power of ten.
double tick_step(double span) {
  const double rough = span / 5;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10 * power;
}

/// The drawing, and where a value is across it.
class Chart {
 public:
  Chart(std::size_t rows, double least, double most)
      : height_(kTop + kBottom + kRow * static_cast<double>(rows)),
        step_(tick_step(most > least ? most - least : std::max(std::abs(most), 1.0))),
        low_(std::floor(least / step_) * step_),
        high_(std::max(std::ceil(most / step_) * step_, low_ + step_)),
        surface_(cairo_image_surface_create(
            CAIRO_FORMAT_RGB24, static_cast<int>(kLeft + kWidth + 60), static_cast<int>(height_))),
        cairo_(cairo_create(surface_.get())) {
    cairo_select_font_face(cairo_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_.get(), 13);
    ink(1.0, 1.0, 1.0);
    cairo_paint(cairo_.get());
  }

  void draw_axis(const std::string& title) {
    const int ticks = static_cast<int>(std::lround((high_ - low_) / step_));
    for (int i = 0; i <= ticks; ++i) {
      const double value = low_ + i * step_;
      ink(0.87, 0.87, 0.85);
      line(across(value), kTop, across(value), height_ - kBottom, 1);
      ink(0.25, 0.25, 0.25);
      text(across(value), height_ - kBottom + 18, fmt::format("{:.6g}", value), 0.5);
    }
    text(kLeft + kWidth / 2, kTop - 20, title, 0.5);
  }

  void draw_row(std::size_t row, const PlotRow& what) {
    const double y = kTop + kRow * (static_cast<double>(row) + 0.5);
    ink(0.25, 0.25, 0.25);
    const bool cut = what.label.size() > kLongestLabel;
    text(kLeft - 12, y + 4, cut ? what.label.substr(0, kLongestLabel - 3) + "..." : what.label,
         1.0);
    if (what.bar) {
      ink(0.82, 0.88, 0.96);
      cairo_rectangle(cairo_.get(), across(what.bar->low), y - 10,
                      across(what.bar->high) - across(what.bar->low), 20);
      cairo_fill(cairo_.get());
    }
    for (const double number : what.dots) {
      cairo_set_source_rgba(cairo_.get(), 0.15, 0.35, 0.7, 0.5);
      cairo_arc(cairo_.get(), across(number), y, 3, 0, 2 * M_PI);
      cairo_fill(cairo_.get());
    }
    if (!what.bar) return;
    ink(0.75, 0.15, 0.1);
    line(across(what.bar->mark), y - 11, across(what.bar->mark), y + 11, 2);
  }

  void write(const std::filesystem::path& file) {
    drop_link(file);
    check_replaceable(file, "picture", "\x89PNG");
    const cairo_status_t status = cairo_surface_write_to_png(surface_.get(), file.c_str());
    if (status != CAIRO_STATUS_SUCCESS) {
      throw std::runtime_error(
          fmt::format("cannot write {}: {}", file.string(), cairo_status_to_string(status)));
    }
  }

 private:
  [[nodiscard]] double across(double value) const {
    return kLeft + kWidth * (std::clamp(value, low_, high_) - low_) / (high_ - low_);
  }
  void ink(double r, double g, double b) { cairo_set_source_rgb(cairo_.get(), r, g, b); }
  void line(double x1, double y1, double x2, double y2, double width) {
    cairo_set_line_width(cairo_.get(), width);
    cairo_move_to(cairo_.get(), x1, y1);
    cairo_line_to(cairo_.get(), x2, y2);
    cairo_stroke(cairo_.get());
  }
  /// `share` of the text's width lies left of `x`.
  void text(double x, double y, const std::string& words, double share) {
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_.get(), words.c_str(), &extents);
    cairo_move_to(cairo_.get(), x - share * extents.width, y);
    cairo_show_text(cairo_.get(), words.c_str());
  }

  double height_;
  double step_;
  double low_;
  double high_;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> cairo_;
};

void check_value(const std::vector<Group>& groups, const std::string& value) {
  std::set<std::string> known;
  for (const Group& group : groups) {
    for (const auto& [name, numbers] : group.values) known.insert(name);
  }
  if (known.contains(value)) return;
  throw ConfigError({"--value"},
                    fmt::format("found {}, expected {}", in_quotes(value),
                                known.empty() ? std::string("a run that ended well")
                                              : fmt::format("one of {}", fmt::join(known, ", "))));
}

}  // namespace

void plot_rows(const std::vector<PlotRow>& rows, const std::string& title,
               const std::filesystem::path& file, std::optional<std::pair<double, double>> bounds) {
  if (rows.size() > kMostGroups) {
    throw ConfigError(
        {file.string()},
        fmt::format("found {} groups, expected at most {} in a picture", rows.size(), kMostGroups));
  }
  Spread all;
  for (const PlotRow& row : rows) {
    for (const double dot : row.dots) all.add(dot);
  }
  if (!bounds) bounds.emplace(all.least, all.most);
  Chart chart(rows.size(), bounds->first, bounds->second);
  chart.draw_axis(title);
  for (std::size_t row = 0; row < rows.size(); ++row) chart.draw_row(row, rows[row]);
  chart.write(file);
}

void plot(const std::vector<Group>& groups, const std::string& value,
          const std::filesystem::path& file) {
  check_value(groups, value);
  std::vector<PlotRow> rows;
  for (const Group& group : groups) {
    PlotRow& row = rows.emplace_back();
    row.label = group.label;
    const Spread spread = group.spread(value);
    if (spread.count == 0) continue;
    row.dots = group.values.at(value);
    row.bar = PlotBar{spread.mean - spread.deviation, spread.mean, spread.mean + spread.deviation};
  }
  plot_rows(rows, value, file);
}

}  // namespace eyebridge::apps
