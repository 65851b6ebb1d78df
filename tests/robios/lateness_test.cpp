#include "lateness.hpp"

#include <gtest/gtest.h>

namespace eyebridge::robios {
namespace {

using std::chrono::hours;
using std::chrono::microseconds;
using std::chrono::milliseconds;

TEST(Lateness, TellsTheWorstAndWhatAlmostAllKeep) {
  Lateness late;
  EXPECT_EQ(late.count(), 0U);
  EXPECT_EQ(late.worst(), Time{0});
  EXPECT_EQ(late.percentile99(), Time{0});
  for (int i = 0; i < 990; ++i) late.add(microseconds(100));
  for (int i = 0; i < 10; ++i) late.add(milliseconds(70));
  late.add(microseconds(-5));  // early is not late
  EXPECT_EQ(late.count(), 1001U);
  EXPECT_EQ(late.worst(), milliseconds(70));
  EXPECT_GE(late.percentile99(), microseconds(100));
  EXPECT_LE(late.percentile99(), microseconds(125));
}

TEST(Lateness, APercentileIsTrueToAQuarter) {
  for (std::int64_t us = 0; us < 100'000'000; us += 1 + us / 7) {
    Lateness late;
    for (int i = 0; i < 99; ++i) late.add(microseconds(us));
    late.add(hours(2));
    EXPECT_GE(late.percentile99(), microseconds(us));
    EXPECT_LE(late.percentile99(), microseconds(us + us / 4)) << us;
  }
}

}  // namespace
}  // namespace eyebridge::robios
