#include "editor/plan_files.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

#include "editor/catalogue.hpp"
#include "editor/maze_fit.hpp"
#include "eyebridge/files/search.hpp"
#include "widgets/whole_file.hpp"

namespace eyebridge::gui {
namespace {

class PlanFilesText {
  Q_DECLARE_TR_FUNCTIONS(PlanFiles)
};

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return ending;
}

[[noreturn]] void refuse(const std::filesystem::path& path, const QString& why) {
  throw ConfigError({path.string(), 0, 0}, why.toStdString());
}

/// A floor's texture: in `folders`, else where names are looked for.
std::optional<std::filesystem::path> find_texture(const std::string& written,
                                                  std::vector<std::filesystem::path> folders) {
  const files::SearchPlaces places = search_places();
  for (std::filesystem::path& place : places.folders()) folders.push_back(std::move(place));
  return files::look_for(written, folders, places);
}

/// The comments before the first line that says something; the others are counted.
std::string header_of(std::string_view text, int& others) {
  std::string header;
  bool is_header = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t first = line.find_first_not_of(" \t\r");
    const bool is_empty = first == std::string_view::npos;
    const bool is_comment = !is_empty && (line[first] == '#' || line[first] == ';');
    if (is_header && is_comment) {
      header += std::string(line.substr(0, line.find_last_not_of('\r') + 1)) + '\n';
    } else {
      is_header = is_header && is_empty && header.empty();
      if (line.find_first_of("#;") != std::string_view::npos) ++others;
    }
  }
  return header;
}

void take_ground(const std::filesystem::path& path, PlanFiles& files) {
  const auto kind = files::ground_kind(path);
  if (!kind)
    refuse(path, PlanFilesText::tr("it is neither world nor maze: expected .wld, .maz or .sim"));
  if (kind != files::GroundKind::World && kind != files::GroundKind::Maze) {
    refuse(path, PlanFilesText::tr("it cannot be edited as it is: expected .wld, .maz or .sim; "
                                   "eyebridge world convert FILE FILE.wld makes one of it"));
  }
  const bool is_maze = *kind == files::GroundKind::Maze;
  const std::string text = is_maze ? files::read_maze_file(path) : files::read_text_file(path);
  const auto ground = is_maze ? files::read_maze(text, path.string(), files.warnings)
                              : files::read_world(text, path.string(), files.warnings);
  files.ground = path;
  if (!is_maze) files.ground_header = header_of(text, files.other_comments);
  Plan& plan = files.plan;
  plan.width = ground.width;
  plan.height = ground.height;
  plan.texture = ground.floor_texture;
  plan.water = ground.water;
  plan.walls = ground.walls;
  plan.starts = ground.starts;
  if (ground.maze) {
    plan.cell = ground.maze->cell;
    plan.goals = ground.maze->goals;
  }
  for (const world::ObjectSpec& object : ground.objects) plan.things.push_back({object, true});
}

void take_simulation(const std::filesystem::path& path, PlanFiles& files) {
  const std::string text = files::read_text_file(path);
  files::SimFile sim = files::read_sim(text, path.string(), files.warnings);
  files.header = header_of(text, files.other_comments);
  if (sim.world) {
    const auto ground =
        files::find_file(*sim.world, path.parent_path(), search_places(), sim.world_where);
    take_ground(ground, files);
  } else {
    constexpr double kRoom = 2.0;  // metres: what a run then takes
    files.plan = empty_plan(kRoom, kRoom);
  }
  for (world::ObjectSpec& object : sim.objects) {
    files.plan.things.push_back({std::move(object), false});
  }
  files.plan.markers = std::exchange(sim.markers, {});
  files.plan.robots = std::exchange(sim.robots, {});
  sim.objects.clear();
  sim.path_places.clear();
  files.plan.rest = std::move(sim);
}

/// Whether the ground's file would be the same.
bool same_ground(const Plan& a, const Plan& b) {
  const auto drawn = [](const Plan& plan) {
    std::vector<world::ObjectSpec> out;
    for (const Thing& thing : plan.things) {
      if (thing.is_drawn) out.push_back(thing.spec);
    }
    return out;
  };
  return ground_of(a, true) == ground_of(b, true) && a.cell == b.cell && a.goals == b.goals &&
         drawn(a) == drawn(b);
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::absolute(path, error).lexically_normal().parent_path();
}

class Saver {
 public:
  Saver(const Plan& plan, const PlanFiles& source, const std::filesystem::path& target)
      : source_(source), target_(target) {
    saving_.files = source;
    saving_.files.plan = plan;
    saving_.files.path = target;
    saving_.files.warnings.clear();
  }

