#include "editor/catalogue.hpp"

#include <algorithm>
#include <cctype>

#include "eyebridge/files/search.hpp"

namespace eyebridge::gui {
namespace {

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

files::SearchPlaces search_places() { return files::SearchPlaces::of_process(); }

const std::vector<std::string>& builtin_things() {
  static const std::vector<std::string> names = {"golf",  "soccer", "can",
                                                 "crate", "box",    "polygon"};
  return names;
}

world::ObjectSpec builtin_thing(const std::string& name) {
  std::vector<Warning> warnings;
  // Of a box its size, of a polygon its corners: a triangle to begin with.
  const std::string line = name + " 0 0 0" +
                           (name == "box"       ? " 300 200"
                            : name == "polygon" ? " 150 0 -150 150 -150 -150"
                                                : "");
  return files::read_sim(line, "editor", warnings).objects.at(0);
}

Catalogue::Catalogue() {
  for (const std::string name : {"S4", "LabBot", "Mouse"}) {
    Entry entry;
    entry.radius = files::builtin_robot(name)->radius();
    entries_[lower_case(name)] = entry;
    names_.push_back(name);
  }
}

Catalogue::Catalogue(const files::SimFile& sim, const std::filesystem::path& directory)
    : Catalogue() {
  const auto guarded = [&](const auto& add) {
    try {
      add();
    } catch (const ConfigError& error) {
      problems_.emplace_back(error.what());
    }
  };
  for (const auto& file : sim.robot_files) {
    guarded([&] { add_robot(file.first, directory, file.second); });
  }
  for (const auto& file : sim.object_files) {
    guarded([&] { add_object(file.first, directory, file.second); });
  }
}

void Catalogue::add_robot(const std::string& written, const std::filesystem::path& directory,
                          const SourceLocation& where) {
  const auto path = files::find_file(written, directory, search_places(), where);
  std::vector<Warning> warnings;
  const auto model = files::read_robi(files::read_text_file(path), path.string(), warnings);
  Entry entry;
  entry.radius = model.radius();
  entries_[lower_case(written)] = entry;
  entries_[lower_case(model.name)] = entry;
  if (std::ranges::find(names_, model.name) == names_.end()) names_.push_back(model.name);
}

void Catalogue::add_object(const std::string& written, const std::filesystem::path& directory,
                           const SourceLocation& where) {
  const auto path = files::find_file(written, directory, search_places(), where);
  std::vector<Warning> warnings;
  Entry entry;
  entry.is_object = true;
  entry.object = files::read_object(files::read_text_file(path), path.string(),
                                    path.stem().string(), warnings);
  entry.radius = entry.object.outer_radius();
  entries_[lower_case(path.stem().string())] = entry;
  entries_[lower_case(entry.object.name)] = entry;
  names_.push_back(entry.object.name);
}

Catalogue::Entry Catalogue::find(const std::string& model) const {
  const auto found = entries_.find(lower_case(model));
  if (found != entries_.end()) return found->second;
  Entry unknown;
  unknown.is_known = false;
  return unknown;
}

}  // namespace eyebridge::gui
