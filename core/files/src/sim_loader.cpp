#include "sim_loader.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "builtin.hpp"
#include "eyebridge/files/readers.hpp"
#include "eyebridge/files/search.hpp"
#include "ground.hpp"
#include "object_lines.hpp"
#include "placement.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

class SimLoader {
 public:
  SimLoader(const SimFile& sim, const std::string& name, Scenario& scenario,
            const LoadOptions& options)
      : sim_(sim),
        name_(name),
        options_(options),
        places_(options.places),
        scenario_(scenario),
        reading_(options.reading) {}

  void load() {
    load_world();
    if (sim_.water) scenario_.world.water = sim_.water;
    scenario_.show_sensors = sim_.show_sensors;
    scenario_.show_trail = sim_.show_trail;
    scenario_.world.markers = sim_.markers;
    scenario_.world.objects.insert(scenario_.world.objects.end(), sim_.objects.begin(),
                                   sim_.objects.end());
    path_places_ = sim_.path_places;
    load_robot_files();
    load_object_files();
    // Custom objects look like robot lines; they are there before any robot is placed.
    std::vector<const SimRobot*> robots;
    for (const SimRobot& line : sim_.robots) {
      guard([&] {
        if (!place_object(line)) robots.push_back(&line);
      });
    }
    check_paths();
    placer_.emplace(scenario_, reading_);
    taken_.assign(scenario_.world.starts.size(), false);
    for (const SimRobot* line : robots) guard([&] { place_robot(*line); });
    if (scenario_.robots.empty() && !scenario_.newcomers.empty()) {
      throw ConfigError(scenario_.newcomers.front().where,
                        "all robots enter later: expected one that is there from the start");
    }
    std::ranges::stable_sort(scenario_.newcomers, {}, &Newcomer::time);
  }

 private:
  /// Does what one line says. Where reading is Tolerant, what that throws is a warning.
  template <class Do>
  void guard(Do act) {
    try {
      act();
    } catch (const ConfigError& error) {
      if (reading_ == Reading::Strict) throw;
      scenario_.warnings.push_back({error.where(), error.text() + "; the line is left out"});
    }
  }

  template <class Read>
  auto read_found(const std::string& written, const SourceLocation& where, Read read) {
    const auto path = find_file_of_others(written, scenario_.directory, places_, where,
                                          scenario_.warnings, reading_);
    return read(read_text_file(path), path);
  }

  void load_world() {
    if (!sim_.world) {
      scenario_.world = empty_room();
      scenario_.warnings.push_back(
          {{name_, 0, 0}, "no world or maze named: an empty room, 2 m x 2 m"});
      return;
    }
    const auto path = find_file_of_others(*sim_.world, scenario_.directory, places_,
                                          sim_.world_where, scenario_.warnings, reading_);
    const auto kind = ground_kind(path);
    if (!kind) {
      throw ConfigError(sim_.world_where, in_quotes(*sim_.world) +
                                              " is neither world nor maze: expected a .wld or "
                                              ".maz file, or a maze of a contest");
    }
    load_ground(path, *kind, scenario_, options_);
  }

  void load_robot_files() {
    for (const auto& [written, where] : sim_.robot_files) {
      guard([&, &written = written, &where = where] {
        const robot::RobotModel model =
            read_found(written, where, [&](const std::string& text, const auto& path) {
              return read_robi(text, path.string(), scenario_.warnings, reading_);
            });
        const std::size_t index = scenario_.models.size();
        scenario_.models.push_back(model);
        models_[lower(model.name)] = index;
        models_[lower(written)] = index;
      });
    }
  }

  void load_object_files() {
    for (const auto& [written, where] : sim_.object_files) {
      try {
        read_found(written, where, [&](const std::string& text, const std::filesystem::path& path) {
          const std::string stem = path.stem().string();
          const world::ObjectSpec object =
              read_object(text, path.string(), stem, scenario_.warnings, reading_);
          objects_[lower(stem)] = object;
          objects_[object.name] = object;
          return 0;
        });
      } catch (const ConfigError& error) {
        if (reading_ == Reading::Strict) throw;
        stand_in(written, error);
      }
    }
  }

  /// What has no usable file is drawn as a box that nobody moves.
  void stand_in(const std::string& written, const ConfigError& error) {
    world::ObjectSpec box = standing_box(lower(std::filesystem::path(written).stem().string()));
    scenario_.warnings.push_back(
        {error.where(), error.text() + "; " + in_quotes(box.name) + " is a box of 100 mm instead"});
    objects_[box.name] = std::move(box);
  }

  bool place_object(const SimRobot& line) {
    const auto found = objects_.find(lower(line.model));
    if (found == objects_.end()) return false;
    if (!line.pose || line.start || !line.program.empty()) {
      throw ConfigError(line.where, "object with a start letter or program: expected '" +
                                        found->first + " x y phi'");
    }
    if (line.enters) {
      throw ConfigError(line.enters_where,
                        "an object stands before this: expected the line of a "
                        "robot, which enters later");
    }
    world::ObjectSpec object = found->second;
    object.pose = *line.pose;
    apply(line.traits, object);
    scenario_.world.objects.push_back(object);
    path_places_.push_back(line.traits.path_where);
    return true;
  }

