// What the person sees: a picture and a line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/camera/png.hpp"
#include "hand/display.hpp"
#include "rigs.hpp"
#include "run_program.hpp"

namespace eyebridge::hal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Kind = Instruction::Kind;

Instruction forward(double metres, int command = 1) {
  return {Kind::Goal, metres, 0.0, {0.2, 0.0}, "", command};
}
Instruction lost() { return {Kind::Lost, 0.0, 0.0, {}, "no marker", 1}; }
constexpr Time at(int ms) { return std::chrono::milliseconds(ms); }

struct Lines {
  std::vector<std::string> all;
  HandTerminal terminal(bool is_live) {
    return {[this](const std::string& text) { all.push_back(text); }, is_live};
  }
};

TEST(HandDisplay, AFileGetsALineForEachCommandAndWhenTheRobotIsLostAndFound) {
  Lines lines;
  NullLog log;
  HandDisplay display({}, lines.terminal(false), log);
  display.show(at(0), forward(0.3));
  display.show(at(1), forward(0.29));
  display.show(at(500), forward(0.2));
  display.show(at(501), lost());
  display.show(at(502), lost());
  display.show(at(503), forward(0.2));
  display.show(at(504), forward(0.2, 2));
  EXPECT_THAT(lines.all, ElementsAre("hand: forward 0.30 m at 0.20 m/s\n",
                                     "hand: lost: show me a marker (no marker)\n",
                                     "hand: forward 0.20 m at 0.20 m/s\n",
                                     "hand: forward 0.20 m at 0.20 m/s\n"));
}

TEST(HandDisplay, ATerminalGetsOneLineThatIsWrittenOverFiveTimesASecondAtMost) {
  Lines lines;
  NullLog log;
  HandDisplay display({}, lines.terminal(true), log);
  for (int ms = 0; ms < 990; ms += 10) display.show(at(ms), forward(1.0 - 0.001 * ms));
  ASSERT_THAT(lines.all, SizeIs(5));
  EXPECT_EQ(lines.all[1].front(), '\r');
  EXPECT_THAT(lines.all[1], HasSubstr("forward 0.80 m"));
  display.finish();
  ASSERT_THAT(lines.all, SizeIs(7));
  EXPECT_THAT(lines.all[5], HasSubstr("forward 0.02 m")) << "the last that was to be shown";
  EXPECT_EQ(lines.all[6], "\n");
  display.show(at(5000), forward(0.5));
  display.finish();
  EXPECT_THAT(lines.all, SizeIs(7));
}

TEST(HandDisplay, ThePictureIsWrittenWholeAndFiveTimesASecondAtMost) {
  const testing::ScratchFolder folder;
  const std::filesystem::path out = std::filesystem::path(folder.path()) / "out";
  Lines lines;
  KeepingLog log;
  HandDisplay display(out, lines.terminal(false), log);
  display.show(at(0), forward(0.3));
  const camera::Frame first = camera::read_png(out / "hand.png");
  EXPECT_EQ(first.width, 640);
  display.show(at(199), forward(0.2));
  EXPECT_EQ(camera::read_png(out / "hand.png").bytes, first.bytes);
  display.show(at(200), forward(0.2));
  EXPECT_NE(camera::read_png(out / "hand.png").bytes, first.bytes);
  EXPECT_FALSE(std::filesystem::exists(out / "hand.png.part"));
  EXPECT_THAT(log.messages(Severity::Warning), IsEmpty());
}

TEST(HandDisplay, APictureThatCannotBeWrittenIsSaidOnce) {
  const testing::ScratchFolder folder;
  const std::string file = folder.write("out", "a file");
  Lines lines;
  KeepingLog log;
  HandDisplay display(file, lines.terminal(false), log);
  display.show(at(0), forward(0.3));
  display.show(at(300), forward(0.2));
  ASSERT_THAT(log.messages(Severity::Warning), SizeIs(1));
  EXPECT_THAT(log.messages(Severity::Warning)[0], HasSubstr("out"));
}

}  // namespace
}  // namespace eyebridge::hal
