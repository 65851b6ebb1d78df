#include <random>
#include <vector>

#include <gmock/gmock.h>

#include "eyebridge/bridges/io7/request.hpp"
#include "golden.hpp"

namespace eyebridge::bridges::io7 {
namespace {

using test::profile_of;

const char* const kForms[] = {"ascii-cr", "ascii-lf", "ascii-crlf", "binary-msb", "binary-lsb"};

Request lowest(const Command& command) {
  Request request{.letter = command.letter};
  for (const Field& field : command.arguments()) {
    request.arguments[request.count++] = field.letter ? IO7_PORT_INPUT : field.first;
  }
  return request;
}

TEST(Io7Request, BothEndsOfEveryRangeSurviveTheRoundTripInEveryForm) {
  for (const char* form : kForms) {
    for (const Command& command : commands()) {
      for (std::size_t i = 0; i < command.argument_count; ++i) {
        const Field& field = command.argument_fields[i];
        for (const int value : {field.first, field.last}) {
          Request request = lowest(command);
          request.arguments[i] = field.letter ? IO7_PORT_PULL_DOWN : value;
          const auto bytes = encode(request, profile_of(form));
          ASSERT_TRUE(bytes) << bytes.error().what;
          EXPECT_EQ(decode_request(bytes->view(), profile_of(form)), request) << command.letter;
        }
      }
    }
  }
}

TEST(Io7Request, OneBeyondEveryRangeIsRefusedAndNamed) {
  int refused = 0;
  for (const Command& command : commands()) {
    for (std::size_t i = 0; i < command.argument_count; ++i) {
      const Field& field = command.argument_fields[i];
      for (const int value : {field.first - 1, field.last + 1, -1000000, 1000000}) {
        Request request = lowest(command);
        request.arguments[i] = value;
        const auto bytes = encode(request, profile_of("ascii-cr"));
        ASSERT_FALSE(bytes) << command.letter << " " << field.name << " " << value;
        EXPECT_EQ(bytes.error().code, Errc::OutOfRange);
        EXPECT_THAT(bytes.error().what, testing::HasSubstr(std::string(field.name)));
        EXPECT_THAT(bytes.error().what, testing::HasSubstr(std::to_string(value)));
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(Io7Request, APortModeThatIsNoneIsRefused) {
  EXPECT_FALSE(encode(port_config(3, 'j'), profile_of("ascii-cr")));
  EXPECT_TRUE(encode(port_config(3, 'J'), profile_of("ascii-cr")));
}

TEST(Io7Request, TheNumberOfArgumentsMustFit) {
  const auto few = encode(request(IO7_MOTOR, 1), profile_of("ascii-cr"));
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().what, "IO7 motor ('m'): 1 arguments; expected 2");
  EXPECT_FALSE(encode(request(IO7_VERSION, 1), profile_of("ascii-cr")));
}

TEST(Io7Request, ALetterThatTheBoardDoesNotListIsNeverWritten) {
  Profile profile;
  profile.letters = LetterSet("hvV");
  const auto bytes = encode(motor(1, 50), profile);
  ASSERT_FALSE(bytes);
  EXPECT_EQ(bytes.error().code, Errc::Unsupported);
  EXPECT_EQ(bytes.error().what, "IO7 motor ('m') is not in this board's command list");
  EXPECT_TRUE(encode(request(IO7_VOLTAGE), profile));
}

TEST(Io7Request, TheDemoIsNeverWrittenEvenWhenListed) {
  Profile profile = profile_of("ascii-cr");
  profile.letters.insert(IO7_DEMO);
  EXPECT_FALSE(encode(request(IO7_DEMO), profile));
  EXPECT_EQ(find_command(IO7_DEMO), nullptr);
}

TEST(Io7Request, LettersThatAreGuessesWaitForTheirSwitch) {
  Profile profile = profile_of("binary-msb");
  EXPECT_TRUE(encode(request(IO7_VW_SET_SPEED, 100, 0), profile));
  profile.vw_letters = false;
  EXPECT_FALSE(encode(request(IO7_VW_SET_SPEED, 100, 0), profile));
  EXPECT_FALSE(documented_letters().has(IO7_VW_SET_SPEED));
}

TEST(Io7Request, NoRequestIsLongerThanItsBuffer) {
  for (const Command& command : commands()) {
    Request request = lowest(command);
    const auto bytes = encode(request, profile_of("ascii-crlf"));
    ASSERT_TRUE(bytes);
    EXPECT_LE(bytes->length, kMaxRequest / 2 + 8);
  }
}

TEST(Io7Request, AnyBytesAreReadAsARequestThatIsWrittenTheSameOrRefused) {
  std::mt19937 random(20261121);
  const std::string common = "hOmMdsSpevViIoca 0123456789-\r\n";
  for (const char* form : kForms) {
    const Profile profile = profile_of(form);
    int accepted = 0;
    for (int round = 0; round < 40000; ++round) {
      std::vector<std::uint8_t> bytes(random() % 8);
      for (auto& byte : bytes) {
        byte = static_cast<std::uint8_t>(
            random() % 4 == 0 ? random() & 0xFFU
                              : static_cast<std::uint8_t>(common[random() % common.size()]));
      }
      if (profile.request_form == RequestForm::Ascii && random() % 2 == 0) {
        for (const std::uint8_t byte : bytes_of(profile.terminator)) bytes.push_back(byte);
      }
      const auto request = decode_request(bytes, profile);
      if (!request) continue;
      ++accepted;
      const auto again = encode(*request, profile);
      ASSERT_TRUE(again) << again.error().what;
      ASSERT_EQ(decode_request(again->view(), profile), *request);
    }
    EXPECT_GT(accepted, 10) << form;
  }
}

}  // namespace
}  // namespace eyebridge::bridges::io7
