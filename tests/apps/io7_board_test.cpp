#include "probe/io7_board.hpp"

#include <memory>

#include <gmock/gmock.h>

#include "../bridges/client/scripted_line.hpp"
#include "../bridges/protocol/fake_board.hpp"
#include "eyebridge/base/config_error.hpp"
#include "fake_machine.hpp"
#include "probe/target.hpp"

namespace eyebridge::apps {
namespace {

using namespace std::chrono_literals;
using bridges::io7::FakeBoard;
using bridges::testing::FakeClock;
using bridges::testing::ScriptedLine;
using bridges::testing::ScriptedStream;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

/// A board on virtual time that answers within 1 ms.
class Io7BoardTest : public ::testing::Test {
 protected:
  Io7BoardTest() {
    line->on_write = [this](ScriptedLine& to, const std::string& sent) {
      const auto reply =
          board.answer({reinterpret_cast<const std::uint8_t*>(sent.data()), sent.size()});
      to.arrive({reinterpret_cast<const char*>(reply.data()), reply.size()}, 1ms);
    };
  }
  Result<Io7Board> look() {
    return look_at_io7(std::make_unique<ScriptedStream>(line), clock, 3s, counts);
  }
  std::string text(const std::string& url = "serial:/dev/ttyACM0") {
    const auto found = look();
    EXPECT_TRUE(found) << found.error().what;
    return found ? described(*found, url) : "";
  }
  std::string complaint(unsigned baud = 115200) {
    const auto found = look();
    EXPECT_FALSE(found);
    return found ? "" : why_no_board(found.error(), counts, baud);
  }

