// What messages suffer between the robots of one world: how often, how late, how far, by the seed.
#include <bit>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clock/lockstep_clock.hpp"
#include "eyebridge/hal/passing_backend.hpp"
#include "host/open_host.hpp"
#include "radio/radio_medium.hpp"
#include "rigs.hpp"
#include "shared/open_only.hpp"
#include "statistics.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;
using namespace eyebridge::testing;

constexpr int kMessages = 3000;  // fewer than an inbox holds

RadioErrors errors(double loss, Time delay, Time jitter, double corrupt, double range = 0.0) {
  RadioErrors out{loss, delay, 1};
  out.jitter = jitter;
  out.corrupt = corrupt;
  out.range = range;
  return out;
}

struct Arrival {
  int number = 0;      ///< Of the message, by its place in the order of sending.
  double after = 0.0;  ///< Seconds.
  std::string text;
};

/// kMessages from robot 1 to robot 2, sent at once, all with `text` behind their number.
std::vector<Arrival> arrivals(const RadioErrors& errors, const std::string& text = "") {
  LockstepClock clock(1ms, [] {});
  const auto medium = std::make_shared<RadioMedium>();
  const auto one = make_medium_radio(medium, 1, {}, clock);
  const auto two = make_medium_radio(medium, 2, errors, clock);
  EXPECT_TRUE(one->start() && two->start());
  for (int i = 0; i < kMessages; ++i) {
    std::string numbered = text.empty() ? std::to_string(i) : text;
    EXPECT_TRUE(one->send(2, numbered));
  }
  std::vector<Arrival> out;
  const Time start = clock.now();
  for (int i = 0; i < 1000; ++i) {
    while (const auto message = two->receive().value()) {
      const int number = text.empty() ? std::stoi(message->text) : 0;
      out.push_back({number, to_seconds(clock.now() - start), message->text});
    }
    clock.spend(100us);
  }
  return out;
}

TEST(RadioErrors, LossIsOneMessageByItself) {
  const auto arrived = arrivals(errors(0.3, Time{0}, Time{0}, 0));
  std::vector<double> lost(kMessages, 1);
  for (const Arrival& arrival : arrived) lost[static_cast<std::size_t>(arrival.number)] = 0;
  std::vector<double> pairs(4);
  for (std::size_t i = 0; i < kMessages; i += 2) {
    ++pairs[static_cast<std::size_t>(2 * lost[i] + lost[i + 1])];
  }
  constexpr double kPairs = kMessages / 2.0;
  EXPECT_GT(chi_square_p_value(pairs, {0.49 * kPairs, 0.21 * kPairs, 0.21 * kPairs, 0.09 * kPairs}),
            kUnlikely);
}

TEST(RadioErrors, JitterIsEvenlySpreadBeyondTheDelay) {
  const auto arrived = arrivals(errors(0, 20ms, 50ms, 0));
  ASSERT_EQ(arrived.size(), std::size_t{kMessages});
  std::vector<double> late;
  bool overtakes = false;
  for (std::size_t i = 0; i < arrived.size(); ++i) {
    // Looked at every 0.1 ms: in the middle of that on the average.
    late.push_back(arrived[i].after - 0.00005);
    overtakes = overtakes || (i > 0 && arrived[i].number < arrived[i - 1].number);
  }
  EXPECT_TRUE(overtakes);
  const Moments moments = moments_of(late);
  EXPECT_NEAR(moments.mean, 0.045, 4 * 0.05 / std::sqrt(12.0 * kMessages));
  EXPECT_GT(ks_p_value(late, [](double x) { return std::clamp((x - 0.02) / 0.05, 0.0, 1.0); }),
            kUnlikely);
}

TEST(RadioErrors, CorruptionFlipsOneBitAnywhereInAsManyMessagesAsAskedFor) {
  const std::string text = "8 bytes.";
  std::vector<double> bits(64);
  double corrupted = 0;
  for (const Arrival& arrival : arrivals(errors(0, Time{0}, Time{0}, 0.4), text)) {
    ASSERT_EQ(arrival.text.size(), text.size());
    int flipped = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto difference = static_cast<unsigned char>(arrival.text[i] ^ text[i]);
      if (difference == 0) continue;
      flipped += std::popcount(difference);
      ++bits[8 * i + static_cast<std::size_t>(std::countr_zero(difference))];
    }
    ASSERT_LE(flipped, 1);
    corrupted += flipped;
  }
  EXPECT_GT(binomial_p_value(corrupted, kMessages, 0.4), kUnlikely);
  EXPECT_GT(chi_square_p_value(bits, std::vector<double>(64, corrupted / 64)), kUnlikely);
}