  Saving run() {
    const std::string ending = ending_of(target_);
    if (ending == ".wld") {
      write_world();
    } else if (ending == ".maz") {
      write_maze(target_, true);
    } else if (ending == ".sim") {
      write_simulation();
    } else {
      refuse(target_, PlanFilesText::tr("unknown kind of file: expected .wld, .maz or .sim"));
    }
    return std::move(saving_);
  }

 private:
  Plan& plan() { return saving_.files.plan; }

  void write_world() {
    const files::SimFile sim = sim_of(plan());
    const auto count = plan().things.size() + plan().robots.size() + plan().markers.size();
    const bool more = !sim.errors.empty() || sim.show_sensors || sim.show_trail ||
                      !sim.robot_files.empty() || !sim.object_files.empty();
    if (count > 0 || more) {
      refuse(target_, PlanFilesText::tr(
                          "it has %1 robots, %2 objects, %3 markers%4: a .wld file holds walls, "
                          "start positions and a floor only; expected a .sim file")
                          .arg(plan().robots.size())
                          .arg(plan().things.size())
                          .arg(plan().markers.size())
                          .arg(more ? PlanFilesText::tr(", and settings or errors") : QString()));
    }
    write_ground(target_);
  }

  void write_ground(const std::filesystem::path& path) {
    const bool keeps = same_file(path, source_.ground);
    saving_.files.ground = path;
    if (!keeps) saving_.files.ground_header = path == target_ ? source_.header : std::string();
    if (keeps) saving_.files.ground_header = source_.ground_header;
    find_texture_from(folder_of(path));
    plan().cell.reset();
    plan().goals.clear();
    for (world::StartPose& start : plan().starts) start.letter = 0;
    saving_.texts.push_back(
        {path, saving_.files.ground_header + files::write_world(ground_of(plan(), false))});
  }

  void write_maze(const std::filesystem::path& path, bool all_things) {
    const MazeFit fit = fit_maze(plan(), all_things);
    if (!fit.maze) refuse(path, PlanFilesText::tr("it is no maze: %1").arg(fit.why));
    saving_.texts.push_back({path, files::write_maze(*fit.maze)});
    saving_.files.ground = path;
    saving_.files.ground_header.clear();
    if (!all_things) return;
    plan().starts = fit.maze->starts;  // with the letters that they got
    for (Thing& thing : plan().things) thing.is_drawn = true;
  }

