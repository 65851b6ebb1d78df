#include <algorithm>
#include <random>
#include <string>
#include <variant>

#include <gmock/gmock.h>

#include "eyebridge/bridges/can/messages.hpp"
#include "golden.hpp"

namespace eyebridge::bridges::can {
namespace {

/// Values that `spec` accepts; those of the signal at `which` are its lowest or highest.
RawValues values_of(const MessageSpec& spec, std::size_t which, bool high, std::int64_t bank = 0) {
  RawValues raw;
  for (std::size_t i = 0; i < spec.signals.size(); ++i) {
    const Signal& signal = spec.signals[i];
    if (signal.bank >= 0 && signal.bank != bank) continue;
    std::int64_t value = std::clamp<std::int64_t>(1, signal.first, signal.last);
    if (i == which) value = high ? signal.last : signal.first;
    if (spec.multiplexed && i == 0) value = bank;
    raw.push(value);
  }
  return raw;
}

/// Which of its values belongs to `signal`.
std::size_t place_of(const MessageSpec& spec, std::size_t index) {
  std::size_t place = 0;
  for (std::size_t i = 0; i < index; ++i) {
    const int bank = spec.signals[i].bank;
    if (bank < 0 || bank == spec.signals[index].bank) ++place;
  }
  return place;
}

template <class Check>
void for_each_signal(Check check) {
  for (const MessageSpec& spec : messages()) {
    for (std::size_t i = 0; i < spec.signals.size(); ++i) check(spec, i, spec.signals[i]);
  }
}

TEST(CanCodec, BothEndsOfEverySignalSurviveTheRoundTrip) {
  for_each_signal([](const MessageSpec& spec, std::size_t i, const Signal& signal) {
    if (spec.consistent != nullptr) return;  // below
    for (const bool high : {false, true}) {
      const RawValues raw = values_of(spec, i, high, std::max(0, signal.bank));
      const auto frame = encode_raw(spec, spec.last_node, raw.view());
      ASSERT_TRUE(frame) << spec.name << "." << signal.name << ": " << frame.error().what;
      EXPECT_EQ(frame->length, spec.length);
      const auto back = decode_raw(spec, *frame);
      ASSERT_TRUE(back) << back.error().what;
      EXPECT_THAT(back->view(), testing::ElementsAreArray(raw.view()))
          << spec.name << "." << signal.name;
      // The typed message must be able to hold it as well.
      const auto typed = decode_any(*frame);
      ASSERT_TRUE(typed) << typed.error().what;
      EXPECT_EQ(encode_any(*typed), *frame) << spec.name << "." << signal.name;
    }
  });
}

TEST(CanCodec, OneBeyondEverySignalIsRefusedAndNamed) {
  for_each_signal([](const MessageSpec& spec, std::size_t i, const Signal& signal) {
    // The value behind the last one may be the one that means "none".
    const bool none_is_next = signal.may_be_absent && signal.last + 1 == EYECAN_ABSENT;
    for (const std::int64_t value : {signal.first - 1, signal.last + (none_is_next ? 2 : 1)}) {
      RawValues raw = values_of(spec, i, false, std::max(0, signal.bank));
      raw.values[place_of(spec, i)] = value;
      const auto frame = encode_raw(spec, spec.last_node, raw.view());
      ASSERT_FALSE(frame) << spec.name << "." << signal.name << " = " << value;
      EXPECT_EQ(frame.error().code, Errc::OutOfRange);
      EXPECT_THAT(frame.error().what,
                  testing::HasSubstr(std::string(spec.name) + "." + std::string(signal.name) +
                                     " is " + std::to_string(value)));
    }
  });
}

TEST(CanCodec, AValueThatIsAbsentIsAcceptedOnlyWhereTheTableSaysSo) {
  int checked = 0;
  for_each_signal([&](const MessageSpec& spec, std::size_t i, const Signal& signal) {
    if (signal.length != 16 || signal.is_signed || signal.last >= EYECAN_ABSENT) return;
    RawValues raw = values_of(spec, i, false);
    raw.values[place_of(spec, i)] = EYECAN_ABSENT;
    EXPECT_EQ(encode_raw(spec, spec.last_node, raw.view()).has_value(), signal.may_be_absent)
        << spec.name << "." << signal.name;
    ++checked;
  });
  EXPECT_GT(checked, 20);
}

TEST(CanCodec, OnlyTheNodesOfTheTableAreWritten) {
  for (const MessageSpec& spec : messages()) {
    RawValues raw = values_of(spec, 99, false);
    if (spec.function == EYECAN_HEARTBEAT) raw.values[0] = EYECAN_STATE_OPERATIONAL;
    for (int node = -1; node <= 99; ++node) {
      const bool allowed = node >= spec.first_node && node <= spec.last_node;
      EXPECT_EQ(encode_raw(spec, node, raw.view()).has_value(), allowed)
          << spec.name << " " << node;
    }
  }
}

TEST(CanCodec, ShortFramesAreRefusedAndLongerOnesRead) {
  for (const auto& words : test::golden_lines("can.hex")) {
    const CanFrame golden = test::frame_from_text(words[0]);
    const MessageSpec& spec = *find_message(words[1]);
    for (std::uint8_t length = 0; length < 8; ++length) {
      CanFrame frame = golden;
      frame.length = length;
      EXPECT_EQ(decode_raw(spec, frame).has_value(), length >= spec.length) << words[0];
    }
  }
}

TEST(CanCodec, BytesAndBitsThatAreNotUsedAreIgnored) {
  CanFrame frame = test::frame_from_text("701#05FFFFFFFFFFFFFF");
  EXPECT_EQ(decode<Heartbeat>(frame)->state, EYECAN_STATE_OPERATIONAL);
  frame = test::frame_from_text("231#0000000001070909");
  EXPECT_EQ(decode<MotorCommand>(frame)->seq, 7);
}

TEST(CanCodec, AMessageIsNotReadAsAnother) {
  const auto frame = encode(1, PoseStatus{});
  ASSERT_TRUE(frame);
  EXPECT_EQ(decode<PoseCommand>(*frame).error().code, Errc::Unsupported);
  CanFrame flexible = *frame;
  flexible.fd = true;
  EXPECT_EQ(decode<PoseStatus>(flexible).error().code, Errc::Unsupported);
}

TEST(CanCodec, FramesOfOtherFormatsAreNoneOfOurs) {
  const auto ours = encode(1, PoseStatus{});
  ASSERT_TRUE(ours);
  for (bool CanFrame::*flag : {&CanFrame::extended, &CanFrame::remote, &CanFrame::error}) {
    CanFrame other = *ours;
    other.*flag = true;
    EXPECT_EQ(decode<PoseStatus>(other).error().code, Errc::Unsupported);
    EXPECT_EQ(decode_any(other).error().code, Errc::Unsupported);
  }
  CanFrame long_id = *ours;
  long_id.id |= 0x1000U;
  EXPECT_EQ(decode_any(long_id).error().code, Errc::Unsupported);
}

TEST(CanCodec, MotorPercentEndsAt100ButTicksAt127) {
  MotorCommand command{.value = {101, 0, 0, 0}, .mask = 1};
  const auto percent = encode(1, command);
  ASSERT_FALSE(percent);
  EXPECT_EQ(percent.error().code, Errc::OutOfRange);
  EXPECT_THAT(percent.error().what, testing::HasSubstr("C_Motor"));
  command.mode = EYECAN_MOTOR_TICKS;
  EXPECT_TRUE(encode(1, command));
}

TEST(CanCodec, HeartbeatAndNmtTakeOnlyTheStatesThereAre) {
  for (int value = 0; value < 256; ++value) {
    const auto byte = static_cast<std::uint8_t>(value);
    const bool state = value == 0 || value == 4 || value == 5 || value == 0x7F;
    const bool command = value == 1 || value == 2 || value == 0x80 || value == 0x81;
    EXPECT_EQ(encode(EYECAN_NODE_HOST, Heartbeat{byte}).has_value(), state) << value;
    EXPECT_EQ(encode(0, NmtCommand{byte, 0}).has_value(), command) << value;
  }
}

TEST(CanCodec, AnyFrameGivesAMessageThatIsWrittenTheSameOrAnError) {
  std::mt19937_64 random(424242);
  int read = 0;
  for (int round = 0; round < 200000; ++round) {
    const MessageSpec& spec = messages()[random() % messages().size()];
    CanFrame frame{
        .id = spec.id(static_cast<int>(random() % 16)), .length = spec.length, .fd = spec.fd};
    if (random() % 8 == 0) frame.id = static_cast<std::uint16_t>(random() % 0x800);
    if (random() % 8 == 0) frame.length = static_cast<std::uint8_t>(random() % 80);
    for (auto& byte : frame.data)
      byte = static_cast<std::uint8_t>(random() % (random() % 2 == 0 ? 4 : 256));
    const auto message = decode_any(frame);
    if (!message) continue;
    ++read;
    const auto again = encode_any(*message);
    ASSERT_TRUE(again) << again.error().what;
    ASSERT_EQ(again->id, frame.id);
    ASSERT_EQ(decode_any(*again), *message);
  }
  EXPECT_GT(read, 20000);
}

TEST(CanTable, IdentifiersAreUniquePerFormatAndInTheOrderOfPriority) {
  for (std::size_t i = 1; i < messages().size(); ++i) {
    const MessageSpec& before = messages()[i - 1];
    const MessageSpec& spec = messages()[i];
    EXPECT_TRUE(before.function < spec.function ||
                (before.function == spec.function && spec.fd && !before.fd));
    EXPECT_EQ(find_message(spec.function, spec.fd), &spec);
    EXPECT_EQ(find_message(spec.name), &spec);
  }
  EXPECT_EQ(find_message("S_Nothing"), nullptr);
  EXPECT_EQ(find_message(-1, false), nullptr);
  EXPECT_EQ(find_message(128, false), nullptr);
}

TEST(CanTable, EveryMessageHasATypeWithAsManyFields) {
  std::size_t types = 0;
  const auto count = [&]<class... Messages>(std::variant<Messages...>*) {
    (
        [&] {
          const MessageSpec* spec = find_message(Messages::kFunction, Messages::kFd);
          ASSERT_NE(spec, nullptr);
          std::size_t signals = 0;
          for (const Signal& signal : spec->signals) signals += signal.bank <= 0 ? 1 : 0;
          EXPECT_EQ(detail::to_raw(Messages{}).count, signals) << spec->name;
          // A message that nobody filled in can be sent.
          EXPECT_TRUE(encode(spec->last_node, Messages{})) << spec->name;
          ++types;
        }(),
        ...);
  };
  count(static_cast<AnyMessage*>(nullptr));
  EXPECT_EQ(types, messages().size());
}

}  // namespace
}  // namespace eyebridge::bridges::can
