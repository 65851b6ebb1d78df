#include "eyebridge/files/map_files.hpp"

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "reading.hpp"

namespace eyebridge::files {
namespace {

using mapping::Cell;
using mapping::CellState;
using mapping::OccupancyGrid;

constexpr const char* kYaml =
    "image: room.pgm\n"
    "resolution: 0.05\n"
    "origin: [-1.5, 2.0, 0.0]\n"
    "negate: 0\n"
    "occupied_thresh: 0.65\n"
    "free_thresh: 0.196\n";

MapDescription described(const std::string& text) {
  std::vector<Warning> warnings;
  return read_map_description(text, "room.yaml", warnings);
}

OccupancyGrid checkered() {
  OccupancyGrid grid({{-1.25, 0.75}, 0.05, 7, 5});
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 7; ++column) {
      const int kind = (3 * row + column) % 5;
      if (kind != 0) grid.set_probability({column, row}, 0.15 * kind + 0.02 * row + 0.01);
    }
  }
  grid.set_probability({0, 4}, 1.0);
  grid.set_probability({6, 0}, 0.0);
  return grid;
}

TEST(MapDescription, TakesWhatMapServerTakes) {
  const MapDescription map = described(kYaml);
  EXPECT_EQ(map.image, "room.pgm");
  EXPECT_EQ(map.image_where, (SourceLocation{"room.yaml", 1, 8}));
  EXPECT_EQ(map.resolution, 0.05);
  EXPECT_EQ(map.origin, (Vec2{-1.5, 2.0}));
  EXPECT_FALSE(map.negate);
  EXPECT_EQ(map.mode, MapMode::Trinary);
}

TEST(MapDescription, TakesTheFormsThatYamlHas) {
  const MapDescription map = described(
      "---\nmode: scale   # of greys\nimage: 'my map.pgm'\nresolution: 1e-2\nnegate: true\n"
      "origin:\n- -1\n- 2.5\n- 0\nfree_thresh: 0.25\n...\n");
  EXPECT_EQ(map.image, "my map.pgm");
  EXPECT_EQ(map.origin, (Vec2{-1, 2.5}));
  EXPECT_TRUE(map.negate);
  EXPECT_EQ(map.mode, MapMode::Scale);
  EXPECT_EQ(map.free_thresh, 0.25);
  EXPECT_EQ(described("image: a b.pgm\nresolution: 1\norigin: [1,\n  2,\n 0]\n").image, "a b.pgm");
}

TEST(MapDescription, WarnsOfKeysThatItDoesNotKnow) {
  std::vector<Warning> warnings;
  read_map_description(std::string(kYaml) + "free_tresh: 0.3\n", "room.yaml", warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].str(),
            "room.yaml:7:1: warning: key 'free_tresh' is ignored: did you mean 'free_thresh'?");
}

struct BadMap {
  const char* name;
  std::string text;
  const char* message;
};
void PrintTo(const BadMap& row, std::ostream* out) { *out << row.name; }

std::string with(const std::string& old_part, const std::string& new_part) {
  std::string text = kYaml;
  return text.replace(text.find(old_part), old_part.size(), new_part);
}

class BadMapDescription : public testing::TestWithParam<BadMap> {};

TEST_P(BadMapDescription, IsAnErrorThatSaysWhatAndWhere) {
  EXPECT_EQ(error_of([] { described(GetParam().text); }), GetParam().message);
}

