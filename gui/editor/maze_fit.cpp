#include "editor/maze_fit.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>
#include <vector>

#include "editor/catalogue.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/maze_limits.hpp"

namespace eyebridge::gui {
namespace {

constexpr double kMicro = 1e6;    // the grid is looked for in whole micrometres
constexpr double kOnGrid = 1e-6;  // metres
constexpr int kFinest = 64;       // cells of a trial, at most, where walls need one

struct NoFit {
  QString why;
};

class MazeTrial {
  Q_DECLARE_TR_FUNCTIONS(MazeFit)

 public:
  MazeTrial(const Plan& plan, double cell, bool all_things) : plan_(plan), all_things_(all_things) {
    grid_.cell = cell;
  }

  /// Throws NoFit.
  world::WorldModel run() {
    refuse_others();
    lay_out();
    for (const world::Wall& wall : plan_.walls) take_wall(wall);
    world::WorldModel maze;
    maze.width = grid_.columns * grid_.cell;
    maze.height = grid_.rows * grid_.cell;
    for (const world::StartPose& start : plan_.starts) maze.starts.push_back(in_cell(start));
    for (const Thing& thing : plan_.things) {
      if (all_things_ || thing.is_drawn) maze.objects.push_back(drawn(thing.spec));
    }
    maze.walls = world::walls_of(grid_);
    for (const world::MazeCell goal : plan_.goals) {
      // The floor may have shrunk since.
      if (goal.column < grid_.columns && goal.row < grid_.rows) grid_.goals.push_back(goal);
    }
    maze.maze = grid_;
    try {
      static_cast<void>(files::write_maze(maze));
    } catch (const ConfigError& error) {
      throw NoFit{QString::fromStdString(error.text())};
    }
    return maze;
  }

 private:
  static QString mm(double metres) { return QString::number(m_to_mm(metres), 'g', 8); }
  static QString at(Vec2 place) { return tr("(%1, %2) mm").arg(mm(place.x), mm(place.y)); }
  [[nodiscard]] QString cells() const { return tr("cells of %1 mm").arg(mm(grid_.cell)); }

  void refuse_others() const {
    if (plan_.texture) throw NoFit{tr("it has a floor texture: a maze cannot name one")};
    if (plan_.water) throw NoFit{tr("it has water: a maze cannot say how deep")};
    if (plan_.walls.empty()) throw NoFit{tr("it has no wall: a maze has one at least")};
    if (!all_things_) return;
    if (!plan_.markers.empty()) {
      throw NoFit{tr("it has a marker at %1: a maze cannot draw one, a .sim file can name a maze "
                     "and hold markers")
                      .arg(at(plan_.markers.front().position))};
    }
    if (!plan_.robots.empty()) {
      throw NoFit{
          tr("it has robots: a maze cannot hold them, a .sim file can name a maze and hold "
             "robots")};
    }
  }

  void lay_out() {
    const double columns = plan_.width / grid_.cell;
    const double rows = plan_.height / grid_.cell;
    if (!is_whole(columns) || !is_whole(rows)) {
      throw NoFit{tr("its floor of %1 mm x %2 mm is no whole number of %3")
                      .arg(mm(plan_.width), mm(plan_.height), cells())};
    }
    if (columns * rows > double{files::kMostMazeCells}) {
      throw NoFit{tr("it has more than %1 %2").arg(files::kMostMazeCells).arg(cells())};
    }
    grid_.columns = static_cast<int>(std::lround(columns));
    grid_.rows = static_cast<int>(std::lround(rows));
    const auto wide = static_cast<std::size_t>(grid_.columns);
    const auto high = static_cast<std::size_t>(grid_.rows);
    grid_.south.assign(wide * (high + 1), 0);
    grid_.west.assign((wide + 1) * high, 0);
  }

  [[nodiscard]] bool is_whole(double cells) const {
    return std::abs(cells - std::round(cells)) * grid_.cell < kOnGrid;
  }

  void take_wall(const world::Wall& wall) {
    const QString name = tr("the wall from %1 to %2").arg(at(wall.a), at(wall.b));
    // A maze file cannot say a thickness: walls of the default thickness become lines.
    const bool is_bare = wall.thickness == 0 || wall.thickness == world::Wall::kFileThickness;
    if (!is_bare || wall.height != world::Wall::kDefaultHeight ||
        wall.colour != world::Wall::kDefaultColour) {
      throw NoFit{tr("%1 has a thickness, height or colour of its own: a maze's walls are bare "
                     "lines, all alike")
                      .arg(name)};
    }
    const Vec2 a = (1 / grid_.cell) * wall.a;
    const Vec2 b = (1 / grid_.cell) * wall.b;
    const bool level = std::abs(wall.a.y - wall.b.y) < kOnGrid;
    const bool upright = std::abs(wall.a.x - wall.b.x) < kOnGrid;
    if (!level && !upright) throw NoFit{tr("%1 is slanted").arg(name)};
    for (const double coordinate : {a.x, a.y, b.x, b.y}) {
      if (!is_whole(coordinate)) {
        throw NoFit{tr("%1 does not lie between %2").arg(name, cells())};
      }
    }
    const int low = whole(level ? std::min(a.x, b.x) : std::min(a.y, b.y));
    const int high = whole(level ? std::max(a.x, b.x) : std::max(a.y, b.y));
    const int across = whole(level ? a.y : a.x);
    const int most = level ? grid_.columns : grid_.rows;
    if (low < 0 || high > most || across < 0 || across > (level ? grid_.rows : grid_.columns)) {
      throw NoFit{tr("%1 leaves the floor").arg(name)};
    }
    for (int i = low; i < high; ++i) {
      if (level) {
        grid_.south[static_cast<std::size_t>(across * grid_.columns + i)] = 1;
      } else {
        grid_.west[static_cast<std::size_t>(i * (grid_.columns + 1) + across)] = 1;
      }
    }
  }

