#include <cmath>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include "eyebridge/bridges/can/messages.hpp"
#include "golden.hpp"

namespace eyebridge::bridges::can {
namespace {

using test::frame_from_text;
using test::golden_lines;

TEST(CanGolden, EveryFrameIsReadAsInTheFile) {
  for (const auto& words : golden_lines("can.hex")) {
    const MessageSpec* spec = find_message(words[1]);
    ASSERT_NE(spec, nullptr) << words[1];
    const auto raw = decode_raw(*spec, frame_from_text(words[0]));
    ASSERT_TRUE(raw) << words[0] << " " << raw.error().what;
    ASSERT_EQ(raw->count, words.size() - 2) << words[0];
    std::size_t at = 0;
    for (const Signal& signal : spec->signals) {
      if (signal.bank >= 0 && signal.bank != raw->values[0]) continue;
      const std::string& word = words[2 + at];
      const std::size_t equals = word.find('=');
      EXPECT_EQ(word.substr(0, equals), signal.name);
      EXPECT_NEAR(signal.physical(raw->values[at]), std::stod(word.substr(equals + 1)), 1e-6)
          << words[0] << " " << word;
      ++at;
    }
  }
}

TEST(CanGolden, EveryFrameIsWrittenAsInTheFile) {
  for (const auto& words : golden_lines("can.hex")) {
    const MessageSpec& spec = *find_message(words[1]);
    const CanFrame expected = frame_from_text(words[0]);
    RawValues raw;
    for (std::size_t i = 2; i < words.size(); ++i) {
      const std::size_t equals = words[i].find('=');
      const double physical = std::stod(words[i].substr(equals + 1));
      for (const Signal& signal : spec.signals) {
        if (signal.name == words[i].substr(0, equals)) {
          raw.push(std::llround((physical - signal.offset) / signal.scale));
        }
      }
    }
    const auto frame = encode_raw(spec, node_of(expected.id), raw.view());
    ASSERT_TRUE(frame) << words[0] << " " << frame.error().what;
    EXPECT_EQ(*frame, expected) << words[0];
  }
}

TEST(CanGolden, EveryFrameSurvivesTheTypedRoundTrip) {
  for (const auto& words : golden_lines("can.hex")) {
    const CanFrame frame = frame_from_text(words[0]);
    const auto message = decode_any(frame);
    ASSERT_TRUE(message) << words[0] << " " << message.error().what;
    EXPECT_EQ(message->node, node_of(frame.id));
    EXPECT_EQ(encode_any(*message), frame) << words[0];
  }
}

TEST(CanGolden, EveryMessageOfTheTableIsInTheFile) {
  std::set<std::string> names;
  for (const auto& words : golden_lines("can.hex")) names.insert(words[1]);
  for (const MessageSpec& spec : messages())
    EXPECT_TRUE(names.contains(std::string(spec.name))) << spec.name;
  EXPECT_EQ(names.size(), messages().size());
}

TEST(CanGolden, EveryRefusedFrameIsRefused) {
  for (const auto& words : golden_lines("can_refused.hex")) {
    const auto message = decode_any(frame_from_text(words[0]));
    ASSERT_FALSE(message) << words[0];
    const bool foreign = words[1] == "an";  // "an identifier that is none of ours"
    EXPECT_EQ(message.error().code, foreign ? Errc::Unsupported : Errc::Corrupt) << words[0];
  }
}

}  // namespace
}  // namespace eyebridge::bridges::can
