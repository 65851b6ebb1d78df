// The dialogues of tests/data/protocol/can_dialogues.txt with the firmware.
#include <algorithm>
#include <deque>
#include <memory>
#include <string>

#include <gmock/gmock.h>

#include "board_fixture.hpp"
#include "golden.hpp"

namespace eyebridge::firmware {
namespace {

constexpr std::uint32_t kStepMs = 10;
constexpr std::uint32_t kPatienceMs = 300;
constexpr std::uint32_t kHeartbeatMs = 100;

class Dialogue {
 public:
  Dialogue() { plant_.lag = 0.02; }

  void send(const std::string& frame) {
    (void)heard();
    heard_.clear();
    host_.send(frame);
  }
  void wait(std::uint32_t ms, bool is_silent) {
    is_silent_ = is_silent;
    for (; ms > 0; ms -= kStepMs) step();
    (void)heard();
    heard_.clear();
  }
  /// The next frame with the identifier of `pattern`; empty: none came.
  std::string hear(const std::string& pattern) {
    for (std::uint32_t ms = 0;; ms += kStepMs) {
      const auto found = std::ranges::find_if(heard(), [&](const std::string& frame) {
        return frame.substr(0, 3) == pattern.substr(0, 3);
      });
      if (found != heard_.end()) {
        std::string frame = *found;
        heard_.erase(found);
        return frame;
      }
      if (ms == kPatienceMs) return {};
      step();
    }
  }

 private:
  std::deque<std::string>& heard() {
    for (std::string& frame : host_.frames()) heard_.push_back(std::move(frame));
    return heard_;
  }
  void step() {
    if (now_ % kHeartbeatMs == 0 && !is_silent_) host_.send("70F#05");
    now_ += kStepMs;
    host_.wait_ms(kStepMs, [this] { plant_.step(host_.board); });
    (void)heard();  // at its time, as on a bus
  }

  BoardUnderTest host_{config_with([](eb_config& config) { config.node = 1; })};
  Plant plant_;
  std::deque<std::string> heard_;
  std::uint32_t now_ = 0;
  bool is_silent_ = false;
};

bool matches(const std::string& frame, const std::string& pattern) {
  return std::ranges::equal(frame, pattern, [](char c, char p) { return p == '.' || c == p; });
}

TEST(CanDialogues, TheFirmwareAnswersAsTheSpecificationSays) {
  std::unique_ptr<Dialogue> dialogue;
  std::string title;
  int dialogues = 0;
  for (const auto& words : bridges::test::golden_lines("can_dialogues.txt")) {
    const std::string& what = words.at(0);
    const std::string& argument = words.at(1);
    const auto told = [&] { return title + ": " + what + " " + argument; };
    if (what == "dialogue") {
      dialogue = std::make_unique<Dialogue>();
      title.clear();
      for (const std::string& word : words) title += word + " ";
      ++dialogues;
    } else if (what == "send") {
      dialogue->send(argument);
    } else if (what == "wait" || what == "silent") {
      dialogue->wait(static_cast<std::uint32_t>(std::stoul(argument)), what == "silent");
    } else if (what == "hear") {
      const std::string frame = dialogue->hear(argument);
      EXPECT_TRUE(matches(frame, argument)) << told() << ", found " << frame;
    } else if (what == "never") {
      EXPECT_EQ(dialogue->hear(argument), "") << told();
    } else {
      FAIL() << told() << ": expected dialogue, send, wait, silent, hear or never";
    }
  }
  EXPECT_GE(dialogues, 25);
}

}  // namespace
}  // namespace eyebridge::firmware
