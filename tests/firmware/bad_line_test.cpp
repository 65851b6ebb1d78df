// The real client and the real firmware over a line that damages what it carries, in virtual time.
#include <gmock/gmock.h>

#include "../bridges/client/kept_log.hpp"
#include "board_stream.hpp"
#include "eyebridge/bridges/client/io7_client.hpp"
#include "eyebridge/bridges/faulty_stream.hpp"
#include "eyebridge/bridges/io7/request.hpp"

namespace eyebridge::firmware {
namespace {

using namespace std::chrono_literals;
using bridges::FaultPlan;
using bridges::Io7Client;
using bridges::Io7Settings;
using bridges::io7::ReplyForm;

struct LineDialect {
  const char* name;
  bool binary, verbose, prompt;
};
void PrintTo(const LineDialect& dialect, std::ostream* out) { *out << dialect.name; }

class BadLine : public ::testing::TestWithParam<LineDialect> {
 protected:
  BadLine() {
    board.board.pins.analog[0] = 1515;
    for (int i = 0; i < EB_PSDS; ++i) {
      board.board.pins.psd[i] = static_cast<std::uint16_t>(100 + i);
    }
  }
  /// A client in front of the board. Damage may spoil a probe, or keep it from making the replies
  /// raw: text has no fixed length, so that a lost digit cannot be noticed. Then the next one
  /// counts.
  std::unique_ptr<Io7Client> connect(const FaultPlan& plan) {
    auto client = std::make_unique<Io7Client>(
        [this, plan]() -> Result<std::unique_ptr<bridges::ByteStream>> {
          return std::make_unique<bridges::FaultyStream>(
              std::make_unique<BoardStream>(board, clock, asleep_until), plan, clock);
        },
        clock, log, settings);
    for (int i = 0; i < 50; ++i) {
      if (client->connect() && client->report()->profile.reply_form == ReplyForm::Raw) break;
    }
    return client;
  }

  bridges::testing::FakeClock clock;
  bridges::testing::KeptLog log;
  Io7Settings settings;
  Time asleep_until{0};
  BoardUnderTest board{config_with([](eb_config& config) {
    config.io7.binary = GetParam().binary;
    config.io7.verbose = GetParam().verbose;
    if (GetParam().prompt) config.io7.prompt[0] = '>';
  })};
};

TEST_P(BadLine, AnAnswerThatIsLateOnceIsNoLossOfTheBoard) {
  const auto client = connect({});
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(client->exchange(bridges::io7::psd(1)));
  for (const Time late : {5ms, 12ms, 15ms, 19ms, 25ms, 31ms, 45ms, 70ms, 150ms}) {
    asleep_until = clock.now() + late;
    const auto reading = client->exchange(bridges::io7::psd(2));
    ASSERT_TRUE(reading) << late.count() << " ns: " << reading.error().what;
    EXPECT_EQ(reading->values[0], 101);
  }
  EXPECT_EQ(client->statistics().losses, 0U);
}

TEST_P(BadLine, LostBytesAreErrorsOrRepetitionsButNeverWrongReadings) {
  FaultPlan plan;
  plan.incoming.drop = plan.outgoing.drop = 0.01;
  for (plan.seed = 1; plan.seed <= 3; ++plan.seed) {
    const auto damaged = connect(plan);
    int answered = 0;
    for (int i = 0; i < 1000; ++i) {
      const int sensor = 1 + i % EB_PSDS;
      const auto reading = damaged->exchange(bridges::io7::psd(sensor));
      // A board that is found again may speak text, as above.
      if (!reading && reading.error().code == Errc::Disconnected) break;
      if (!reading) continue;
      ++answered;
      ASSERT_EQ(reading->values[0], 99 + sensor) << "request " << i << ", seed " << plan.seed;
    }
    EXPECT_GT(answered, 900) << "seed " << plan.seed;
    EXPECT_GT(damaged->statistics().retries, 10U);
  }
}

INSTANTIATE_TEST_SUITE_P(Dialects, BadLine,
                         ::testing::Values(LineDialect{"Text", false, true, true},
                                           LineDialect{"Raw", false, false, false},
                                           LineDialect{"Binary", true, false, false},
                                           LineDialect{"BinaryText", true, true, false}),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace eyebridge::firmware
