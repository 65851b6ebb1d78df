// SVG drawings as worlds. The judge is librsvg: what it paints dark is where our walls are.
#include <cstdlib>

#include <gmock/gmock.h>

#include "eyebridge/files/foreign_worlds.hpp"
#include "eyebridge/mapping/ground_truth.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct ReadDrawing {
  world::WorldModel model;
  std::vector<std::string> warnings;
};

ReadDrawing read_drawing(const std::string& svg) {
  std::vector<Warning> warnings;
  ReadDrawing out{read_svg(svg, "d.svg", warnings), {}};
  for (const Warning& warning : warnings) out.warnings.push_back(warning.str());
  return out;
}

std::string page(const std::string& inside) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"2000mm\" height=\"1000mm\" "
         "viewBox=\"0 0 2000 1000\">" +
         inside + "</svg>";
}

/// Pixels of 10 mm that librsvg paints dark.
GreyPicture painted(const std::string& svg) {
  const Folder folder;
  const auto from = folder.write("d.svg", svg);
  const std::string to = (folder.path() / "d.png").string();
  const std::string command = "rsvg-convert -w 200 -h 100 -b white -o " + to + " " + from.string();
  EXPECT_EQ(std::system(command.c_str()), 0) << "librsvg2-bin, see cmake/packages.txt";
  return read_map_picture(read_bytes(to, "a picture"), to);
}

/// How many dark pixels have no wall within a pixel, or walls no dark pixel.
int missed(const std::string& svg) {
  const GreyPicture picture = painted(svg);
  const auto truth = mapping::truth_of(read_drawing(svg).model, {.resolution = 0.01, .margin = 0});
  const auto is_dark = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < 200 && y < 100 &&
           picture.greys[static_cast<std::size_t>(y * 200 + x)] < 200;
  };
  const auto is_wall = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < 200 && y < 100 &&
           truth.state(mapping::Cell{x, 99 - y}) == mapping::CellState::Occupied;
  };
  int wrong = 0;
  int walls = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 200; ++x) {
      bool dark_near = false;
      bool wall_near = false;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          dark_near = dark_near || is_dark(x + dx, y + dy);
          wall_near = wall_near || is_wall(x + dx, y + dy);
        }
      }
      walls += is_wall(x, y) ? 1 : 0;
      wrong += (is_dark(x, y) && !wall_near) || (is_wall(x, y) && !dark_near) ? 1 : 0;
    }
  }
  EXPECT_GT(walls, 30);
  return wrong;
}

TEST(Svg, WallsAreWhereLibrsvgPaints) {
  const std::string strokes = "<g fill=\"none\" stroke=\"black\" stroke-width=\"20\">";
  for (const std::string inside : {
           "<path d=\"M100 100h300v200l-50 50.5 -100-20z\"/>",
           "<path d=\"m 100,500 C 100 100 700 100 700 500 S 1300 900 1300 500\"/>",
           "<path d=\"M200 500 Q 400 100 600 500 T 1000 500 t400 0\"/>",
           "<path d=\"M600 350 A 250 150 30 0 1 1100 500 a250 100 -20 1 0 300-200\"/>",
           "<path d=\"M300 300a100 100 0 11200 0z M900 300A200 100 0 0 0 1300 700\"/>",
           "<rect x=\"100\" y=\"50\" width=\"400\" height=\"25%\"/><circle cx=\"50%\" cy=\"500\" "
           "r=\"200\"/><ellipse cx=\"1500\" cy=\"500\" rx=\"300\" ry=\"100\"/>",
           "<line x1=\"100\" y1=\"900\" x2=\"1900\" y2=\"100\"/>",
           "<polyline points=\"100,100 500 500, 900,100\"/><polygon points=\"1000,800 1200 500 "
           "1400,800\"/>",
           "<g transform=\"translate(1000 500) rotate(30)\"><rect x=\"-300\" y=\"-100\" "
           "width=\"600\" height=\"200\"/></g>",
           "<g transform=\"rotate(-20,1000,500)scale(2,1.5)\"><path d=\"M300 200L600 400\"/></g>",
           "<g transform=\"skewX(20) skewY(-5)\"><rect x=\"300\" y=\"300\" width=\"600\" "
           "height=\"300\"/></g>",
           "<rect transform=\"matrix(0.9 0.2 -0.3 1.1 300 20)\" x=\"100\" y=\"300\" width=\"600\" "
           "height=\"300\"/>",
           "<a><g style=\"stroke-width: 40; stroke:#222\"><path d=\"M100 500H1900\"/></g></a>",
       }) {
    EXPECT_EQ(missed(page(strokes + inside + "</g>")), 0) << inside;
  }
}

