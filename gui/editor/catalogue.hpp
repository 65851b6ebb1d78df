#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "eyebridge/files/load.hpp"
#include "eyebridge/files/readers.hpp"

namespace eyebridge::gui {

/// What the robots and described objects of a plan look like: the built-in ones, and those of the
/// files that a simulation names.
class Catalogue {
 public:
  struct Entry {
    bool is_object = false;      ///< Else a robot.
    bool is_known = true;        ///< Else a file is missing: drawn as an S4 is.
    double radius = 0.093;       ///< Metres.
    world::ObjectSpec object{};  ///< Of objects.
  };

  Catalogue();
  /// Reads the files that `sim`, which lies in `directory`, names. Those that cannot be read are
  /// told of in problems(), one message a file.
  Catalogue(const files::SimFile& sim, const std::filesystem::path& directory);

  /// By the name that a line gives, case ignored.
  [[nodiscard]] Entry find(const std::string& model) const;
  /// The names that a person may choose among: robots, then objects that files describe.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

 private:
  void add_robot(const std::string& written, const std::filesystem::path& directory,
                 const SourceLocation& where);
  void add_object(const std::string& written, const std::filesystem::path& directory,
                  const SourceLocation& where);

  std::map<std::string, Entry> entries_;  ///< By lower-case name.
  std::vector<std::string> names_;
  std::vector<std::string> problems_;
};

/// Search places for files named in other files: those of a run, without the worlds beside a
/// program.
files::SearchPlaces search_places();

/// The things that need no file: golf, soccer, can, crate, box, polygon.
const std::vector<std::string>& builtin_things();
/// One of them, at the origin.
world::ObjectSpec builtin_thing(const std::string& name);

}  // namespace eyebridge::gui
