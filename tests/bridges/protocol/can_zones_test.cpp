#include <algorithm>
#include <array>
#include <initializer_list>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "eyebridge/bridges/can/zones.hpp"

namespace eyebridge::bridges::can {
namespace {

constexpr int kChunks = 22;

Zones zones(std::uint16_t first) {
  Zones out{};
  std::iota(out.begin(), out.end(), first);
  return out;
}
/// Chunk `index` of a reading, over the wire.
ZoneChunk sent(const Zones& zones, std::uint8_t reading, int index) {
  ZoneChunk chunk{.reading = reading, .chunk = static_cast<std::uint8_t>(index)};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t zone = 3 * static_cast<std::size_t>(index) + i;
    chunk.range_mm[i] = zone < zones.size() ? zones[zone] : EYECAN_ABSENT;
  }
  return *decode<ZoneChunk>(*encode(1, chunk));
}

TEST(ZoneAssembler, GivesAReadingWhenItsLastFrameHasCome) {
  ZoneAssembler assembler;
  for (const std::uint8_t reading : std::initializer_list<std::uint8_t>{0, 1, 2, 15, 0}) {
    const Zones whole = zones(static_cast<std::uint16_t>(100 * reading));
    for (int i = 0; i < kChunks - 1; ++i) {
      ASSERT_EQ(assembler.push(sent(whole, reading, i)), nullptr) << i;
    }
    const Zones* const put = assembler.push(sent(whole, reading, kChunks - 1));
    ASSERT_NE(put, nullptr);
    EXPECT_EQ(*put, whole);
  }
}

TEST(ZoneAssembler, TakesFramesInAnyOrderAndTwice) {
  std::mt19937 random(5);
  ZoneAssembler assembler;
  std::array<int, kChunks> order{};
  std::iota(order.begin(), order.end(), 0);
  for (std::uint8_t reading = 0; reading < 16; ++reading) {
    std::shuffle(order.begin(), order.end(), random);
    const Zones whole = zones(reading);
    const Zones* put = nullptr;
    for (const int i : order) {
      ASSERT_EQ(put, nullptr);
      if (i != order.back()) assembler.push(sent(whole, reading, i));
      put = assembler.push(sent(whole, reading, i));
    }
    ASSERT_NE(put, nullptr);
    EXPECT_EQ(*put, whole);
  }
}

TEST(ZoneAssembler, AReadingThatLacksAFrameIsGivenUp) {
  ZoneAssembler assembler;
  const Zones lost = zones(1000);
  const Zones next = zones(2000);
  for (int i = 1; i < kChunks; ++i) ASSERT_EQ(assembler.push(sent(lost, 3, i)), nullptr);
  for (int i = 0; i < kChunks - 1; ++i) ASSERT_EQ(assembler.push(sent(next, 4, i)), nullptr);
  const Zones* const put = assembler.push(sent(next, 4, kChunks - 1));
  ASSERT_NE(put, nullptr);
  EXPECT_EQ(*put, next);
}

TEST(ZoneAssembler, WhatIsForgottenIsNotMixedWithALaterReadingOfItsNumber) {
  ZoneAssembler assembler;
  for (int i = 1; i < kChunks; ++i) ASSERT_EQ(assembler.push(sent(zones(1000), 3, i)), nullptr);
  assembler.reset();
  EXPECT_EQ(assembler.push(sent(zones(2000), 3, 0)), nullptr);
}

}  // namespace
}  // namespace eyebridge::bridges::can
