#include "eyebridge/bridges/dbc/read_dbc.hpp"

#include <fstream>
#include <iterator>
#include <vector>

#include <gmock/gmock.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/bridges/dbc/signal.hpp"

namespace eyebridge::bridges::dbc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string content(const std::string& path) {
  std::ifstream in(std::string(EYEBRIDGE_SOURCE_DIR) + "/" + path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Database features() { return read_dbc(content("tests/data/dbc/features.dbc"), "features.dbc"); }

/// The message of the error that reading `text` is.
std::string mistake(const std::string& text) {
  try {
    read_dbc(text, "x.dbc");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(ReadDbc, FindsNodesMessagesAndSignals) {
  const Database database = features();
  EXPECT_EQ(database.version, "features 1");
  EXPECT_THAT(database.nodes, ElementsAre("Robot", "Host", "Arm"));
  ASSERT_EQ(database.messages.size(), 8u);
  const Message& intel = database.messages[0];
  EXPECT_EQ(intel.name, "Intel");
  EXPECT_EQ(intel.id, 100u);
  EXPECT_FALSE(intel.extended);
  EXPECT_EQ(intel.length, 8);
  EXPECT_EQ(intel.sender, "Robot");
  EXPECT_EQ(intel.comment, "Little end first");
  const Signal& across = *intel.find("Across");
  EXPECT_EQ(across.start, 4);
  EXPECT_EQ(across.length, 12);
  EXPECT_EQ(across.kind, NumberKind::Signed);
  EXPECT_EQ(across.factor, 0.5);
  EXPECT_EQ(across.offset, -10);
  EXPECT_EQ(across.unit, "mm");
  EXPECT_THAT(across.receivers, ElementsAre("Host", "Arm"));
  EXPECT_EQ(database.find("Motorola")->find("First")->order, ByteOrder::Motorola);
  EXPECT_EQ(database.find("Motorola")->find("First")->comment,
            "Speed of the first wheel; forward is positive");
}

TEST(ReadDbc, FindsFormatsPeriodsAndNames) {
  const Database database = features();
  const Message& extended = *database.find("Extended");
  EXPECT_TRUE(extended.extended);
  EXPECT_EQ(extended.id, 2566844672u & 0x1FFFFFFFu);
  EXPECT_FALSE(extended.fd);
  EXPECT_TRUE(database.find("ExtendedMotorola")->fd);
  EXPECT_TRUE(database.find("Floats")->fd);
  EXPECT_EQ(database.find("Intel")->period_ms, 20);
  EXPECT_EQ(database.find("Intel")->start_delay_ms, 5);
  EXPECT_EQ(database.find("Motorola")->period_ms, std::nullopt);  // 0: none
  EXPECT_EQ(database.find("Simple")->period_ms, 100);             // the default
  EXPECT_NE(database.find("Long")->find("AtTheVeryEnd"), nullptr);
  EXPECT_EQ(database.find("Intel")->find("Flag")->values.front().name, "Set");
  EXPECT_EQ(database.find("Motorola")->find("Small")->values.back().name, "Off");
  EXPECT_EQ(database.find("Intel")->find("Across")->values.front().value, -20);
  EXPECT_EQ(database.find("Floats")->find("Single")->kind, NumberKind::Float32);
  EXPECT_EQ(database.find("Floats")->find("Double")->kind, NumberKind::Float64);
}

TEST(ReadDbc, MultiplexersSelectTheirSignals) {
  const Database database = features();
  const auto present = [&](const char* name, std::vector<std::uint8_t> data) {
    const Message& message = *database.find(name);
    data.resize(8);
    std::string names;
    for (std::size_t i = 0; i < message.signals.size(); ++i) {
      if (is_present(message, i, data)) names += message.signals[i].name + " ";
    }
    return names;
  };
  EXPECT_EQ(present("Simple", {0}), "Which Left Always ");
  EXPECT_EQ(present("Simple", {2}), "Which Front Always ");
  EXPECT_EQ(present("Simple", {9}), "Which Always ");
  EXPECT_EQ(present("Nested", {0x01}), "Outer Inner Beside ");
  EXPECT_EQ(present("Nested", {0x31}), "Outer Inner Deep Beside ");
  EXPECT_EQ(present("Nested", {0x03}), "Outer Several ");
  EXPECT_EQ(present("Nested", {0x07}), "Outer Several ");
  EXPECT_EQ(present("Nested", {0x05}), "Outer ");
}

TEST(ReadDbc, OurOwnFileIsRead) {
  for (const char* name : {"eyebridge.dbc", "eyebridge_fd.dbc"}) {
    const Database database = read_dbc(content(std::string("bridges/protocol/") + name), name);
    EXPECT_EQ(database.messages.size(), 367u);
    EXPECT_NE(database.find(name[9] == '.' ? "R3_S_Pose" : "R14_C_VWSpeed"), nullptr);
  }
}

TEST(ReadDbc, WindowsTextAndLineEndsAreRead) {
  const Database database = read_dbc(
      "VERSION \"\"\r\nBU_: A\r\nBO_ 1 M: 8 A\r\n SG_ T : 0|8@1- (1,0) [0|0] \"\xB0"
      "C\" A\r\n SG_ E : 8|8@1+ (1,0) [0|0] \"\x80\" A\r\n",
      "x.dbc");
  EXPECT_EQ(database.messages[0].signals[0].unit,
            "\xC2\xB0"
            "C");
  EXPECT_EQ(database.messages[0].signals[1].unit, "\xE2\x82\xAC");
  EXPECT_THAT(database.messages[0].signals[0].receivers, ElementsAre("A"));
}

TEST(ReadDbc, OddFilesAreRead) {
  EXPECT_THAT(read_dbc("", "x.dbc").messages, IsEmpty());
  EXPECT_THAT(read_dbc("\xEF\xBB\xBFVERSION \"1\"", "x.dbc").version, "1");
  const Database database = read_dbc(
      "// a remark\n"
      "BO_ 8192 Odd : 2 XXX\n"
      "  SG_ A:7|8@0+(1.0E-05,+1) [ -1.7E+400 | 1e400 ] \"\"\n"
      "  SG_ Beyond : 8|16@1+ (1,0) [0|0] \"\" XXX\n"
      "  SG_ Text : 0|200@1+ (1,0) [0|0] \"\" XXX\n"
      "VAL_ 8192 A 0 \"no semicolon\"\n"
      "VAL_ 99 Nobody 0 \"x\" ;\n"
      "CM_ SG_ 99 Nobody \"x\";\n"
      "VAL_ Variable 0 \"x\" ;\n",
      "x.dbc");
  const Message& odd = database.messages.at(0);
  EXPECT_TRUE(odd.extended);  // there is no other way to send it
  ASSERT_EQ(odd.signals.size(), 2u);
  EXPECT_EQ(odd.signals[0].factor, 1e-5);
  EXPECT_EQ(odd.signals[0].values.size(), 1u);
  const std::vector<std::uint8_t> data(2);
  EXPECT_FALSE(is_present(odd, 1, data));
}

TEST(ReadDbc, NamesThatAreThereTwiceAreNotFound) {
  const Database database = read_dbc(
      "BO_ 1 M: 8 A\n SG_ S : 0|8@1+ (1,0) [0|0] \"\" A\n SG_ S : 8|8@1+ (1,0) [0|0] \"\" A\n"
      "BO_ 2 M: 8 A\n",
      "x.dbc");
  EXPECT_EQ(database.find("M"), nullptr);
  EXPECT_EQ(database.messages[0].find("S"), nullptr);
}

TEST(ReadDbc, MistakesSayWhere) {
  const std::string message = "BO_ 1 M: 8 A\n";
  EXPECT_EQ(mistake(message + " SG_ S : 0|8@2+ (1,0) [0|0] \"\" A"),
            "x.dbc:2:14: found '2+', expected 0 (Motorola) or 1 (Intel)");
  EXPECT_EQ(mistake("BO_ x M: 8 A"),
            "x.dbc:1:5: found 'x', expected an identifier, 0 … 4294967295");
  EXPECT_EQ(mistake("BO_ 1 M 8 A"), "x.dbc:1:9: found '8', expected ':'");
  EXPECT_EQ(mistake("BO_ 1 M:"),
            "x.dbc:1:9: found the end of the file, expected a length in bytes");
  EXPECT_EQ(mistake("BO_ 1073741824 M: 8 A"),
            "x.dbc:1:5: found the identifier 1073741824, expected 11 bits, or 29 bits and bit 31");
  EXPECT_EQ(mistake(" SG_ S : 0|8@1+ (1,0) [0|0] \"\" A"),
            "x.dbc:1:6: found a signal, expected its message before it: BO_");
  EXPECT_EQ(mistake(message + " SG_ S : 0|0@1+ (1,0) [0|0] \"\" A"),
            "x.dbc:2:12: found a signal of 0 bits, expected 1 or more");
  EXPECT_EQ(mistake(message + " SG_ S x : 0|8@1+ (1,0) [0|0] \"\" A"),
            "x.dbc:2:8: found 'x', expected ':', M, or m and a number");
  EXPECT_EQ(mistake(message + " SG_ S m1 : 0|8@1+ (1,0) [0|0] \"\" A"),
            "x.dbc:2: S is selected by a multiplexer, expected one (M) in M");
  EXPECT_EQ(mistake(message + " SG_ S : 0|8@1+ (1;0) [0|0] \"\" A"),
            "x.dbc:2:19: found ';', expected ','");
  EXPECT_EQ(mistake("CM_ \"without an end\n\n"),
            "x.dbc:1:5: found a text without an end, expected another '\"'");
  EXPECT_EQ(mistake(message + " SG_ S : 0|8@1+ (1,0) [0|0] \"\" A\nSIG_VALTYPE_ 1 S : 1;"),
            "x.dbc:3:20: found a float of 8 bits, expected 32");
}

TEST(ReadDbc, MultiplexersInACircleAreRefused) {
  const std::string text =
      "BO_ 1 M: 8 A\n"
      " SG_ A m0M : 0|8@1+ (1,0) [0|0] \"\" A\n SG_ B m0M : 8|8@1+ (1,0) [0|0] \"\" A\n"
      "SG_MUL_VAL_ 1 A B 0-0;\nSG_MUL_VAL_ 1 B A 0-0;\n";
  EXPECT_EQ(mistake(text), "x.dbc:2: A is selected in a circle, expected an end of it");
}

}  // namespace
}  // namespace eyebridge::bridges::dbc