  static int whole(double value) { return static_cast<int>(std::lround(value)); }

  /// `pose` at the middle of its cell, exactly; in a drawing it may stand between two, too.
  [[nodiscard]] Pose middle(const Pose& pose, const QString& name) const {
    const double half = grid_.cell / 2;
    const double column = std::round(pose.x / half);
    const double row = std::floor(pose.y / grid_.cell);
    const Vec2 there{column * half, (2 * row + 1) * half};
    if (!same_point(there, pose.position())) {
      throw NoFit{tr("%1 at %2 does not stand in the middle of one of its %3")
                      .arg(name, at(pose.position()), cells())};
    }
    return {there.x, there.y, pose.theta};
  }

  [[nodiscard]] world::StartPose in_cell(const world::StartPose& start) const {
    constexpr std::string_view kTurns = "RULD";
    const double quarters = start.pose.theta / (kPi / 2);
    const auto turn = static_cast<std::size_t>((std::lround(quarters) + 4) % 4);
    world::StartPose out{start.letter, middle(start.pose, tr("a start"))};
    if (std::abs(quarters - std::round(quarters)) > 1e-9) {
      throw NoFit{tr("the start at %1 faces %2 degrees: a maze's letters face right, up, left or "
                     "down")
                      .arg(at(start.pose.position()))
                      .arg(rad_to_deg(start.pose.theta))};
    }
    constexpr double kFacing[] = {0.0, kPi / 2, kPi, -kPi / 2};
    out.pose.theta = kFacing[turn];
    const std::string_view same = turn == 1 ? "SsUu" : turn == 0 ? "Rr" : turn == 2 ? "Ll" : "Dd";
    if (start.letter != 0 && same.find(start.letter) != std::string_view::npos) return out;
    const auto uses = [&](const files::SimRobot& robot) { return robot.start == start.letter; };
    if (start.letter != 0 && std::ranges::any_of(plan_.robots, uses)) {
      throw NoFit{tr("the start '%1' at %2, which a robot uses, faces another way than its letter "
                     "says")
                      .arg(QChar(start.letter))
                      .arg(at(start.pose.position()))};
    }
    out.letter = kTurns[turn];
    return out;
  }

  [[nodiscard]] world::ObjectSpec drawn(const world::ObjectSpec& object) const {
    const QString name = QString::fromStdString(object.name);
    if (object.name != "golf" && object.name != "crate") {
      throw NoFit{tr("it has a %1 at %2: a maze can draw golf balls and crates only")
                      .arg(name, at(object.pose.position()))};
    }
    world::ObjectSpec out = builtin_thing(object.name);
    out.radius = std::min(out.radius, 0.4 * grid_.cell);
    if (object.name == "golf") out.height = 2 * out.radius;
    out.pose = object.pose;
    if (out != object || object.pose.theta != 0) {
      throw NoFit{tr("the %1 at %2 has a size, heading, mass, friction or way that a maze cannot "
                     "say")
                      .arg(name, at(object.pose.position()))};
    }
    out.pose = middle(object.pose, tr("the %1").arg(name));
    return out;
  }

  const Plan& plan_;
  bool all_things_;
  world::MazeGrid grid_;
};

/// The largest length, metres, of which all ends of walls and the floor's sides are multiples.
double common_measure(const Plan& plan) {
  long long measure = 0;
  const auto take = [&](double metres) {
    measure = std::gcd(measure, std::llround(metres * kMicro));
  };
  take(plan.width);
  take(plan.height);
  for (const world::Wall& wall : plan.walls) {
    for (const double coordinate : {wall.a.x, wall.a.y, wall.b.x, wall.b.y}) take(coordinate);
  }
  return static_cast<double>(measure) / kMicro;
}

}  // namespace

MazeFit fit_maze(const Plan& plan, bool all_things) {
  std::vector<double> cells;
  if (plan.cell) {
    cells.push_back(*plan.cell);
  } else {
    const double measure = common_measure(plan);
    for (int parts = 1; parts <= kFinest && measure / parts >= files::kLeastMazeCell; ++parts) {
      // Whole tenths of a millimetre: a file says them, and a person can read them.
      const double cell = std::round(measure / parts * 1e4) / 1e4;
      if (std::abs(cell * parts - measure) < kOnGrid) cells.push_back(cell);
    }
  }
  // What lies on no grid is told of the finest that anybody would draw.
  if (cells.empty()) cells.push_back(files::kLeastMazeCell);
  MazeFit fit;
  for (const double cell : cells) {
    try {
      return {MazeTrial(plan, cell, all_things).run(), {}};
    } catch (const NoFit& none) {
      if (fit.why.isEmpty()) fit.why = none.why;
    }
  }
  return fit;
}

}  // namespace eyebridge::gui