TEST(Svg, OtherScalesAndPages) {
  // Inches, a page that begins elsewhere, a page of another shape than its box.
  const std::string line = "<path d=\"M10 20H60V40\" fill=\"none\" stroke=\"#000\"/>";
  const std::string head = "<svg xmlns=\"http://www.w3.org/2000/svg\" ";
  const auto inches = read_drawing(
      head + "width=\"20in\" height=\"10in\" viewBox=\"-10 0 100 50\">" + line + "</svg>");
  EXPECT_NEAR(inches.model.width, 0.508, 1e-9);
  ASSERT_EQ(inches.model.walls.size(), 2U);
  EXPECT_NEAR(inches.model.walls[0].a.x, 20 * 0.00508, 1e-9);
  EXPECT_NEAR(inches.model.walls[0].a.y, 30 * 0.00508, 1e-9);
  EXPECT_NEAR(inches.model.walls[0].thickness, 0.00508, 1e-9);
  EXPECT_THAT(inches.warnings, ElementsAre());
  const auto plain = read_drawing(head + "viewBox=\"0 0 100 50\">" + line + "</svg>");
  EXPECT_NEAR(plain.model.width, 0.1, 1e-9);
  EXPECT_THAT(plain.warnings, ElementsAre(HasSubstr("d.svg:1:2: warning: no size in millimetres")));
  const auto no_page = read_drawing(head + ">" + line + "</svg>");
  EXPECT_NEAR(no_page.model.width, 0.051, 1e-9);
}

TEST(Svg, FilledShapesAreRimsAndWhiteIsPaper) {
  const auto read = read_drawing(
      page("<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
           "<rect x=\"500\" y=\"200\" width=\"100\" height=\"50\" style=\"fill:#c00\"/>\n"
           "<rect x=\"900\" y=\"200\" width=\"100\" height=\"50\"/>"));
  ASSERT_EQ(read.model.walls.size(), 8U);
  EXPECT_EQ(read.model.walls[0].thickness, 0);
  EXPECT_EQ(read.model.walls[0].colour, (Rgb{204, 0, 0}));
  EXPECT_EQ(read.model.walls[4].colour, world::Wall::kDefaultColour) << "black: no colour said";
  EXPECT_NEAR(read.model.walls[0].a.y, 0.8, 1e-12) << "y counts downwards in drawings";
  EXPECT_THAT(read.warnings, ElementsAre(HasSubstr("white shapes")));
}

TEST(Svg, WhatIsNotCarriedOverIsSaid) {
  const auto read =
      read_drawing(page("<style>.a{fill:red}</style>\n<text x=\"1\">Hall</text><text>Room</text>\n"
                        "<rect display=\"none\" width=\"10\" height=\"10\"/><use href=\"#x\"/>\n"
                        "<path d=\"M0 0H5\" fill=\"none\"/>\n<defs><path d=\"M0 0H9\"/></defs>\n"
                        "<path d=\"M0 0H5V5\" fill=\"url(#g)\"/>"));
  EXPECT_EQ(read.model.walls.size(), 3U);
  EXPECT_THAT(
      read.warnings,
      ElementsAre(
          HasSubstr("d.svg:2:2: warning: not carried over: <text> (2 times)"),
          HasSubstr("d.svg:3:47: warning: not carried over: <use>"),
          HasSubstr("d.svg:6:2: warning: not carried over: colours"),
          HasSubstr("d.svg:3:2: warning: not carried over: hidden elements"),
          HasSubstr("d.svg:4:2: warning: not carried over: shapes that nothing fills or strokes"),
          HasSubstr("d.svg:1:97: warning: not carried over: style sheets")));
  EXPECT_THAT(read_drawing(page("")).warnings,
              ElementsAre("d.svg:1:1: warning: a drawing without walls"));
}

