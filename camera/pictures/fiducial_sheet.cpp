#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/sheet.hpp"
#include "pictures/paper.hpp"

namespace eyebridge::camera {
namespace {

constexpr Rgb kInk{0, 0, 0};
constexpr Rgb kGrey{120, 120, 120};
constexpr Rgb kCut{150, 150, 150};
constexpr Rgb kFloor{244, 244, 240};
constexpr Rgb kArrow{200, 60, 30};
constexpr double kTop = 24.0;      ///< Below the heading, mm.
constexpr double kBottom = 279.0;  ///< Above the ruler.
constexpr double kLabel = 13.0;    ///< Height of the text below a fiducial.
constexpr double kGap = 3.0;       ///< Between one fiducial and the next.
constexpr double kUsable = Paper::kWidth - 2.0 * Paper::kMargin;

constexpr const char* kHelp[] = {
    "Seen from above, x to the right, y up. Each red line is a fiducial; its arrow points away",
    "from the wall. Print all pages at 100 %, measure the bar below, cut along the dashed lines,",
    "and stick each fiducial on its wall: upright (the number at the lower left), flat, without",
    "gloss. Places are measured from the wall's left end as one faces it.",
};

/// How many go on a page; of the largest one, so that all pages look alike.
struct Grid {
  int columns = 1;
  int rows = 1;
  double pitch = 0.0;  ///< From one to the next, mm.

