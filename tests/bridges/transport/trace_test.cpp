#include "eyebridge/bridges/trace.hpp"

#include <gmock/gmock.h>

#include "eyebridge/bridges/memory.hpp"
#include "fake_clock.hpp"
#include "frames.hpp"
#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

using std::chrono::microseconds;
using std::chrono::seconds;

template <class Record>
std::string complaint(std::vector<Record> (*read)(std::string_view, const std::string&),
                      std::string_view text) {
  try {
    read(text, "a.trace");
    return "no complaint";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(ByteTrace, WritesMicrosecondsDirectionAndHex) {
  EXPECT_EQ(to_line(ByteRecord{microseconds(1503210), Direction::Out, {0x6D, 0x00, 0xFF}}),
            "1503210 > 6D00FF");
  EXPECT_EQ(to_line(ByteRecord{Time(1999), Direction::In, {1}}), "1 < 01");
}

TEST(ByteTrace, IsReadAsItWasWritten) {
  const std::vector<ByteRecord> records{
      {microseconds(0), Direction::Out, noise(300, 1)},
      {microseconds(17), Direction::In, {0}},
      {seconds(9'000'000), Direction::In, noise(1, 2)},
  };
  std::string text = "# comment\n\n";
  for (const ByteRecord& record : records) text += to_line(record) + " \r\n";
  EXPECT_EQ(read_byte_trace(text, ""), records);
}

TEST(ByteTrace, SaysWhereItIsWrong) {
  const auto complain = [](std::string_view text) { return complaint(read_byte_trace, text); };
  EXPECT_EQ(complain("1 > 00\n2 = 00\n"),
            "a.trace:2:3: found '= 00', expected '<' for bytes that came in or '>' for such that "
            "went out");
  EXPECT_EQ(complain("1 > 0"), "a.trace:1:5: found '0', expected two hex digits for each byte");
  EXPECT_EQ(complain("1 >"), "a.trace:1:4: found the end of the line, expected ' '");
  EXPECT_EQ(complain("1 < 00 x"), "a.trace:1:7: found ' x', expected the end of the line");
  EXPECT_THAT(complain("x > 00"), ::testing::StartsWith("a.trace:1:1: found 'x > 00', expected a"));
  EXPECT_EQ(complain("9223372036854775 > 00"), "no complaint");
  EXPECT_THAT(complain("9223372036854776 > 00"), ::testing::HasSubstr("at most 9223372036854775"));
}

TEST(CanTrace, WritesWhatCandumpWrites) {
  CanFrame fd = standard(0x123, {0xAA, 0xBB});
  fd.extended = fd.fd = fd.bit_rate_switch = true;
  CanFrame remote = standard(0x7, {});
  remote.remote = true;
  remote.length = 4;
  const auto line = [](const CanFrame& frame, Direction direction) {
    return to_line(CanRecord{microseconds(1503210), "can0", frame, direction});
  };
  EXPECT_EQ(line(standard(0x181, {0xC0, 0x1D}), Direction::In), "(1.503210) can0 181#C01D R");
  EXPECT_EQ(line(fd, Direction::Out), "(1.503210) can0 00000123##1AABB T");
  EXPECT_EQ(line(remote, Direction::Unknown), "(1.503210) can0 007#R4");
  EXPECT_EQ(line(report(4, 0x20), Direction::In), "(1.503210) can0 20000004#0020000000000000 R");
}

TEST(CanTrace, FramesOfAllKindsAreReadAsTheyWereWritten) {
  std::vector<CanRecord> records;
  for (const CanFrame& frame : frames_of_all_kinds()) {
    const auto number = static_cast<int>(records.size());
    records.push_back({microseconds(999'999 * number), "vcan" + std::to_string(number), frame,
                       static_cast<Direction>(number % 3)});
  }
  records.push_back({seconds(1), "can0", report(0x1FF, 3), Direction::In});
  std::string text;
  for (const CanRecord& record : records) text += to_line(record) + '\n';
  EXPECT_EQ(read_can_trace(text, ""), records);
}

TEST(CanTrace, SaysWhereItIsWrong) {
  const auto complain = [](std::string_view text) { return complaint(read_can_trace, text); };
  EXPECT_EQ(complain("(1.000000) can0 181#00"), "no complaint");
  for (const auto& [text, expected] : {
           std::pair{"1.000000 can0 181#", "a.trace:1:1: found '1.000000 can0 181#', expected '('"},
           std::pair{"(1.5) can0 181#",
                     "a.trace:1:4: found '5) can0 181#', expected 6 digits of microseconds"},
           std::pair{"(1.000000) can0 1811#",
                     "a.trace:1:17: found '1811#', expected an identifier of 3 or 8 hex digits"},
           std::pair{
               "(1.000000) can0 800#",
               "a.trace:1:20: found '#', expected an identifier of at most 11 bits in 3 or 29 "
               "bits in 8 digits, before this"},
           std::pair{
               "(1.000000) can0 181#001122334455667788",
               "a.trace:1:21: found '001122334455667788', expected two hex digits for each of "
               "0 to 8 bytes"},
           std::pair{"(1.000000) can0 181#00 X",
                     "a.trace:1:24: found 'X', expected R for received, T for transmitted, or "
                     "nothing"},
           std::pair{"(1.000000) can0 181##8",
                     "a.trace:1:23: found the end of the line, expected a digit of CAN FD flags, 0 "
                     "to 7"},
           std::pair{
               "(1.000000) can0 181##0001122334455667788",
               "a.trace:1:23: found '001122334455667788', expected two hex digits for each of "
               "0 to 8, 12, 16, 20, 24, 32, 48 or 64 bytes"},
       }) {
    EXPECT_EQ(complain(text), expected);
  }
}

TEST(TracedStream, TellsWhatPassesWithItsTime) {
  FakeClock clock;
  auto [near, far] = make_memory_streams(clock);
  std::vector<std::string> lines;
  const auto traced =
      make_traced(std::move(near), clock, [&](std::string_view line) { lines.emplace_back(line); });
  ASSERT_TRUE(traced->write_all(Bytes{0x71}, kPast));
  clock.wait_until(microseconds(1500));
  ASSERT_TRUE(far->write_all(Bytes{1, 2}, kPast));
  Bytes buffer(8);
  ASSERT_TRUE(traced->read_some(buffer, kPast));
  EXPECT_FALSE(traced->read_some(buffer, kPast));
  EXPECT_THAT(lines, ::testing::ElementsAre("0 > 71", "1500 < 0102"));
}

TEST(TracedBus, TellsWhatPassesUnderAPrintableName) {
  FakeClock clock;
  MemoryCan memory(clock);
  std::vector<std::string> lines;
  const auto traced = make_traced(memory.connect("the bus\n"), clock,
                                  [&](std::string_view line) { lines.emplace_back(line); });
  const auto far = memory.connect("far");
  ASSERT_TRUE(traced->send(standard(0x201, {5}), kPast));
  ASSERT_FALSE(traced->send(impossible_frames().front(), kPast));
  clock.wait_until(seconds(2));
  ASSERT_TRUE(far->send(standard(0x181, {}), kPast));
  memory.report(report(4, 0x20));
  ASSERT_TRUE(traced->receive(kPast));
  EXPECT_FALSE(traced->receive(kPast));
  EXPECT_THAT(lines,
              ::testing::ElementsAre("(0.000000) the_bus_ 201#05 T", "(2.000000) the_bus_ 181# R"));
  EXPECT_EQ(traced->name(), "the bus\n");
}

}  // namespace
}  // namespace eyebridge::bridges::testing