TEST(Svg, ErrorsHaveAPlace) {
  const auto error = [](const std::string& svg) { return error_of([&] { read_drawing(svg); }); };
  EXPECT_EQ(error(page("\n<path d=\"M0 0L5\"/>")),
            "d.svg:2:2: <path>: d: character 7: ends where a number is expected");
  EXPECT_EQ(error(page("<path d=\"L5 5\"/>")),
            "d.svg:1:97: <path>: d: character 2: expected M or m, where the path begins");
  EXPECT_THAT(error(page("<path d=\"M0 0 X\"/>")), HasSubstr("no command of a path: 'X'"));
  EXPECT_THAT(error(page("<path d=\"M0 0 A 1 1 0 2 0 5 5\"/>")), HasSubstr("a flag of an arc"));
  EXPECT_THAT(error(page("<rect width=\"5quux\" height=\"2\"/>")),
              HasSubstr("width is '5quux': expected a unit such as mm, or none"));
  EXPECT_THAT(error(page("<rect width=\"wide\"/>")), HasSubstr("expected a length"));
  EXPECT_THAT(error(page("<rect width=\"-5\" height=\"2\"/>")), HasSubstr("a size below 0"));
  EXPECT_THAT(error(page("<g transform=\"turn(3)\"/>")), HasSubstr("unknown transform"));
  EXPECT_THAT(error(page("<g transform=\"rotate(3 4)\"/>")), HasSubstr("rotate expects 1 or 3"));
  EXPECT_THAT(error(page("<polygon points=\"1 2 3\"/>")), HasSubstr("pairs of numbers"));
  EXPECT_THAT(error(page("<line x1=\"1e8mm\" x2=\"5\" stroke=\"red\"/>")), HasSubstr("10 km"));
  EXPECT_THAT(error(page("<line x2=\"5\" stroke=\"red\" stroke-width=\"1e9\"/>")),
              HasSubstr("a stroke wider than 100 m"));
  EXPECT_THAT(error("<svg viewBox=\"0 0 10\"/>"), HasSubstr("viewBox: expected 4 numbers"));
  EXPECT_THAT(error("<html/>"), HasSubstr("d.svg:1:2: no <svg>"));
  EXPECT_THAT(error("<svg>\n<g></svg>"), HasSubstr("not well-formed XML"));
  EXPECT_THAT(error("<svg/>"), HasSubstr("no page and no walls"));
  std::string deep;
  for (int i = 0; i < 300; ++i) deep += "<g>";
  for (int i = 0; i < 300; ++i) deep += "</g>";
  EXPECT_THAT(error(page(deep)), HasSubstr("nested more than 200 deep"));
}

TEST(Svg, OurOwnIsReadAgain) {
  Scenario scenario;
  scenario.world.width = 2;
  scenario.world.height = 1;
  scenario.world.corner = {-0.5, -3};
  world::Wall wall{{0, -2.5}, {1, -2.25}};
  wall.thickness = 0.02;
  wall.colour = {0, 0, 0};
  scenario.world.walls = {wall, wall};
  scenario.world.walls[1].b = {0.5, -2.1};
  scenario.world.walls[1].colour = world::Wall::kDefaultColour;
  scenario.world.starts = {{0, {0.25, -2.75, 1.5}}};
  const WrittenWorld written = write_svg(scenario, "a<b");
  EXPECT_THAT(written.losses, ElementsAre());
  const auto read = read_drawing(written.text);
  EXPECT_THAT(read.warnings, ElementsAre());
  EXPECT_NEAR(read.model.corner.y, -3, 1e-9);
  EXPECT_NEAR(read.model.width, 2, 1e-9);
  ASSERT_EQ(read.model.walls.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(norm(read.model.walls[i].a - scenario.world.walls[i].a), 0, 1e-9);
    EXPECT_NEAR(norm(read.model.walls[i].b - scenario.world.walls[i].b), 0, 1e-9);
    EXPECT_NEAR(read.model.walls[i].thickness, 0.02, 1e-9);
  }
  EXPECT_EQ(read.model.walls[0].colour, (Rgb{1, 1, 1})) << "black means that no colour is said";
  EXPECT_EQ(read.model.walls[1].colour, world::Wall::kDefaultColour);
  ASSERT_EQ(read.model.starts.size(), 1U);
  EXPECT_NEAR(read.model.starts[0].pose.theta, 1.5, 1e-9);
  EXPECT_NEAR(read.model.starts[0].pose.y, -2.75, 1e-9);
}

}  // namespace
}  // namespace eyebridge::files