  [[nodiscard]] int per_page() const { return columns * rows; }
};

Grid grid_for(std::span<const Fiducial> fiducials) {
  double largest = 0.01;
  double outer = 0.0;
  for (const Fiducial& fiducial : fiducials) {
    largest = std::max(largest, fiducial.size);
    outer = std::max(outer, with_margin(fiducial));
  }
  if (largest > kLargestPrinted) {
    throw ConfigError({}, fmt::format("fiducials of {:.0f} mm do not fit on A4 paper, expected at "
                                      "most {:.0f} mm",
                                      m_to_mm(largest), m_to_mm(kLargestPrinted)));
  }
  Grid grid;
  grid.pitch = m_to_mm(outer) + kGap;
  grid.columns = std::max(1, static_cast<int>((kUsable + kGap) / grid.pitch));
  grid.rows = std::max(1, static_cast<int>((kBottom - kTop) / (grid.pitch + kLabel)));
  return grid;
}

/// The wall that a fiducial hangs on, and how far its centre is from the wall's left end as one
/// faces it, metres.
struct Place {
  std::size_t wall = 0;
  double from_left = 0.0;
};

std::optional<Place> place_of(const Fiducial& fiducial, const world::WorldModel& model) {
  const Vec2 normal = Heading::from_angle(fiducial.facing).forward();
  const Vec2 right{-normal.y, normal.x};
  for (std::size_t i = 0; i < model.walls.size(); ++i) {
    const world::Wall& wall = model.walls[i];
    const bool turned = dot(wall.b - wall.a, right) < 0.0;
    const Vec2 left_end = turned ? wall.b : wall.a;
    const Vec2 off = fiducial.centre - left_end;
    const double along = dot(off, right);
    const double length = norm(wall.b - wall.a);
    if (std::abs(dot(off, normal) - 0.5 * wall.thickness) < 1e-6 && along > 0.0 && along < length &&
        std::abs(cross(wall.b - wall.a, right)) < 1e-6 * length) {
      return Place{i, along};
    }
  }
  return std::nullopt;
}

const char* compass(double angle) {
  static constexpr const char* kNames[] = {"east", "north-east", "north", "north-west",
                                           "west", "south-west", "south", "south-east"};
  const auto eighth = std::lround(angle / (kPi / 4.0));
  return kNames[static_cast<std::size_t>((eighth + 8) % 8)];
}

void heading(Paper& paper, const std::string& title, const std::string& right) {
  paper.text({Paper::kMargin, 16.0}, title, 5.5, kInk, true);
  paper.text({Paper::kWidth - 52.0, 16.0}, right, 4.0, kGrey);
  paper.ruler();
}

void draw_map(Paper& paper, const FiducialSheet& sheet, int pages) {
  heading(paper, "Fiducials for " + sheet.title, fmt::format("page 1 of {}: map", pages));
  const world::WorldModel& model = sheet.model;
  const Vec2 room{kUsable - 8.0, kBottom - kTop - 38.0};
  const double scale = std::min(room.x / model.width, room.y / model.height);
  const Vec2 origin{0.5 * (Paper::kWidth - scale * model.width), kTop + 4.0 + scale * model.height};
  const auto at = [&](Vec2 p) {
    const Vec2 from_corner = p - model.corner;
    return Vec2{origin.x + scale * from_corner.x, origin.y - scale * from_corner.y};
  };
  paper.fill(at({model.corner.x, model.far_corner().y}),
             {scale * model.width, scale * model.height}, kFloor);
  for (const world::Wall& wall : model.walls) {
    paper.line(at(wall.a), at(wall.b), std::max(0.5, scale * wall.thickness), kInk);
  }
  for (const world::StartPose& start : model.starts) {
    const Vec2 p = at(start.pose.position());
    const Vec2 forward = Heading::from_angle(start.pose.theta).forward();
    paper.arrow(p, p + 5.0 * Vec2{forward.x, -forward.y}, 0.6, kGrey);
  }
  // Numbers as large as the narrowest of them leave room for.
  double narrowest = 1e9;
  for (const Fiducial& fiducial : sheet.fiducials) {
    narrowest = std::min(narrowest, scale * 2.0 * with_margin(fiducial));
  }
  const double font = std::clamp(0.18 * narrowest, 1.2, 4.0);
  for (const Fiducial& fiducial : sheet.fiducials) {
    const Vec2 forward = Heading::from_angle(fiducial.facing).forward();
    const Vec2 normal{forward.x, -forward.y};
    const Vec2 right{-normal.y, normal.x};
    const Vec2 foot = at(fiducial.centre) + 0.5 * normal;
    const double half = 0.5 * scale * fiducial.size;
    paper.line(foot - half * right, foot + half * right, 0.5, kArrow);
    paper.arrow(foot, foot + 0.9 * font * normal, 0.12 * font, kArrow);
    paper.centred_text(foot + 1.7 * font * normal, std::to_string(fiducial.id), font, kInk, true);
  }
  double y = origin.y + 12.0;
  for (const char* line : kHelp) {
    paper.text({Paper::kMargin, y}, line, 3.4, kInk);
    y += 5.0;
  }
}

void draw_fiducial(Paper& paper, const FiducialSheet& sheet, const Fiducial& fiducial,
                   Vec2 corner) {
  const double size = m_to_mm(fiducial.size);
  const double outer = m_to_mm(with_margin(fiducial));
  const double margin = 0.5 * (outer - size);
  paper.outline(corner, {outer, outer}, 0.2, kCut, true);
  paper.fiducial(corner + Vec2{margin, margin}, size, fiducial.family, fiducial.id);
  const double y = corner.y + outer;
  // What is left of the label once it is cut out: in the corner, where it disturbs no edge.
  paper.text({corner.x + 0.12 * margin, y - 0.12 * margin}, std::to_string(fiducial.id),
             0.22 * margin, kCut);
  paper.text({corner.x, y + 5.0}, std::to_string(fiducial.id), 4.5, kInk, true);
  const auto place = place_of(fiducial, sheet.model);
  if (!place) return;
  const world::Wall& wall = sheet.model.walls[place->wall];
  // Long texts of small fiducials go on below.
  const double font = std::clamp(outer / 34.0, 1.6, 3.0);
  paper.text({corner.x + 12.0, y + 4.0},
             fmt::format("{} side of wall {}, ({:.2f}, {:.2f})-({:.2f}, {:.2f}) m",
                         compass(fiducial.facing), place->wall + 1, wall.a.x, wall.a.y, wall.b.x,
                         wall.b.y),
             font, kInk);
  paper.text({corner.x + 12.0, y + 4.0 + 1.35 * font},
             fmt::format("centre {:.0f} mm from the left end, {:.0f} mm above the floor",
                         m_to_mm(place->from_left), m_to_mm(fiducial.z)),
             font, kInk);
  paper.text(
      {corner.x + 12.0, y + 4.0 + 2.7 * font},
      fmt::format("paper's left edge at {:.0f} mm, lower edge at {:.0f} mm",
                  m_to_mm(place->from_left) - 0.5 * outer, m_to_mm(fiducial.z) - 0.5 * outer),
      font, kGrey);
}

void draw(Paper& paper, const FiducialSheet& sheet, const Grid& grid, int page, int pages) {
  if (page == 1) {
    draw_map(paper, sheet, pages);
    return;
  }
  heading(paper, sheet.title, fmt::format("page {} of {}", page, pages));
  const int first = (page - 2) * grid.per_page();
  for (int i = 0; i < grid.per_page(); ++i) {
    const auto index = static_cast<std::size_t>(first + i);
    if (index >= sheet.fiducials.size()) return;
    const int row = i / grid.columns;
    const int column = i % grid.columns;
    const Vec2 corner{Paper::kMargin + column * grid.pitch, kTop + row * (grid.pitch + kLabel)};
    draw_fiducial(paper, sheet, sheet.fiducials[index], corner);
  }
}

}  // namespace

int pages_of(const FiducialSheet& sheet) {
  const int per_page = grid_for(sheet.fiducials).per_page();
  return 1 + (static_cast<int>(sheet.fiducials.size()) + per_page - 1) / per_page;
}

void write_pdf(const FiducialSheet& sheet, const std::filesystem::path& path) {
  const Grid grid = grid_for(sheet.fiducials);
  const int pages = pages_of(sheet);
  Paper paper(path);
  for (int page = 1; page <= pages; ++page) {
    draw(paper, sheet, grid, page, pages);
    paper.next_page();
  }
  paper.finish();
}

Frame draw_page(const FiducialSheet& sheet, int page, double pixels_per_mm) {
  const int pages = pages_of(sheet);
  if (page < 1 || page > pages) {
    throw std::out_of_range(fmt::format("no page {}, expected 1 to {}", page, pages));
  }
  Paper paper(pixels_per_mm);
  draw(paper, sheet, grid_for(sheet.fiducials), page, pages);
  return paper.picture();
}

}  // namespace eyebridge::camera