  FakeClock clock;
  std::shared_ptr<ScriptedLine> line = std::make_shared<ScriptedLine>(clock);
  FakeBoard board;
  LineCounts counts;
};

TEST_F(Io7BoardTest, ABoardIsDescribedInPlainWords) {
  EXPECT_THAT(
      text(),
      AllOf(HasSubstr("an EyeBot I/O board (IO7), version 1.04\n"),
            ContainsRegex("supply +7.40 V\n"), ContainsRegex("prompt +'>'\n"),
            ContainsRegex("requests +lines of text that end in CR\n"),
            ContainsRegex("replies +text \\(verbose\\) until O 0 was sent, raw bytes now\n"),
            HasSubstr("the supply 02 E4 is 7.40 V, the other way round it would be 583.70 V"),
            ContainsRegex("letters +h O m p v V a\n"), ContainsRegex("missing +M d s S e "),
            ContainsRegex("never sent +E"), ContainsRegex("v answered +20 of 20 times")));
}

TEST_F(Io7BoardTest, WhatToExpectOfTheLineIsTold) {
  EXPECT_THAT(text(), Not(HasSubstr("to expect"))) << "no v-omega by the host";
  board.list += "M speed\r\ne encoder\r\n";
  EXPECT_THAT(text(), ContainsRegex("to expect +about [1-9] mm off after 500 mm, [0-9.]+ degrees "
                                    "after a turn of 90; at most 600 mm/s\n"));
}

TEST_F(Io7BoardTest, NoLetterThatMovesAnythingIsSent) {
  board.list += "x speed\r\ny straight\r\nM motor\r\nQ pose\r\n";
  ASSERT_TRUE(look());
  EXPECT_EQ(board.asked.find_first_of("EmMsSdocxyYCQ"), std::string::npos) << board.asked;
}

TEST_F(Io7BoardTest, WhatPassedIsCounted) {
  const auto found = look();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->line.sent, line->sent.size());
  EXPECT_GT(found->line.received, 100u) << "the list alone is that long";
  EXPECT_GE(found->line.writes, 26u) << "six for the probe, twenty versions";
  EXPECT_EQ(found->report.repeats, 0);
  EXPECT_EQ(found->trips.median, 1ms);
  EXPECT_EQ(found->attempts, 1);
}

TEST_F(Io7BoardTest, AnAnswerThatGetsLostIsARepeatedQuestion) {
  const auto answer = line->on_write;
  bool lost = false;
  line->on_write = [&](ScriptedLine& to, const std::string& sent) {
    if (sent == "V\r" && !std::exchange(lost, true)) return;
    answer(to, sent);
  };
  const auto found = look();
  ASSERT_TRUE(found) << found.error().what;
  EXPECT_EQ(found->report.repeats, 1);
}

TEST_F(Io7BoardTest, LostVersionsAreCountedAndDoNotHoldItUp) {
  const auto answer = line->on_write;
  int asked = 0;
  line->on_write = [&](ScriptedLine& to, const std::string& sent) {
    if (sent == "v\r" && ++asked > 13) return;  // three of them are the probe's
    answer(to, sent);
  };
  const auto found = look();
  ASSERT_TRUE(found) << found.error().what;
  EXPECT_EQ(found->trips.answered, 10);
  EXPECT_THAT(described(*found, "serial:x"), HasSubstr("10 of 20 times"));
}

TEST_F(Io7BoardTest, AnEvenVoltageLeavesTheByteOrderToAnotherReading) {
  board.battery_cv = 0x0303;
  EXPECT_THAT(text(), HasSubstr("the reading 0A F0 of 'a' is 2800, the other way round 61450"));
}

TEST_F(Io7BoardTest, AByteOrderThatNothingProvesIsCalledAssumed) {
  board.battery_cv = 0x0303;
  board.analog_0 = 0x0202;
  EXPECT_THAT(text(), HasSubstr("most significant byte first (assumed"));
}

TEST_F(Io7BoardTest, LeastSignificantFirstIsSaid) {
  board.msb_first = false;
  EXPECT_THAT(text(), HasSubstr("least significant byte first: the supply E4 02 is 7.40 V"));
}

TEST_F(Io7BoardTest, ABoardThatStaysVerboseIsSaidToBe) {
  board.quietens = false;
  EXPECT_THAT(text(), AllOf(HasSubstr("text, whatever O 0 says"), HasSubstr("of no matter")));
}

TEST_F(Io7BoardTest, VOmegaLettersAreOfferedWithTheirProfile) {
  EXPECT_THAT(text(), AllOf(Not(HasSubstr("io7vw")), HasSubstr("lists no M or no e")));
  board.list += "x speed\r\nM motor\r\ne encoder\r\n";
  EXPECT_THAT(text("tcp:robot:4711?hdt=a"),
              AllOf(HasSubstr("by the host, over M and e"), HasSubstr("of its own: x"),
                    HasSubstr("--hal 'tcp:robot:4711?hdt=a' PROGRAM"),
                    HasSubstr("'tcp:robot:4711?hdt=a&profile=io7vw'")));
}

TEST_F(Io7BoardTest, ASilentLineIsCalledSilentWithItsBitRate) {
  board.silent = true;
  EXPECT_THAT(complaint(9600),
              AllOf(HasSubstr("nothing answers"), HasSubstr("9600 bits per second")));
  EXPECT_THAT(why_no_board({Errc::Timeout, "x"}, {}, 0), Not(HasSubstr("bits per second")));
}

TEST_F(Io7BoardTest, ADeviceThatSpeaksSomethingElseIsQuoted) {
  line->on_write = [](ScriptedLine& to, const std::string& sent) {
    to.arrive(sent + "\nERROR\r\n", 1ms);
  };
  EXPECT_THAT(complaint(), AllOf(HasSubstr("not as an EyeBot I/O board does"), HasSubstr("ERROR")));
}

TEST_F(Io7BoardTest, BytesThatAreNoTextAreAHintAtTheBitRate) {
  line->on_write = [](ScriptedLine& to, const std::string&) {
    to.arrive("\xF8\x80\x01\xFE\xC0\x9C\xF0\xE1", 1ms);
  };
  EXPECT_THAT(complaint(), AllOf(HasSubstr("no text"), HasSubstr("baud=")));
}

TEST_F(Io7BoardTest, ALineThatIsUnpluggedIsALoss) {
  line->on_write = [](ScriptedLine& to, const std::string&) { to.gone = true; };
  EXPECT_EQ(complaint(), "script: unplugged");
}

TEST(WhyNotOpened, AMissingDeviceIsToldWithThoseThatAreThere) {
  const eyebridge::testing::FakeMachine machine;
  const Error error{Errc::Disconnected, "/dev/ttyACM7: ?"};
  EXPECT_EQ(why_not_opened("/dev/ttyACM7", error, machine.root()),
            "/dev/ttyACM7: no such device; expected a board that is plugged in (none is)");
  machine.add_acm();
  EXPECT_EQ(why_not_opened("/dev/ttyACM7", error, machine.root()),
            "/dev/ttyACM7: no such device; expected one of /dev/ttyACM0");
}

TEST(WhyNotOpened, WhoHoldsTheDeviceIsNamedWhateverItWasCalled) {
  const eyebridge::testing::FakeMachine machine;
  machine.add_acm();
  const Error error{Errc::Disconnected, "it: in use by another program"};
  EXPECT_EQ(why_not_opened("/dev/ttyACM0", error, machine.root()), error.what);
  machine.add_process(812, "minicom", "/dev/ttyACM0");
  const std::string expected = error.what + ": it is open in minicom (process 812)";
  EXPECT_EQ(why_not_opened("/dev/ttyACM0", error, machine.root()), expected);
  EXPECT_EQ(why_not_opened("/dev/serial/by-id/usb-UWA_Interface_Board-if00", error, machine.root()),
            expected);
}

TEST(WhyNotOpened, ModemManagerIsToldToLetGoAndHowToKeepItAway) {
  const eyebridge::testing::FakeMachine machine;
  machine.add_acm();
  machine.add_process(400, "ModemManager", "/dev/ttyACM0");
  EXPECT_THAT(why_not_opened("/dev/ttyACM0", {Errc::Disconnected, "it: in use"}, machine.root()),
              AllOf(HasSubstr("ModemManager (process 400), which tries new ports for some seconds"),
                    HasSubstr("eyebridge doctor --udev")));
}

TEST(ProbeTarget, IsAPathOrAUrlOrAnInterface) {
  EXPECT_EQ(probe_target("/dev/serial/by-path/pci-0:1.0").line.rest,
            "/dev/serial/by-path/pci-0:1.0");
  EXPECT_EQ(probe_target("./eyebot.tty").url, "serial:./eyebot.tty");
  EXPECT_EQ(probe_target("can0").url, "can:can0");
  EXPECT_EQ(probe_target("tcp:robot:4711").line.scheme, "tcp");
}

TEST(ProbeTarget, OptionsOfABackendAreNoneOfItsLines) {
  const ProbeTarget target = probe_target("serial:/dev/ttyUSB0?profile=io7&hdt=a.txt&baud=9600");
  EXPECT_EQ(target.line.options.size(), 1u);
  EXPECT_EQ(target.url, "serial:/dev/ttyUSB0?profile=io7&hdt=a.txt&baud=9600");
}

TEST(ProbeTarget, ARobotsNumberIsCheckedBeforeAnythingIsOpened) {
  EXPECT_EQ(probe_target("can:can0?node=14&fd=1").node, 14);
  EXPECT_EQ(probe_target("can:can0").node, 0);
  for (const char* node : {"0", "15", "99", "x", ""}) {
    EXPECT_THROW(probe_target(std::string("can:can0?node=") + node), ConfigError) << node;
  }
}

TEST(ProbeTarget, OtherBackendsCannotBeProbed) {
  EXPECT_THROW(probe_target("sim:"), ConfigError);
  EXPECT_THROW(probe_target("replay:a.ebrec"), ConfigError);
}

}  // namespace
}  // namespace eyebridge::apps
