// Boards that go away and come back, and noise.
#include <cstdlib>
#include <new>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io7_bench.hpp"
#include "noise_amount.hpp"

namespace {
thread_local bool counting = false;
thread_local std::size_t allocations = 0;
}  // namespace

// Not inlined: else g++ sees free() of what it takes for memory of another operator new.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (counting) ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace eyebridge::bridges::testing {
namespace {

using ::testing::HasSubstr;

class Io7LossTest : public ::testing::Test, protected Io7Bench {
 protected:
  void SetUp() override { ASSERT_TRUE(client.connect()); }
  /// Time passes in steps, with somebody looking after the client; true when a board was found.
  bool look_after_for(Time span) {
    bool found = false;
    for (const Time end = clock.now() + span; clock.now() < end; clock.spend(10ms)) {
      found = client.look_after() || found;
    }
    return found;
  }
};

TEST_F(Io7LossTest, UnpluggedInTheMiddleOfAReplyIsAnErrorUntilItIsBack) {
  damage = [](ScriptedLine& to, const std::string& answer) {
    to.arrive(answer.substr(0, 1), 1ms);
    to.gone = true;
  };
  EXPECT_EQ(client.exchange(io7::psd(1)).error().code, Errc::Disconnected);
  EXPECT_THAT(client.exchange(io7::psd(1)).error().what, HasSubstr("script: unplugged"));
  EXPECT_FALSE(look_after_for(3s));
  EXPECT_EQ(client.exchange(io7::psd(1)).error().code, Errc::Disconnected);

  plug_in();
  EXPECT_TRUE(look_after_for(3s));
  EXPECT_TRUE(line->sent.find("m 1 0\rm 2 0\rm 3 0\rm 4 0\r") != std::string::npos);
  EXPECT_EQ(client.exchange(io7::psd(1)).value().values[0], 512);
  EXPECT_EQ(client.generation(), 2u);
  EXPECT_EQ(client.statistics().losses, 1u);
  EXPECT_THAT(log.text(), HasSubstr("plugged in again or has rebooted"));
}

TEST_F(Io7LossTest, TriesLessOftenTheLongerItIsAway) {
  line->gone = true;
  look_after_for(10s);
  EXPECT_GE(opened, 1 + 4);
  EXPECT_LE(opened, 1 + 9);
}

TEST_F(Io7LossTest, AnIdleBoardThatIsUnpluggedIsNoticed) {
  look_after_for(2s);
  EXPECT_EQ(client.statistics().losses, 0u);
  line->gone = true;
  look_after_for(600ms);
  EXPECT_EQ(client.statistics().losses, 1u);
}

TEST_F(Io7LossTest, ABoardThatRebootedIntoItsVerboseModeIsProbedAgain) {
  board.verbose = true;
  EXPECT_FALSE(client.exchange(io7::psd(1)));
  EXPECT_TRUE(look_after_for(3s));
  EXPECT_EQ(client.exchange(io7::psd(1)).value().values[0], 512);
  EXPECT_EQ(client.generation(), 2u);
}

// A drive by the encoders goes on without them for half a second.
TEST_F(Io7LossTest, ABoardThatWasDeafIsFoundSoonAfterItHearsAgain) {
  for (Time deaf = 5ms; deaf <= 400ms; deaf += 5ms) {
    const Time from = clock.now();
    const auto answers = std::exchange(line->on_write, {});
    line->on_write = [&](ScriptedLine& to, const std::string& sent) {
      if (clock.now() - from >= deaf) answers(to, sent);
    };
    EXPECT_EQ(client.exchange(io7::psd(1)).value().values[0], 512) << deaf / 1ms << " ms";
    EXPECT_LE((clock.now() - from) / 1ms, std::max(deaf, Time{100ms}) / 1ms + 110) << deaf / 1ms;
    line->on_write = answers;
    clock.spend(20s);
  }
  EXPECT_EQ(client.statistics().losses, 0u);
}

TEST_F(Io7LossTest, AnotherBoardOnTheSameLineIsNotTakenForTheOldOne) {
  board.version = "2.00";
  damage = [](ScriptedLine&, const std::string&) {};
  EXPECT_THAT(client.exchange(io7::psd(1)).error().what,
              HasSubstr("expected its version 1.04, found the version 2.00"));
  EXPECT_TRUE(look_after_for(3s));
  EXPECT_EQ(client.report()->version, "2.00");
}

/// Answers `p` and `v` at once, from memory that is there already.
class QuickStream final : public ByteStream {
 public:
  QuickStream(std::unique_ptr<ByteStream> probed, FakeClock& clock)
      : probed_(std::move(probed)), clock_(clock) {}
  Result<std::size_t> read_some(std::span<std::uint8_t> buffer, Time deadline) override {
    if (!quick) return probed_->read_some(buffer, deadline);
    std::size_t count = 0;
    for (; count < left_; ++count) buffer[count] = 2;
    left_ = 0;
    return count;
  }
  Result<std::size_t> read_now(std::span<std::uint8_t> buffer) override {
    if (!quick) return probed_->read_now(buffer);
    return std::size_t{0};
  }
  Result<void> write_all(std::span<const std::uint8_t> bytes, Time deadline) override {
    if (!quick) return probed_->write_all(bytes, deadline);
    left_ = 2;
    clock_.spend(50us);
    return {};
  }
  void close() override {}
  [[nodiscard]] std::string_view name() const override { return "quick"; }