const BadMap kBadMaps[] = {
    {"Empty", "", "room.yaml:1:1: no map: expected lines 'key: value', image the first"},
    {"NoResolution", without(kYaml, "resolution: 0.05\n"),
     "room.yaml:6:1: file ends without 'resolution'"},
    {"NoOrigin", without(kYaml, "origin: [-1.5, 2.0, 0.0]\n"),
     "room.yaml:6:1: file ends without 'origin'"},
    {"NegativeResolution", with("0.05", "-0.05"),
     "room.yaml:2:13: resolution is -0.05: expected 0.0001 to 1000"},
    {"ZeroResolution", with("0.05", "0"),
     "room.yaml:2:13: resolution is 0: expected 0.0001 to 1000"},
    {"NanOrigin", with("-1.5", ".nan"),
     "room.yaml:3:10: '.nan' found: expected origin's x, a number"},
    {"NanWord", with("2.0", "nan"), "room.yaml:3:16: 'nan' found: expected origin's y, a number"},
    {"FarOrigin", with("2.0", "2e9"),
     "room.yaml:3:16: origin's y is 2e9: expected -1000000 to 1000000"},
    {"TurnedOrigin", with("2.0, 0.0", "2.0, x"),
     "room.yaml:3:21: 'x' found: expected origin's yaw, a number"},
    {"ShortOrigin", with(", 0.0]", "]"),
     "room.yaml:3:9: origin has 2 numbers: expected 3, [x, y, yaw]"},
    {"LongOrigin", with("0.0]", "0.0, 1]"),
     "room.yaml:3:9: origin has 4 numbers: expected 3, [x, y, yaw]"},
    {"NoColon", with("negate:", "negate"), "room.yaml:5:16: illegal map value"},
    {"Flag", with("negate: 0", "negate: 2"),
     "room.yaml:4:9: '2' found: expected 0, 1, false or true"},
    {"Twice", std::string(kYaml) + "negate: 1\n", "room.yaml:7:1: 'negate' is said twice"},
    {"NoValue", with("room.pgm", ""), "room.yaml:2:1: expected a value of 'image'"},
    {"Mode", std::string(kYaml) + "mode: grey\n",
     "room.yaml:7:7: mode 'grey' found: expected trinary, scale or raw"},
    {"Thresh", with("0.196", "0.9"), "room.yaml:6:14: free_thresh is above occupied_thresh"},
    {"NoShare", with("0.65", "1.5"), "room.yaml:5:18: occupied_thresh is 1.5: expected 0 to 1"},
    {"Certain", with("0.65", "1"),
     "room.yaml:5:18: occupied_thresh is 1: expected more than 0 and less than 1"},
};
INSTANTIATE_TEST_SUITE_P(Cases, BadMapDescription, testing::ValuesIn(kBadMaps),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(MapPicture, MayBeOfAnyKindOfPnm) {
  const GreyPicture black_and_white{2, 1, {0, 255}};
  EXPECT_EQ(read_map_picture("P1 2 1 1 0", "p.pbm"), black_and_white);
  EXPECT_EQ(read_map_picture("P4 2 1\n\x80", "p.pbm"), black_and_white);
  EXPECT_EQ(read_map_picture("P3 2 1 255 0 0 0 255 255 255", "p.ppm"), black_and_white);
  EXPECT_EQ(read_map_picture("P3 1 1 255 10 20 31", "p.ppm"), (GreyPicture{1, 1, {20}}));
  EXPECT_EQ(read_map_picture("P2 2 1 65535 0 65535", "p.pgm"), black_and_white);
}

TEST(Pgm, IsReadInBothForms) {
  const GreyPicture expected{3, 2, {0, 128, 255, 7, 8, 9}};
  EXPECT_EQ(read_map_picture("P2 # plain\n3 2\n255\n0 128 255\n7 8 9\n", "p.pgm"), expected);
  EXPECT_EQ(
      read_map_picture(std::string("P5\n# map_saver\n3 2\n255\n\0\x80\xFF\7\x8\x9", 29), "p.pgm"),
      expected);
  EXPECT_EQ(read_map_picture("P2 2 1 100 50 100", "p.pgm"), (GreyPicture{2, 1, {128, 255}}));
}

TEST(Pgm, ThatIsBadIsAnErrorThatSaysWhatAndWhere) {
  const auto error = [](const std::string& bytes) {
    return error_of([&] { read_map_picture(bytes, "p.pgm"); });
  };
  EXPECT_EQ(error(""), "p.pgm: no picture that a map can have: expected PGM, PNG or BMP");
  EXPECT_EQ(error("\x89PNG\r\n"), "p.pgm: a PNG that ends too early: expected a whole file");
  EXPECT_EQ(error("P5\n2 x\n255\n"), "p.pgm:2:3: no number: expected the height");
  EXPECT_EQ(error("P5\n2"), "p.pgm:2:2: file ends: expected the height");
  EXPECT_EQ(error("P5\n-2 2\n255\n"), "p.pgm:2:1: no number: expected the width");
  EXPECT_EQ(error("P5\n0 2\n255\n"), "p.pgm:2:1: the width is 0: expected 1 to 16777216");
  EXPECT_EQ(error("P5\n99999999999999999999 2\n255\n"),
            "p.pgm:2:1: the width is 99999999999999999999: expected 1 to 16777216");
  EXPECT_EQ(error("P5\n10000 10000\n255\n"),
            "p.pgm:2:12: picture of 10000 x 10000 pixels: expected at most 67108864");
  EXPECT_EQ(error("P5\n2 2\n65536\n"),
            "p.pgm:3:1: the largest value is 65536: expected 1 to 65535");
  EXPECT_EQ(error("P5\n2 2\n255\nabc"), "p.pgm:4:1: file has 3 bytes of pixels: expected 4, 2 x 2");
  EXPECT_EQ(error("P5\n2 2\n255"),
            "p.pgm:3:4: expected a blank or the end of the line before the pixels");
  EXPECT_EQ(error("P2\n2 2\n9\n1 2 3\n"), "p.pgm:5:1: file ends: expected a value");
  EXPECT_EQ(error("P2\n4000 4000\n9\n1 2 3\n"),
            "p.pgm:3:2: file has 7 bytes of pixels: expected at least 31999999, 4000 x 4000");
  EXPECT_EQ(error("P2\n1 1\n9\n10\n"), "p.pgm:4:1: a value is 10: expected 0 to 9");
}

TEST(Map, StandsForWhatMapServerMakesOfIt) {
  MapDescription map = described(kYaml);
  const GreyPicture picture{4, 2, {0, 254, 205, 100, 89, 90, 50, 204}};
  const OccupancyGrid trinary = map_of(map, picture);
  EXPECT_EQ(trinary.geometry(), (mapping::GridGeometry{{-1.5, 2.0}, 0.05, 4, 2}));
  EXPECT_EQ(trinary.state(Cell{0, 1}), CellState::Occupied) << "the upper left pixel";
  EXPECT_EQ(trinary.state(Cell{1, 1}), CellState::Free);
  EXPECT_EQ(trinary.log_odds({2, 1}), 0.0F) << "205 is unknown by a hair";
  EXPECT_EQ(trinary.log_odds({3, 1}), 0.0F);
  EXPECT_EQ(trinary.state(Cell{0, 0}), CellState::Occupied) << "166 / 255 is 0.651";
  EXPECT_EQ(trinary.log_odds({1, 0}), 0.0F) << "165 / 255 is 0.647";
  map.mode = MapMode::Scale;
  EXPECT_NEAR(map_of(map, picture).probability(Cell{3, 1}), (155.0 / 255 - 0.196) / (0.65 - 0.196),
              1e-6);
  map.mode = MapMode::Raw;
  const OccupancyGrid raw = map_of(map, picture);
  EXPECT_NEAR(raw.probability(Cell{0, 0}), 0.89, 1e-6);
  EXPECT_EQ(raw.log_odds({1, 1}), 0.0F);
  EXPECT_EQ(raw.state(Cell{3, 1}), CellState::Occupied);
  map.mode = MapMode::Trinary;
  map.negate = true;
  EXPECT_EQ(map_of(map, picture).state(Cell{1, 1}), CellState::Occupied);
}

TEST(Map, LeavesUnknownWhatItDoesNotKnowWhereverItsThresholdsLie) {
  struct Row {
    double occupied;
    double free;
    std::uint8_t unknown;  // a grey between the two
  };
  for (const Row& row : {Row{0.45, 0.196, 150}, Row{0.65, 0.55, 102}}) {
    MapDescription description;
    description.occupied_thresh = row.occupied;
    description.free_thresh = row.free;
    const mapping::OccupancyGrid grid = map_of(description, {3, 1, {0, row.unknown, 254}});
    EXPECT_EQ(grid.state(mapping::Cell{0, 0}), mapping::CellState::Occupied);
    EXPECT_EQ(grid.state(mapping::Cell{1, 0}), mapping::CellState::Unknown) << row.occupied;
    EXPECT_EQ(grid.state(mapping::Cell{2, 0}), mapping::CellState::Free);
  }
}

TEST(Map, IsNotSavedOverItsOwnPicture) {
  EXPECT_THROW(save_map(mapping::OccupancyGrid({{}, 1.0, 1, 1}), "room.pgm"), ConfigError);
}

TEST(Map, SurvivesBeingWrittenAndRead) {
  const OccupancyGrid grid = checkered();
  for (const MapMode mode : {MapMode::Trinary, MapMode::Scale, MapMode::Raw}) {
    const MapTexts texts = write_map(grid, "a map.pgm", mode);
    const OccupancyGrid again = map_of(described(texts.yaml), read_map_picture(texts.pgm, "p.pgm"));
    ASSERT_EQ(again.geometry(), grid.geometry());
    for (int row = 0; row < 5; ++row) {
      for (int column = 0; column < 7; ++column) {
        const Cell cell{column, row};
        if (mode == MapMode::Trinary) {
          EXPECT_EQ(again.state(cell), grid.state(cell)) << column << ' ' << row;
        } else {
          EXPECT_NEAR(again.probability(cell), grid.probability(cell), 0.0075);
        }
      }
    }
    EXPECT_EQ(described(texts.yaml).image, "a map.pgm");
  }
}

TEST(Map, IsSavedAndLoadedWithItsPicture) {
  const Folder folder;
  const OccupancyGrid grid = checkered();
  const auto path = folder.path() / "room.yaml";
  save_map(grid, path);
  std::vector<Warning> warnings;
  const OccupancyGrid again = load_map(path, warnings);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(again.geometry(), grid.geometry());
  EXPECT_EQ(again.state(Cell{0, 4}), CellState::Occupied);

  std::filesystem::remove(folder.path() / "room.pgm");
  EXPECT_EQ(error_of([&] { load_map(path, warnings); }),
            path.string() + ":1:8: no such file: '" + (folder.path() / "room.pgm").string() + "'");
  std::filesystem::create_directory(folder.path() / "room.pgm");
  EXPECT_EQ(error_of([&] { load_map(path, warnings); }),
            (folder.path() / "room.pgm").string() + ": is not a file: expected a picture");
  EXPECT_EQ(error_of([&] { save_map(grid, folder.path() / "no" / "room.yaml"); }),
            (folder.path() / "no" / "room.pgm").string() +
                ": cannot be written: No such file or directory");
}

TEST(MapFiles, ADiskThatIsFullLeavesTheMapThatWasThere) {
  const Folder folder;
  const auto path = folder.path() / "room.csv";
  save_map_csv(checkered(), path);
  const std::string before = read_text_file(path);
  OccupancyGrid other({{0, 0}, 0.05, 50, 50});
  rlimit usual{};
  getrlimit(RLIMIT_FSIZE, &usual);
  const auto old = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit little{16, usual.rlim_max};
  setrlimit(RLIMIT_FSIZE, &little);
  const std::string error = error_of([&] { save_map_csv(other, path); });
  setrlimit(RLIMIT_FSIZE, &usual);
  std::signal(SIGXFSZ, old);
  EXPECT_EQ(error, path.string() + ": cannot be written: File too large");
  EXPECT_EQ(read_text_file(path), before);
  const std::filesystem::directory_iterator all(folder.path());
  EXPECT_EQ(std::distance(begin(all), end(all)), 1) << "nothing is left beside it";
}

TEST(MapFiles, ALinkStaysOne) {
  const Folder folder;
  save_map_csv(checkered(), folder.path() / "real.csv");
  std::filesystem::create_symlink("real.csv", folder.path() / "link.csv");
  save_map_csv(OccupancyGrid({{0, 0}, 0.05, 50, 50}), folder.path() / "link.csv");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link.csv"));
  EXPECT_EQ(read_map_csv(read_text_file(folder.path() / "real.csv"), "real.csv").geometry().columns,
            50);
}

TEST(MapCsv, SurvivesBeingWrittenAndRead) {
  const OccupancyGrid grid = checkered();
  const std::string text = write_map_csv(grid);
  EXPECT_EQ(text.substr(0, text.find('\n', 18) + 1), "resolution,0.05\norigin,-1.25,0.75\n");
  const OccupancyGrid again = read_map_csv(text, "room.csv");
  EXPECT_EQ(again.geometry(), grid.geometry());
  EXPECT_EQ(write_map_csv(again), text);
  for (int column = 0; column < 7; ++column) {
    EXPECT_NEAR(again.probability(Cell{column, 4}), grid.probability(Cell{column, 4}), 6e-5);
  }
}

TEST(Map, ThatNoReaderWouldTakeIsNotWritten) {
  const Folder folder;
  const auto refused = [&](const mapping::GridGeometry& geometry) {
    mapping::OccupancySettings settings;
    settings.max_cells = 1U << 27U;
    const OccupancyGrid grid(geometry, settings);
    std::string error = error_of([&] { save_map(grid, folder.path() / "room.yaml"); });
    EXPECT_EQ(error_of([&] { save_map_csv(grid, folder.path() / "room.csv"); }), error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    return error;
  };
  EXPECT_EQ(refused({{0, 0}, 2e3, 1, 1}), "map with cells of 2000 m: expected 1e-04 to 1000");
  EXPECT_EQ(refused({{0, -2e6}, 1.0, 1, 1}),
            "map whose origin is at 0, -2e+06 m: expected at most 1e+06");
  EXPECT_EQ(refused({{0, 0}, 1.0, 8193, 8192}), "map of 67117056 cells: expected at most 67108864");
}

TEST(MapCsv, OfMoreThanAnyFileMayHaveIsNotWritten) {
  const OccupancyGrid grid({{0, 0}, 1.0, 4096, 4096});
  EXPECT_EQ(
      error_of([&] { write_map_csv(grid); }),
      "map of 117440536 bytes as CSV: expected at most 67108864, or a .yaml with its picture");
}

TEST(MapCsv, ThatIsBadIsAnErrorThatSaysWhatAndWhere) {
  const auto error = [](const std::string& text) {
    return error_of([&] { read_map_csv(text, "room.csv"); });
  };
  const std::string head = "resolution,0.05\norigin,0,0\n";
  EXPECT_EQ(error(""), "room.csv:1:1: file ends: expected 'resolution,0.05'");
  EXPECT_EQ(error("0.5,0.5\n"), "room.csv:1:1: '0.5' found: expected 'resolution'");
  EXPECT_EQ(error("resolution,-1\n"),
            "room.csv:1:12: the resolution is -1: expected 0.0001 to 1000");
  EXPECT_EQ(error("resolution,0.05,1\n"), "room.csv:1:17: more on the line than expected");
  EXPECT_EQ(error("resolution,0.05\norigin,nan,0\n"),
            "room.csv:2:8: 'nan' found: expected origin's x, a number");
  EXPECT_EQ(error("resolution,0.05\norigin,0\n"), "room.csv:2:9: line ends: expected origin's y");
  EXPECT_EQ(error(head), "room.csv:3:1: file ends: expected a row of probabilities");
  EXPECT_EQ(error(head + "0.5,0.6\n0.5\n"),
            "room.csv:4:1: row of 1 cells: expected 2, as in the first row");
  EXPECT_EQ(error(head + "0.5,1.6\n"), "room.csv:3:5: a probability is 1.6: expected 0 to 1");
  EXPECT_EQ(error(head + "0.5,\n"), "room.csv:3:5: '' found: expected a probability, a number");
  EXPECT_EQ(error(head + "0.5;0.5\n"),
            "room.csv:3:1: '0.5;0.5' found: expected a probability, a number");
}

}  // namespace
}  // namespace eyebridge::files