  /// An obstacle that could not go its way would stand there for good and look like a wall.
  void check_paths() {
    world::WorldModel& world = scenario_.world;
    const std::size_t first = world.objects.size() - path_places_.size();  // a maze's own: none
    for (std::size_t i = 0; i < path_places_.size(); ++i) {
      world::ObjectSpec& object = world.objects[first + i];
      if (!object.path) continue;
      guard([&] {
        const world::ObjectSpec moving = object;
        object.path.reset();  // it stands, unless the way is free
        check_path(moving, path_places_[i]);
        object.path = moving.path;
      });
    }
  }

  void check_path(const world::ObjectSpec& object, const SourceLocation& where) const {
    if (object.path->points.size() == 1 && object.path->points.front() == object.pose.position()) {
      throw ConfigError(where, "the only way-point is where the " + object.name +
                                   " stands: expected another place");
    }
    const auto wall = world::wall_on_path(scenario_.world, object);
    if (!wall) return;
    throw ConfigError(where, "the path leads the " + object.name + " into the wall " +
                                 in_words(scenario_.world.walls[*wall]) + ": expected a free way");
  }

  std::size_t model_of(const SimRobot& line) {
    const std::string key = lower(line.model);
    if (const auto found = models_.find(key); found != models_.end()) return found->second;
    const robot::RobotModel* builtin = builtin_robot(key);
    if (builtin == nullptr) {
      throw ConfigError(line.where, "no robot or object " + in_quotes(line.model) + ": expected " +
                                        std::string(builtin_names()) +
                                        ", or one that a 'robot' or 'object' line loads");
    }
    scenario_.models.push_back(*builtin);
    return models_[key] = scenario_.models.size() - 1;
  }

  /// The pose of a start letter: the first free one of exactly this letter, else of its other case.
  Pose start_pose(const SimRobot& line) {
    const auto& starts = scenario_.world.starts;
    for (const bool any_case : {false, true}) {
      for (std::size_t i = 0; i < starts.size(); ++i) {
        const char letter = starts[i].letter;
        const bool same =
            any_case ? lower({&letter, 1}) == lower({&*line.start, 1}) : letter == *line.start;
        if (letter == 0 || !same || taken_[i]) continue;
        taken_[i] = true;
        Pose pose = starts[i].pose;
        if (line.pose) pose.theta = line.pose->theta;
        return pose;
      }
    }
    throw ConfigError(line.where, std::string("no start '") + *line.start +
                                      "' left for this robot: expected that letter in the maze");
  }

  void refuse_traits(const ObjectTraits& traits) {
    const std::string text =
        "a robot stands before this: expected the line of an object, whose mass, path, ... it "
        "says; "
        "of a robot 'friction' can be said";
    if (reading_ == Reading::Strict) throw ConfigError(traits.where, text);
    scenario_.warnings.push_back({traits.where, text + "; the line is left out"});
  }

  void place_robot(const SimRobot& line) {
    if (!line.traits.fit_a_robot()) refuse_traits(line.traits);
    std::size_t model = model_of(line);
    if (line.traits.friction) {
      scenario_.models.push_back(scenario_.models[model]);
      model = scenario_.models.size() - 1;
      scenario_.models[model].contact_friction = *line.traits.friction;
    }
    if (line.enters) return let_enter(model, line);
    if (line.start) {
      placer_->place(model, start_pose(line), line.where);
    } else if (line.pose) {
      placer_->place(model, *line.pose, line.where);
    } else {
      place_at_next_start(model, line);
    }
    scenario_.robots.back().program = line.program;
    scenario_.robots.back().arguments = line.arguments;
  }

  /// Whether the place is free then shows when it enters; walls are there already.
  void let_enter(std::size_t model, const SimRobot& line) {
    if (!line.start && !line.pose) {
      throw ConfigError(line.where, "a robot without a place enters later: expected x y phi");
    }
    Newcomer newcomer{{}, *line.enters, line.where};
    newcomer.robot = {model, line.start ? start_pose(line) : *line.pose, line.program,
                      line.arguments};
    placer_->check_walls(model, newcomer.robot.pose, line.where);
    scenario_.newcomers.push_back(std::move(newcomer));
  }

  /// The old "robi FILE PROGRAM" without a pose: the world says where robots start.
  void place_at_next_start(std::size_t model, const SimRobot& line) {
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      if (taken_[i]) continue;
      taken_[i] = true;
      placer_->place(model, scenario_.world.starts[i].pose, line.where);
      return;
    }
    placer_->place_anywhere(model, line.where);
  }

  const SimFile& sim_;
  const std::string& name_;
  const LoadOptions& options_;
  const SearchPlaces& places_;
  Scenario& scenario_;
  Reading reading_;
  std::map<std::string, std::size_t> models_;
  std::map<std::string, world::ObjectSpec> objects_;
  std::vector<SourceLocation> path_places_;  ///< Of the objects that are not the maze's own.
  std::vector<bool> taken_;
  std::optional<Placer> placer_;  ///< Once walls and objects are there.
};

}  // namespace

std::vector<ErrorRule> load_sim(std::string_view text, const std::string& name, Scenario& scenario,
                                const LoadOptions& options) {
  SimFile sim = read_sim(text, name, scenario.warnings, options.reading);
  SimLoader(sim, name, scenario, options).load();
  return std::move(sim.errors);
}

}  // namespace eyebridge::files