  bool quick = false;

 private:
  std::unique_ptr<ByteStream> probed_;
  FakeClock& clock_;
  std::size_t left_ = 0;
};

TEST(Io7Allocation, AnExchangeAllocatesNothing) {
  Io7Bench bench;
  QuickStream* stream = nullptr;
  Io7Client client(
      [&]() -> Result<std::unique_ptr<ByteStream>> {
        auto made = std::make_unique<QuickStream>(std::make_unique<ScriptedStream>(bench.line),
                                                  bench.clock);
        stream = made.get();
        return made;
      },
      bench.clock, bench.log);
  ASSERT_TRUE(client.connect());
  stream->quick = true;
  int sum = 0;
  counting = true;
  for (int i = 0; i < 100; ++i) {
    const auto reply = client.exchange(io7::psd(1));
    if (reply) sum += reply->values[0];
    if (client.exchange(io7::motor(1, 10))) ++sum;
  }
  counting = false;
  EXPECT_EQ(sum, 100 * (0x0202 + 1));
  EXPECT_EQ(allocations, 0u);
}

TEST(Io7Noise, RandomBytesNeitherHangNorMoveAnything) {
  Io7Bench bench;
  ASSERT_TRUE(bench.client.connect());
  const std::size_t connected = bench.line->sent.size();
  std::uint64_t seed = 1;
  std::uint64_t fed = 0;
  std::uint64_t wrong = 0;
  const auto next = [&seed] {  // xorshift64
    seed ^= seed << 13U;
    seed ^= seed >> 7U;
    seed ^= seed << 17U;
    return seed;
  };
  bench.line->on_write = [&](ScriptedLine& to, const std::string&) {
    std::string noise(1 + next() % 300, '\0');
    for (char& byte : noise) byte = static_cast<char>(next() >> 32U);
    fed += noise.size();
    to.arrive(noise, Time(static_cast<Time::rep>(next() % 60'000'000)));
  };
  const std::uint64_t wanted = eyebridge::testing::noise_amount(1'000'000);
  while (fed < wanted) {
    const auto reply = bench.client.exchange(io7::psd(1));
    wrong += reply ? 1 : 0;
    bench.client.look_after();
    bench.clock.spend(100ms);
  }
  // No frame, no checksum: two random bytes alone may pass for a reading, but not often.
  EXPECT_LE(wrong, fed / 10'000);
  EXPECT_EQ(bench.line->sent.find_first_not_of(std::string("\r\nhpv 1\0", 8), connected),
            std::string::npos);
}

}  // namespace
}  // namespace eyebridge::bridges::testing
