// One direction of a line through shared memory.
#include "remote_robot/byte_ring.hpp"

#include <algorithm>
#include <deque>
#include <memory>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rigs.hpp"

namespace eyebridge::hal {
namespace {

/// Its counts pass 2^32 soon.
std::unique_ptr<SharedRing> old_ring() {
  auto ring = std::make_unique<SharedRing>();
  ring->written = ring->read = 0U - 3 * SharedRing::kRoom - 5;
  return ring;
}

class Ring : public ::testing::Test {
 protected:
  const std::unique_ptr<SharedRing> memory_ = old_ring();
  RingWriter writer_{*memory_};
  RingReader reader_{*memory_};
};

TEST_F(Ring, GivesBackWhatWasWrittenInItsOrder) {
  std::mt19937 random(1);  // NOLINT: the same each time
  std::deque<std::uint8_t> inside;
  std::uint8_t next = 0;
  for (int step = 0; step < 500; ++step) {
    std::vector<std::uint8_t> sent(random() % 9'000);
    for (std::uint8_t& byte : sent) byte = next++;
    const std::size_t written = must(writer_.write(sent));
    EXPECT_EQ(written, std::min(sent.size(), SharedRing::kRoom - inside.size()));
    inside.insert(inside.end(), sent.begin(), sent.begin() + static_cast<std::ptrdiff_t>(written));
    next = static_cast<std::uint8_t>(next - (sent.size() - written));
    EXPECT_EQ(writer_.is_full(), inside.size() == SharedRing::kRoom);
    std::vector<std::uint8_t> room(random() % 9'000);
    room.resize(must(reader_.read(room)));
    ASSERT_TRUE(std::equal(room.begin(), room.end(), inside.begin()));
    inside.erase(inside.begin(), inside.begin() + static_cast<std::ptrdiff_t>(room.size()));
    EXPECT_EQ(reader_.is_empty(), inside.empty());
  }
}

TEST_F(Ring, SomebodyWhoSleepsIsWokenOnce) {
  EXPECT_FALSE(writer_.must_wake());
  reader_.set_asleep(true);
  EXPECT_TRUE(writer_.must_wake());
  EXPECT_FALSE(writer_.must_wake());
  writer_.set_asleep(true);
  writer_.set_asleep(false);
  EXPECT_FALSE(reader_.must_wake());
}

TEST_F(Ring, ACountThatCannotBeIsToldAndTouchesNothing) {
  std::vector<std::uint8_t> bytes(10);
  memory_->written = memory_->read + SharedRing::kRoom + 1;
  EXPECT_EQ(reader_.read(bytes).error().code, Errc::Corrupt);
  memory_->read += 1;
  const auto written = writer_.write(bytes);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, Errc::Corrupt);
  EXPECT_THAT(written.error().what, ::testing::HasSubstr("written over it"));
}

}  // namespace
}  // namespace eyebridge::hal
