#include "eyebridge/bridges/dbc/signal.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <random>

#include <gmock/gmock.h>

namespace eyebridge::bridges::dbc {
namespace {

using EightBytes = std::array<std::uint8_t, 8>;

Signal made(int start, int length, ByteOrder order, NumberKind kind = NumberKind::Unsigned) {
  Signal signal;
  signal.name = "S";
  signal.start = start;
  signal.length = length;
  signal.order = order;
  signal.kind = kind;
  return signal;
}

TEST(Signal, BothByteOrdersAreReadAndWritten) {
  const EightBytes data{0x12, 0x34, 0x56, 0x78, 0x9A, 0xBC, 0xDE, 0xF0};
  EXPECT_EQ(raw_bits(made(0, 16, ByteOrder::Intel), data), 0x3412u);
  EXPECT_EQ(raw_bits(made(7, 16, ByteOrder::Motorola), data), 0x1234u);
  EXPECT_EQ(raw_bits(made(3, 12, ByteOrder::Motorola), data), 0x234u);
  EXPECT_EQ(raw_bits(made(4, 12, ByteOrder::Intel), data), 0x341u);
  EXPECT_EQ(raw_bits(made(7, 64, ByteOrder::Motorola), data), 0x123456789ABCDEF0u);
  EXPECT_EQ(raw_bits(made(0, 64, ByteOrder::Intel), data), 0xF0DEBC9A78563412u);
}

TEST(Signal, WhatIsWrittenIsReadAndNothingElseChanges) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 5000; ++i) {
    const int start = static_cast<int>(random() % 64);
    const auto order = random() % 2 == 0 ? ByteOrder::Intel : ByteOrder::Motorola;
    const Signal signal = made(start, 1 + static_cast<int>(random() % 64), order);
    if (!fits(signal, 8)) continue;
    const EightBytes before = std::bit_cast<EightBytes>(static_cast<std::uint64_t>(random()));
    const std::uint64_t mask =
        signal.length == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << signal.length) - 1;
    const std::uint64_t bits = random() & mask;
    EightBytes data = before;
    put_bits(signal, bits, data);
    ASSERT_EQ(raw_bits(signal, data), bits);
    put_bits(signal, raw_bits(signal, before), data);
    ASSERT_EQ(data, before);
  }
}

TEST(Signal, OnlyWhatLiesInTheFrameFits) {
  EXPECT_TRUE(fits(made(56, 8, ByteOrder::Intel), 8));
  EXPECT_FALSE(fits(made(57, 8, ByteOrder::Intel), 8));
  EXPECT_TRUE(fits(made(63, 8, ByteOrder::Motorola), 8));
  EXPECT_FALSE(fits(made(62, 8, ByteOrder::Motorola), 8));
  EXPECT_FALSE(fits(made(0, 1, ByteOrder::Intel), 0));
}

TEST(Signal, SignsFloatsAndScales) {
  Signal small = made(0, 4, ByteOrder::Intel, NumberKind::Signed);
  small.factor = 0.5;
  small.offset = 10;
  EXPECT_EQ(whole_number(small, 0xF), -1);
  EXPECT_DOUBLE_EQ(value_of(small, 0xF), 9.5);
  const Signal widest = made(0, 64, ByteOrder::Intel, NumberKind::Signed);
  EXPECT_EQ(whole_number(widest, ~std::uint64_t{0}), -1);
  const Signal single = made(0, 32, ByteOrder::Intel, NumberKind::Float32);
  EXPECT_DOUBLE_EQ(value_of(single, std::bit_cast<std::uint32_t>(1.5F)), 1.5);
  EXPECT_EQ(whole_number(single, std::bit_cast<std::uint32_t>(-2.0F)), -2);
  EXPECT_EQ(whole_number(single, std::bit_cast<std::uint32_t>(std::nanf(""))), 0);
  const Signal both = made(0, 64, ByteOrder::Intel, NumberKind::Float64);
  EXPECT_DOUBLE_EQ(value_of(both, std::bit_cast<std::uint64_t>(-0.25)), -0.25);
}

TEST(Signal, ValuesBecomeTheNearestBits) {
  Signal speed = made(7, 16, ByteOrder::Motorola, NumberKind::Signed);
  speed.factor = 0.1;
  EXPECT_EQ(bits_for(speed, 1.26).value(), 13u);
  EXPECT_EQ(bits_for(speed, -0.1).value(), 0xFFFFu);
  EXPECT_EQ(bits_for(speed, -3276.8).value(), 0x8000u);
  EXPECT_EQ(bits_for(speed, 3276.74).value(), 0x7FFFu);
  for (const double beyond : {3276.8, -3277.0, 1e300, std::nan(""), HUGE_VAL}) {
    EXPECT_EQ(bits_for(speed, beyond).error().code, Errc::OutOfRange) << beyond;
  }
  speed.minimum = -10;
  speed.maximum = 10;
  EXPECT_TRUE(bits_for(speed, 10).has_value());
  EXPECT_FALSE(bits_for(speed, 10.2).has_value());
  const Signal widest = made(0, 64, ByteOrder::Intel);
  EXPECT_EQ(bits_for(widest, 0x1p64).value(), ~std::uint64_t{0});
  const Signal widest_signed = made(0, 64, ByteOrder::Intel, NumberKind::Signed);
  EXPECT_EQ(bits_for(widest_signed, 0x1p63 - 1).value(), ~std::uint64_t{0} >> 1);
  Signal flat = made(0, 8, ByteOrder::Intel);
  flat.factor = 0;
  EXPECT_FALSE(bits_for(flat, 0).has_value());
}

TEST(Signal, AFactorBelowZeroTurnsTheRangeAround) {
  Signal signal = made(0, 8, ByteOrder::Intel);
  signal.factor = -2;
  signal.offset = 100;
  EXPECT_DOUBLE_EQ(value_range(signal).lowest, 100 - 510);
  EXPECT_DOUBLE_EQ(value_range(signal).highest, 100);
  EXPECT_EQ(bits_for(signal, 90).value(), 5u);
}

}  // namespace
}  // namespace eyebridge::bridges::dbc
