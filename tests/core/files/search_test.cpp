#include "eyebridge/files/search.hpp"

#include <cstdlib>
#include <optional>

#include <gmock/gmock.h>

#include "eyebridge/base/own_place.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

namespace fs = std::filesystem;

/// Makes `folder` the working folder until the end of the test.
class WorkingFolder {
 public:
  explicit WorkingFolder(const fs::path& folder) : before_(fs::current_path()) {
    fs::current_path(folder);
  }
  ~WorkingFolder() { fs::current_path(before_); }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

 private:
  fs::path before_;
};

/// Sets a variable of this process until the end of the test; no value removes it.
class Variable {
 public:
  Variable(const char* name, const std::optional<std::string>& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    put(value);
  }
  ~Variable() { put(before_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  void put(const std::optional<std::string>& value) {
    if (value) {
      setenv(name_, value->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }

  const char* name_;
  std::optional<std::string> before_;
};

class Search : public testing::Test {
 protected:
  Search() {
    for (const char* name : {"here", "sim", "home", "prog/worlds", "user", "installed"}) {
      fs::create_directories(folder_.path() / name);
    }
    here_.emplace(folder_.path() / "here");
    places_ = {at("home"), at("prog/worlds"), at("user"), at("installed")};
  }
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  fs::path found(const std::string& name) const {
    return fs::absolute(find_file(name, at("sim"), places_, {"a.sim", 1, 7}));
  }
  std::string refusal(const std::string& name) const {
    return error_of([&] { (void)find_file(name, at("sim"), places_, {"a.sim", 1, 7}); });
  }

  const Folder folder_;
  std::optional<WorkingFolder> here_;
  SearchPlaces places_;
};

TEST_F(Search, EachPlaceComesBeforeThoseBehindIt) {
  const std::vector<std::string> order = {"here",        "sim",  "home",
                                          "prog/worlds", "user", "installed"};
  for (const std::string& place : order) folder_.write(place + "/a.wld", "");
  for (const std::string& place : order) {
    EXPECT_EQ(found("a.wld"), at(place) / "a.wld");
    fs::remove(at(place) / "a.wld");
  }
  EXPECT_THAT(refusal("a.wld"), StartsWith("a.sim:1:7: no file 'a.wld': expected "));
}

TEST_F(Search, APathIsTakenAsGiven) {
  const fs::path given = folder_.write("other/a.wld", "");
  folder_.write("installed/a.wld", "");
  EXPECT_EQ(found(given.string()), given);
  EXPECT_EQ(fs::canonical(found("../other/a.wld")), fs::canonical(given));
  EXPECT_EQ(fs::canonical(found("..\\other\\a.wld")), fs::canonical(given));
}

TEST_F(Search, ANameThatIsNotFoundSuggestsTheNearestOnes) {
  for (const char* name : {"rooms.wld", "room5.wld", "roomy.maz", "corridor.wld", "rooms.robi"}) {
    folder_.write(std::string("installed/") + name, "");
  }
  folder_.write("user/rooms.wld", "");
  EXPECT_THAT(refusal("romms.wld"), HasSubstr("expected 'rooms.wld' or 'room5.wld'; looked in"));
  EXPECT_THAT(refusal("Corridor.WLD"),
              HasSubstr("expected 'corridor.wld' (only the case differs); looked in"));
  EXPECT_THAT(refusal("corridor"), HasSubstr("expected 'corridor.wld'; looked in"));
  EXPECT_THAT(refusal("corridor.maz"), HasSubstr("expected 'corridor.wld'; looked in"));
  EXPECT_THAT(refusal("corridor.wdl"), HasSubstr("expected 'corridor.wld'; looked in"));
  EXPECT_THAT(refusal("worlds/corridor.wld"), HasSubstr("expected 'corridor.wld'; looked in"));
  EXPECT_THAT(refusal("rooms2.robi"), HasSubstr("expected 'rooms.robi'; looked in"));
  EXPECT_THAT(refusal("zebra.wld"),
              HasSubstr("expected a path, or a name that eyebridge world list shows; looked in"));
}

TEST_F(Search, AFolderInTheNameIsKeptInSuggestions) {
  folder_.write("installed/robots/S4.robi", "");
  EXPECT_THAT(refusal("robots/s4.robi"),
              HasSubstr("expected 'robots/S4.robi' (only the case differs)"));
  const fs::path there = folder_.write("other/Rooms.wld", "");
  EXPECT_THAT(refusal((there.parent_path() / "rooms.wld").string()),
              HasSubstr("expected '" + there.string() + "' (only the case differs); looked in " +
                        there.parent_path().string()));
}

TEST_F(Search, SuggestsThreeNamesAtMost) {
  for (const char* name : {"aaaaaaa1", "aaaaaaa2", "aaaaaaa3", "aaaaaaa4"}) {
    folder_.write(std::string("user/") + name + ".wld", "");
  }
  EXPECT_THAT(similar_files("aaaaaaa.wld", {at("user")}),
              ElementsAre("aaaaaaa1.wld", "aaaaaaa2.wld", "aaaaaaa3.wld"));
  EXPECT_THAT(similar_files(std::string(5000, 'a'), {at("user")}), ElementsAre());
}

TEST_F(Search, TheMessageSaysWhereItWasLookedFor) {
  EXPECT_THAT(refusal("zebra.wld"),
              EndsWith("; looked in the working folder, " + at("sim").string() + ", " +
                       at("home").string() + ", " + at("prog/worlds").string() + ", " +
                       at("user").string() + ", " + at("installed").string()));
  EXPECT_THAT(refusal("/nowhere/zebra.wld"), EndsWith("; looked in /nowhere"));
}

TEST_F(Search, PlacesOfAProcessFollowItsVariables) {
  const Variable home("HOME", at("h").string());
  const Variable sim("EYESIM_HOME", "/eyesim");
  const Variable unset("XDG_DATA_HOME", std::nullopt);
  SearchPlaces places = SearchPlaces::of_process("bin/prog");
  EXPECT_EQ(places.eyesim_home, "/eyesim");
  EXPECT_EQ(places.program, fs::current_path() / "bin/worlds");
  EXPECT_EQ(places.user, at("h/.local/share/eyebridge/worlds"));
  EXPECT_EQ(places.installed, share_folder() / "worlds");
  EXPECT_EQ(SearchPlaces::of_process("prog").program, fs::current_path() / "worlds");
  EXPECT_EQ(SearchPlaces::of_process().program, "");
  {
    const Variable data("XDG_DATA_HOME", "/data");
    EXPECT_EQ(SearchPlaces::of_process().user, "/data/eyebridge/worlds");
  }
  const Variable relative("XDG_DATA_HOME", "data");
  EXPECT_EQ(SearchPlaces::of_process().user, at("h/.local/share/eyebridge/worlds"));
}

TEST_F(Search, ScenariosAreLoadedByName) {
  EXPECT_FALSE(own_worlds().empty());
  EXPECT_EQ(load_scenario("maze-5.maz", {.robot = "Mouse"}).directory, own_worlds());
  const std::string error = error_of([&] { load_scenario("Maze-5.maz", {.robot = "Mouse"}); });
  EXPECT_THAT(error, HasSubstr("no file 'Maze-5.maz': expected 'maze-5.maz' (only the case"));
}

TEST(Description, IsTheFirstLineOfTheFirstComment) {
  EXPECT_EQ(description_in("; Four rooms.\n; More.\nfloor 1 1\n"), "Four rooms.");
  EXPECT_EQ(description_in("\n\n  ## Two kinds \r\nworld a.wld\n"), "Two kinds");
  EXPECT_EQ(description_in("\xEF\xBB\xBF# A room\n"), "A room");
  EXPECT_EQ(description_in("floor 1 1\n; later\n"), "");
  EXPECT_EQ(description_in(" _ _\n|   |\n"), "");
  EXPECT_EQ(description_in("#\n# second line\n"), "");
  EXPECT_EQ(description_in("# a\tb\x01\n"), "a?b?");
  EXPECT_EQ(description_in(""), "");
}

}  // namespace
}  // namespace eyebridge::files