  static bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code error;
    return !b.empty() && (a == b || std::filesystem::equivalent(a, b, error));
  }

  void write_simulation() {
    const bool was_simulation = ending_of(source_.path) == ".sim";
    if (was_simulation) {
      plan().rest.world = source_.plan.rest.world;  // not of the history: of the files
    } else {
      saving_.files.header.clear();
    }
    const bool is_new_place = source_.path.empty() || folder_of(target_) != folder_of(source_.path);
    const bool is_changed = source_.path.empty() || !same_ground(plan(), source_.plan);
    if (!was_simulation && !source_.path.empty() && !is_changed) {
      name_ground(source_.path);  // a world or maze gets its first simulation
    } else if (is_changed) {
      write_changed_ground();
    } else if (is_new_place && !source_.ground.empty()) {
      keep_found(plan().rest.world);
    }
    if (is_new_place) {
      for (auto* list : {&plan().rest.robot_files, &plan().rest.object_files}) {
        for (auto& [written, where] : *list) keep_robots_file(written);
      }
    }
    saving_.texts.push_back({target_, saving_.files.header + files::write_sim(sim_of(plan()))});
  }

  void write_changed_ground() {
    // Another simulation's ground is left alone, and so are the worlds that come with us.
    const bool beside = same_file(target_, source_.path) && !source_.ground.empty() &&
                        folder_of(source_.ground) == folder_of(target_);
    const std::string ending = ending_of(source_.ground);
    if (ending == ".maz" || (source_.path.empty() && plan().cell)) {
      const auto path = ground_path(beside, ".maz");
      if (fit_maze(plan(), false).maze) {
        write_maze(path, false);
        return name_ground(path);
      }
      leave_maze();
    }
    const auto path = ground_path(beside, ".wld");
    write_ground(path);
    name_ground(path);
  }

  /// The old ground's own file, or one of the simulation's name that is not there yet.
  [[nodiscard]] std::filesystem::path ground_path(bool beside, const std::string& ending) const {
    if (beside && ending_of(source_.ground) == ending) return source_.ground;
    auto path = target_;
    path.replace_extension(ending);
    std::error_code error;
    for (int i = 2; std::filesystem::exists(path, error); ++i) {
      path = target_.parent_path() / (target_.stem().string() + "-" + std::to_string(i) + ending);
    }
    return path;
  }

  /// What only a maze can say: letters of starts, and things that are drawn.
  void leave_maze() {
    for (std::size_t i = 0; i < plan().robots.size(); ++i) {
      files::SimRobot& robot = plan().robots[i];
      if (!robot.start) continue;
      const auto pose = pose_of_robot(saving_.files.plan, i);
      if (!pose) {
        refuse(target_, PlanFilesText::tr("a robot stands at a start '%1' that is not there: "
                                          "expected that start, or a place of its own")
                            .arg(QChar(*robot.start)));
      }
      resolved_.emplace_back(i, *pose);
    }
    for (const auto& [i, pose] : resolved_) {
      plan().robots[i].start.reset();
      plan().robots[i].pose = pose;
    }
    for (Thing& thing : plan().things) {
      thing.is_drawn = false;
      if (!world::corners_of(thing.spec).empty()) continue;  // its line says its size
      const world::ObjectSpec usual = builtin_thing(thing.spec.name);
      thing.spec.radius = usual.radius;
      thing.spec.height = usual.height;
    }
  }

  void name_ground(const std::filesystem::path& path) {
    const bool beside = folder_of(path) == folder_of(target_);
    plan().rest.world =
        beside ? path.filename().string() : std::filesystem::absolute(path).string();
    saving_.files.ground = path;
  }

  /// A name that is not found from the new folder becomes absolute.
  void keep_found(std::optional<std::string>& written) {
    if (!written) return;
    const std::string now = found_name(*written);
    written = now;
  }
  std::string found_name(const std::string& written) const {
    try {
      const auto before =
          files::find_file(written, source_.path.parent_path(), search_places(), {});
      try {
        const auto after = files::find_file(written, target_.parent_path(), search_places(), {});
        if (same_file(after, before)) return written;
      } catch (const ConfigError&) {
      }
      return std::filesystem::absolute(before).lexically_normal().string();
    } catch (const ConfigError&) {
      return written;  // it is not found now either
    }
  }
  void keep_robots_file(std::string& written) {
    const std::string now = found_name(written);
    for (files::SimRobot& robot : plan().robots) {
      if (robot.model == written) robot.model = now;
    }
    written = now;
  }

  void find_texture_from(const std::filesystem::path& folder) {
    if (!plan().texture) return;
    const auto file = texture_file(plan(), source_);
    if (file.empty()) return;
    const auto found = find_texture(*plan().texture, {folder, ""});
    if (!found || !same_file(*found, file)) {
      plan().texture = std::filesystem::absolute(file).lexically_normal().string();
    }
  }

  const PlanFiles& source_;
  const std::filesystem::path& target_;
  std::vector<std::pair<std::size_t, Pose>> resolved_;
  Saving saving_;
};

}  // namespace

PlanFiles open_plan(const std::filesystem::path& path) {
  PlanFiles files;
  const std::string ending = ending_of(path);
  if (ending == ".sim") {
    take_simulation(path, files);
  } else {
    take_ground(path, files);
    files.header = files.ground_header;
  }
  files.path = path;
  return files;
}

Saving plan_saving(const Plan& plan, const PlanFiles& source, const std::filesystem::path& target) {
  return Saver(plan, source, target).run();
}

void write_all_files(const std::vector<FileText>& texts) {
  std::vector<FileBytes> files;
  for (const FileText& text : texts) {
    files.push_back(
        {QString::fromStdString(text.path.string()), QByteArray::fromStdString(text.text)});
  }
  const WriteEnd end = write_all(files);
  if (end.why.isEmpty()) return;
  const std::filesystem::path path = end.path.toStdString();
  if (end.torn.isEmpty()) {
    refuse(path, PlanFilesText::tr("cannot be written (%1): expected a place where you may "
                                   "write; your edits are still here")
                     .arg(end.why));
  }
  refuse(path, PlanFilesText::tr("cannot be written (%1), but %2 has been written, which goes with "
                                 "it; your edits are still here: save them elsewhere")
                   .arg(end.why, end.torn.join(", ")));
}

std::filesystem::path texture_file(const Plan& plan, const PlanFiles& files) {
  if (!plan.texture) return {};
  return find_texture(*plan.texture, {files.ground.parent_path(), "", files.path.parent_path()})
      .value_or("");
}

}  // namespace eyebridge::gui
