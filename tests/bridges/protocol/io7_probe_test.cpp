#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "eyebridge/bridges/io7/probe.hpp"
#include "fake_board.hpp"

namespace eyebridge::bridges::io7 {
namespace {

Result<ProbeReport> probe(FakeBoard& board) {
  Probe probe;
  for (int steps = 0; steps < 40 && !probe.done(); ++steps) {
    EXPECT_FALSE(probe.step().send.empty());
    EXPECT_FALSE(probe.step().expect.empty());
    probe.answer(board.answer(probe.step().send));
  }
  EXPECT_TRUE(probe.done());
  EXPECT_EQ(board.asked.find('E'), std::string::npos) << "the demo was started";
  EXPECT_EQ(board.asked.find('m'), std::string::npos) << "a motor was driven";
  return probe.report();
}

TEST(Io7Probe, AVerboseBoardWithPromptIsMadeQuiet) {
  FakeBoard board;
  const auto report = probe(board);
  ASSERT_TRUE(report) << report.error().what;
  EXPECT_EQ(report->profile.prompt.view(), ">");
  EXPECT_EQ(report->profile.reply_form, ReplyForm::Raw);
  EXPECT_EQ(report->profile.request_form, RequestForm::Ascii);
  EXPECT_TRUE(report->request_form_proven);
  EXPECT_EQ(report->profile.byte_order, ByteOrder::MsbFirst);
  EXPECT_TRUE(report->byte_order_proven);
  EXPECT_EQ(report->version, "1.04");
  EXPECT_EQ(report->battery_cv, 740);
  EXPECT_EQ(report->list, board.list);
  EXPECT_TRUE(report->profile.letters.has('p'));
  EXPECT_FALSE(report->profile.letters.has('d'));
  EXPECT_FALSE(board.verbose);
  EXPECT_EQ(board.asked, "hhvvOvVa");
  EXPECT_TRUE(report->was_verbose);
  EXPECT_EQ(report->byte_order_witness, 'V');
  EXPECT_EQ(report->witness_bytes, (std::array<std::uint8_t, 2>{0x02, 0xE4}));
  EXPECT_EQ(report->repeats, 0);
}

TEST(Io7Probe, ABoardThatStaysVerboseIsSpokenToInText) {
  FakeBoard board;
  board.quietens = false;
  const auto report = probe(board);
  ASSERT_TRUE(report) << report.error().what;
  EXPECT_EQ(report->profile.reply_form, ReplyForm::Text);
  EXPECT_EQ(report->battery_cv, 740);
  EXPECT_EQ(report->version, "1.04");
  EXPECT_FALSE(report->byte_order_proven);
}

TEST(Io7Probe, ALeastSignificantByteFirstIsSeenFromTheVoltage) {
  FakeBoard board;
  board.msb_first = false;
  const auto report = probe(board);
  ASSERT_TRUE(report) << report.error().what;
  EXPECT_EQ(report->profile.byte_order, ByteOrder::LsbFirst);
  EXPECT_EQ(report->battery_cv, 740);
}

TEST(Io7Probe, AnAmbiguousVoltageIsDecidedByTheWitness) {
  FakeBoard board;
  board.battery_cv = 0x0404;
  board.msb_first = false;
  board.analog_0 = 0x0A20;
  const auto report = probe(board);
  ASSERT_TRUE(report) << report.error().what;
  EXPECT_TRUE(report->byte_order_proven);
  EXPECT_EQ(report->profile.byte_order, ByteOrder::LsbFirst);
}

TEST(Io7Probe, AnOrderThatNothingDecidesIsNotCalledProven) {
  FakeBoard board;
  board.battery_cv = 0x0404;
  board.analog_0 = 0x0808;
  const auto report = probe(board);
  ASSERT_TRUE(report) << report.error().what;
  EXPECT_FALSE(report->byte_order_proven);
  EXPECT_EQ(report->profile.byte_order, ByteOrder::MsbFirst);
}

TEST(Io7Probe, ABoardThatTakesBytesIsFound) {
  FakeBoard board;
  board.binary = true;
  board.verbose = false;
  board.prompt = "";
  const auto report = probe(board);
  ASSERT_TRUE(report) << report.error().what;
  EXPECT_EQ(report->profile.request_form, RequestForm::Binary);
  EXPECT_TRUE(report->request_form_proven);
  EXPECT_TRUE(report->profile.prompt.view().empty());
  EXPECT_EQ(report->battery_cv, 740);
}

// To it the text "a 0" is the channel 32, and an answer.
TEST(Io7Probe, ABoardThatTakesBytesAndAnyChannelIsNotTakenForOneOfText) {
  for (const bool verbose : {false, true}) {
    FakeBoard board;
    board.binary = true;
    board.loose = true;
    board.verbose = verbose;
    board.prompt = "";
    const auto report = probe(board);
    ASSERT_TRUE(report) << report.error().what;
    EXPECT_EQ(report->profile.request_form, RequestForm::Binary);
    EXPECT_TRUE(report->request_form_proven);
  }
}

// On a busy computer the answer to a line can come when bytes are tried already.
TEST(Io7Probe, ALateAnswerToALineIsNotTakenForOneToBytes) {
  FakeBoard board;
  Probe probe;
  std::vector<std::uint8_t> late;
  for (int steps = 0; steps < 40 && !probe.done(); ++steps) {
    std::vector<std::uint8_t> answer = board.answer(probe.step().send);
    if (probe.step().expect == "a reading, if requests are text") std::swap(answer, late);
    if (probe.step().expect == "a reading, if requests are bytes") {
      answer.insert(answer.begin(), late.begin(), late.end());
    }
    probe.answer(answer);
  }
  const auto report = probe.report();
  ASSERT_TRUE(report) << report.error().what;
  EXPECT_FALSE(late.empty());
  EXPECT_EQ(report->profile.request_form, RequestForm::Ascii);
  EXPECT_TRUE(report->request_form_proven);
  board.asked.clear();
  const std::string version = "v\r";
  board.answer({reinterpret_cast<const std::uint8_t*>(version.data()), version.size()});
  EXPECT_EQ(board.asked, "v") << "bytes that were tried spoil no line";
}

TEST(Io7Probe, AQuietTextBoardOnUsbPowerIsStillFound) {
  FakeBoard board;
  board.verbose = false;
  board.battery_cv = 0;
  board.analog_0 = 0;
  const auto report = probe(board);
  ASSERT_TRUE(report) << report.error().what;
  EXPECT_EQ(report->profile.request_form, RequestForm::Ascii);
  EXPECT_TRUE(report->request_form_proven);
  EXPECT_FALSE(report->byte_order_proven);
}

TEST(Io7Probe, EchoPromptAfterRawAndOtherLineEndsAreFound) {
  FakeBoard board;
  board.echo = true;
  const auto echoing = probe(board);
  ASSERT_TRUE(echoing) << echoing.error().what;
  EXPECT_TRUE(echoing->profile.echo);

  FakeBoard prompting;
  prompting.prompt = "IO7>";
  prompting.prompt_after_raw = true;
  const auto prompted = probe(prompting);
  ASSERT_TRUE(prompted) << prompted.error().what;
  EXPECT_TRUE(prompted->profile.prompt_after_raw);
  EXPECT_EQ(prompted->profile.prompt.view(), "IO7>");

  FakeBoard linefeed;
  linefeed.line_end = "\n";
  linefeed.prompt = "";
  const auto fed = probe(linefeed);
  ASSERT_TRUE(fed) << fed.error().what;
  EXPECT_EQ(fed->profile.terminator, Terminator::Lf);
}

TEST(Io7Probe, OnlyListedLettersAreSent) {
  FakeBoard board;
  board.list = "h help\r\nv version\r\np psd\r\n";
  board.verbose = false;
  const auto report = probe(board);
  ASSERT_TRUE(report) << report.error().what;
  EXPECT_EQ(board.asked, "hhvvp");
  EXPECT_FALSE(report->battery_cv.has_value());
  EXPECT_TRUE(report->request_form_proven);
}

TEST(Io7Probe, ABoardThatListsNoVersionIsRefusedAndSentNothingElse) {
  FakeBoard board;
  board.list = "h help\r\nm motor\r\n";
  const auto report = probe(board);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, Errc::Unsupported);
  EXPECT_EQ(board.asked, "hh");
}

TEST(Io7Probe, SilenceIsATimeout) {
  FakeBoard board;
  board.silent = true;
  EXPECT_EQ(probe(board).error().code, Errc::Timeout);
}

TEST(Io7Probe, AModemIsRefusedAndSentNothingButEnterAndTheListsLetter) {
  Probe probe;
  while (!probe.done()) {
    for (const std::uint8_t byte : probe.step().send) {
      EXPECT_THAT(byte, testing::AnyOf('\r', '\n', 'h'));
    }
    const std::string answer = "\r\nERROR\r\n";
    probe.answer({reinterpret_cast<const std::uint8_t*>(answer.data()), answer.size()});
  }
  EXPECT_EQ(probe.report().error().code, Errc::Corrupt);
}

TEST(Io7Probe, OneLostAnswerIsAskedForAgain) {
  for (int lost = 0; lost < 5; ++lost) {
    FakeBoard board;
    board.verbose = false;
    Probe probe;
    for (int step = 0; !probe.done(); ++step) {
      const auto answer = board.answer(probe.step().send);
      probe.answer(step == lost ? std::span<const std::uint8_t>{} : answer);
    }
    EXPECT_TRUE(probe.report()) << lost << probe.report().error().what;
  }
}

// No drive for the whole session, because one letter of the list was lost on the way.
TEST(Io7Probe, AListAndAVersionThatWereSpoiltOnTheWayAreNotBelieved) {
  for (int spoilt = 0; spoilt < 6; ++spoilt) {
    FakeBoard board;
    board.verbose = false;
    Probe probe;
    int listed = 0;
    int told = 0;
    while (!probe.done()) {
      const char asked = static_cast<char>(probe.step().send[0]);
      auto answer = board.answer(probe.step().send);
      if (asked == 'h' && listed++ == spoilt) answer.at(board.list.find("m motor")) = 'y';
      if (asked == 'v' && told++ == spoilt) answer.at(2) = 'p';
      probe.answer(answer);
    }
    const auto report = probe.report();
    ASSERT_TRUE(report) << spoilt << report.error().what;
    EXPECT_EQ(report->version, "1.04") << spoilt;
    EXPECT_TRUE(report->profile.letters.has('m')) << spoilt;
    EXPECT_FALSE(report->profile.letters.has('y')) << spoilt;
  }
}

TEST(Io7Probe, ALineThatAlwaysSpoilsSomethingOfTheListStillTellsWhatTheBoardHas) {
  FakeBoard board;
  board.verbose = false;
  Probe probe;
  const std::string letters = "OEmpV";
  std::size_t listed = 0;
  while (!probe.done()) {
    auto answer = board.answer(probe.step().send);
    if (static_cast<char>(probe.step().send[0]) == 'h') {
      const char letter = letters.at(listed++ % letters.size());
      answer.at(board.list.find(std::string(1, letter) + ' ')) = letter ^ 1;
    }
    probe.answer(answer);
  }
  const auto report = probe.report();
  ASSERT_TRUE(report) << report.error().what;
  EXPECT_EQ(report->profile.letters, LetterSet("hOEmpvVa"));
}

TEST(Io7Probe, AVersionThatIsAnotherEachTimeIsRefused) {
  FakeBoard board;
  board.verbose = false;
  Probe probe;
  char other = 'a';
  while (!probe.done()) {
    auto answer = board.answer(probe.step().send);
    if (static_cast<char>(probe.step().send[0]) == 'v') answer.at(2) = other++;
    probe.answer(answer);
  }
  EXPECT_EQ(probe.report().error().code, Errc::Corrupt);
}

TEST(Io7Probe, AnyAnswersEndItAndNeverMakeItSendWhatMoves) {
  std::mt19937 random(5);
  const std::string common = "hvVaOE \r\n>:123";
  int finished = 0;
  for (int round = 0; round < 5000; ++round) {
    FakeBoard board;
    board.binary = random() % 2 == 0;
    board.verbose = random() % 2 == 0;
    Probe probe;
    for (int step = 0; step < 60 && !probe.done(); ++step) {
      // The demo and the motor letter would be the first byte of a request.
      ASSERT_THAT(probe.step().send[0],
                  testing::AnyOf('\r', '\n', 'h', 'v', 'O', 'V', 'a', 'p', 'e', 'i'));
      auto answer = board.answer(probe.step().send);
      if (random() % 4 == 0) {
        answer.resize(random() % 20);
        for (auto& byte : answer)
          byte = static_cast<std::uint8_t>(common[random() % common.size()]);
      } else if (!answer.empty() && random() % 8 == 0) {
        answer[random() % answer.size()] = static_cast<std::uint8_t>(random() & 0xFFU);
      }
      probe.answer(answer);
    }
    ASSERT_TRUE(probe.done());
    finished += probe.report().has_value();
  }
  EXPECT_GT(finished, 100);
}

}  // namespace
}  // namespace eyebridge::bridges::io7
