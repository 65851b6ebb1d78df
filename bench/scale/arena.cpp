#include "scale/arena.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::bench {
namespace {

constexpr double kSide = 40.0;  // metres

std::vector<std::vector<double>> read_table(const std::filesystem::path& file,
                                            std::size_t columns) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  std::vector<std::vector<double>> rows;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    std::vector<double>& row = rows.emplace_back();
    const char* at = line.data();
    const char* const end = at + line.size();
    while (true) {
      double value = 0.0;
      const auto [after, error] = std::from_chars(at, end, value);
      if (error != std::errc{}) break;
      row.push_back(value);
      if (after == end || *after != ',') break;
      at = after + 1;
    }
    if (row.size() != columns) {
      throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": found \"" + line +
                               "\", expected " + std::to_string(columns) +
                               " numbers with commas between them");
    }
  }
  return rows;
}

/// How many places lie side by side: the largest divisor that is not above the root.
std::size_t columns_of(std::size_t places) {
  std::size_t columns = 1;
  for (std::size_t n = 2; n * n <= places; ++n) {
    if (places % n == 0) columns = n;
  }
  return columns;
}

/// `count` of them about `centre`, where no robot starts.
void add_boxes(world::WorldModel& model, Vec2 centre, std::size_t count,
               const std::vector<std::vector<double>>& starts) {
  constexpr double kClear = 0.3;  // metres
  Random random(5);
  for (std::size_t i = 0; i < count; ++i) {
    Vec2 place;
    const auto is_near = [&](const std::vector<double>& start) {
      return norm(Vec2{start[0], start[1]} - place) < kClear;
    };
    do {
      place = {kSide * (random.uniform() - 0.5), kSide * (random.uniform() - 0.5)};
    } while (std::any_of(starts.begin(), starts.end(), is_near));
    world::ObjectSpec& box = model.objects.emplace_back();
    box.kind = world::ObjectKind::Box;
    box.name = "box";
    box.size = {0.1, 0.1};
    box.matter.fixed = true;
    box.pose = {centre.x + place.x, centre.y + place.y, kPi * random.uniform()};
  }
}

}  // namespace

Arena read_arena(const std::filesystem::path& folder, std::size_t robots, std::size_t in_one,
                 std::size_t empty, std::size_t boxes) {
  const auto walls = read_table(folder / "walls.csv", 5);
  const auto starts = read_table(folder / "robots.csv", 3);
  const std::size_t inhabited = robots <= in_one ? 1 : robots / in_one;
  const std::size_t places = inhabited + empty;
  if (robots / inhabited > starts.size() || robots % inhabited != 0) {
    throw std::runtime_error("no starts for " + std::to_string(robots) + " robots");
  }
  const std::size_t columns = columns_of(places);
  const std::size_t rows = places / columns;
  world::WorldModel model;
  model.width = kSide * static_cast<double>(columns);
  model.height = kSide * static_cast<double>(rows);
  Arena arena;
  for (std::size_t place = 0; place < places; ++place) {
    const std::size_t column = place % columns;
    const std::size_t row = place / columns;
    const Vec2 centre{kSide * (static_cast<double>(column) + 0.5),
                      kSide * (static_cast<double>(row) + 0.5)};
    for (const std::vector<double>& w : walls) {
      // The right and upper outer walls are the next place's left and lower ones.
      if (w[0] == kSide / 2 && column + 1 < columns) continue;
      if (w[1] == kSide / 2 && row + 1 < rows) continue;
      world::Wall wall;
      const Vec2 half = w[2] / 2 * Heading::from_angle(w[4]).forward();
      wall.a = centre + Vec2{w[0], w[1]} - half;
      wall.b = centre + Vec2{w[0], w[1]} + half;
      wall.thickness = w[3];
      model.walls.push_back(wall);
    }
    add_boxes(model, centre, boxes, starts);
    for (std::size_t i = 0; place < inhabited && i < robots / inhabited; ++i) {
      const std::vector<double>& start = starts[i];
      arena.starts.push_back({centre.x + start[0], centre.y + start[1], start[2]});
    }
  }
  arena.model = std::make_shared<const world::WorldModel>(std::move(model));
  return arena;
}

}  // namespace eyebridge::bench