TEST(RadioErrors, OneKindDoesNotShiftAnother) {
  const auto numbers = [](const RadioErrors& errors) {
    std::vector<int> out;
    for (const Arrival& arrival : arrivals(errors)) out.push_back(arrival.number);
    std::sort(out.begin(), out.end());
    return out;
  };
  EXPECT_EQ(numbers(errors(0.2, Time{0}, Time{0}, 0)), numbers(errors(0.2, 5ms, 20ms, 0)));
  EXPECT_NE(numbers(errors(0.2, Time{0}, Time{0}, 0)), numbers(errors(0.25, Time{0}, Time{0}, 0)));
}

TEST(RadioErrors, NothingArrivesFromBeyondTheReceiversRange) {
  LockstepClock clock(10ms, [] {});
  const auto medium = std::make_shared<RadioMedium>();
  double x = 0.0;
  const RadioErrors near = errors(0, Time{0}, Time{0}, 0, 2.0);
  const auto one = make_medium_radio(medium, 1, {}, clock, [&] { return Vec2{x, 0}; });
  const auto two = make_medium_radio(medium, 2, near, clock, [] { return Vec2{3, 4}; });
  const auto nowhere = make_medium_radio(medium, 3, near, clock);
  for (const auto* radio : {&one, &two, &nowhere}) ASSERT_TRUE((*radio)->start());
  const auto heard = [&](const std::unique_ptr<Radio>& radio) {
    EXPECT_TRUE(one->send(Radio::kEveryone, "x"));
    return radio->receive().value().has_value();
  };
  EXPECT_FALSE(heard(two)) << "5 m away";
  EXPECT_TRUE(heard(nowhere)) << "nobody knows how far";
  EXPECT_TRUE(two->send(1, "y"));
  EXPECT_TRUE(one->receive().value().has_value()) << "it is the receiver's range that counts";
  x = 3.0;
  EXPECT_FALSE(heard(two)) << "4 m away";
  ASSERT_TRUE(two->stop());
  const auto at_edge = make_medium_radio(medium, 4, near, clock, [] { return Vec2{3, 2}; });
  ASSERT_TRUE(at_edge->start());
  EXPECT_TRUE(heard(at_edge)) << "2 m";
}

/// Robot 1 of a rig's world, with the radio of this computer in `air`, and its id.
std::unique_ptr<Backend> robot_with_radio(const std::map<std::string, std::string>& flags,
                                          const std::shared_ptr<RadioMedium>& air,
                                          KeepingLog& log) {
  std::map<std::string, std::string> all = flags;
  all["fast"] = "true";
  const Config config = rig_config(all);
  auto robot = open_scenario(rig_scenario(0.5), {"room.wld"}, {config, log});
  return with_host_devices(std::move(robot), {config, log}, air);
}

class Numbered final : public PassingBackend {
 public:
  Numbered(std::unique_ptr<Backend> inner, int id) : PassingBackend(std::move(inner)), id_(id) {}
  [[nodiscard]] int robot_id() const override { return id_; }

 private:
  int id_;
};

TEST(RadioErrors, ARobotWhoseNumberNobodyCanSendToHasNoRadio) {
  // Numbers are never used again: a run whose robots come and go gets there in an hour. The program
  // of such a robot in a process of its own did not even start.
  KeepingLog log;
  const Config config = rig_config({{"fast", "true"}});
  for (const int id : {255, 256}) {
    auto robot = open_scenario(rig_scenario(0.5), {"room.wld"}, {config, log});
    const auto whole =
        with_host_devices(std::make_unique<Numbered>(std::move(robot), id), {config, log}, nullptr);
    EXPECT_EQ(whole->radio() != nullptr, id == 255) << id;
  }
}

TEST(RadioErrors, OfARobotComeFromItsModelOrTheSetting) {
  for (const bool by_setting : {false, true}) {
    KeepingLog log;
    const auto air = std::make_shared<RadioMedium>();
    const auto robot =
        robot_with_radio({{"radio", by_setting ? "world?range=1m" : "world"}}, air, log);
    ASSERT_TRUE(robot->radio()->start());
    const Pose pose = robot->world()->robot_pose(0).value();
    const auto other = make_medium_radio(air, 9, {}, robot->clock(), [&] {
      return pose.position() + Vec2{1.5, 0};
    });
    ASSERT_TRUE(other->start());
    ASSERT_TRUE(other->send(1, "x"));
    EXPECT_EQ(robot->radio()->receive().value().has_value(), !by_setting);
  }
}

}  // namespace
}  // namespace eyebridge::hal
