// A protocol's identifiers elsewhere on a bus: what is there is heard, all else is not.
#include "eyebridge/bridges/moved_bus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/bridges/memory.hpp"
#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

using ::testing::HasSubstr;

CanFrame frame_of(std::uint32_t id, bool extended) {
  CanFrame frame;
  frame.id = id;
  frame.extended = extended;
  frame.length = 2;
  frame.data[0] = 7;
  return frame;
}

struct Moved {
  explicit Moved(CanPlace place) : here(bus.connect("here"), place) {}

  MonotonicClock clock;
  MemoryCan bus{clock};
  MovedBus here;
  std::unique_ptr<CanBus> there = bus.connect("there");
};

TEST(MovedBus, SendsAndHearsAtItsPlaceOnly) {
  for (const CanPlace place : {CanPlace{0x1000, true}, CanPlace{0, true}, CanPlace{0x20, false}}) {
    Moved moved(place);
    ASSERT_TRUE(moved.here.send(frame_of(0x181, false), kSoon));
    EXPECT_EQ(moved.there->receive(kSoon).value(), frame_of(0x181 + place.offset, place.extended));
    for (const CanFrame& foreign :
         {frame_of(0x181, !place.extended),
          frame_of(place.offset == 0 ? 0x10000 : place.offset - 1, place.extended)}) {
      ASSERT_TRUE(moved.there->send(foreign, kSoon));
    }
    ASSERT_TRUE(moved.there->send(frame_of(0x191 + place.offset, place.extended), kSoon));
    EXPECT_EQ(moved.here.receive(kSoon).value(), frame_of(0x191, false));
    EXPECT_EQ(moved.here.receive(kPast).error().code, Errc::Timeout);
    EXPECT_EQ(moved.here.on_socket(frame_of(0x11, false)),
              frame_of(0x11 + place.offset, place.extended));
  }
}

TEST(MovedBus, FiltersByItsOwnIdentifiers) {
  Moved moved({0x1003, true});
  const CanFilter node_one{.id = 1, .mask = 0xF};
  ASSERT_TRUE(moved.here.set_filters({&node_one, 1}));
  for (const std::uint32_t id : {0x182U, 0x191U, 0x70FU}) {
    ASSERT_TRUE(moved.there->send(frame_of(id + 0x1003, true), kSoon));
  }
  EXPECT_EQ(moved.here.receive(kSoon).value().id, 0x191U);
  EXPECT_EQ(moved.here.receive(kPast).error().code, Errc::Timeout);
}

TEST(MovedBus, RefusesIdentifiersThatThereAreNot) {
  Moved moved({0xF0, false});
  EXPECT_TRUE(moved.here.send(frame_of(0x70F, false), kSoon));
  EXPECT_THAT(moved.here.send(frame_of(0x710, false), kSoon).error().what,
              HasSubstr("there is no identifier 2048"));
  EXPECT_EQ(moved.here.send(frame_of(1, true), kSoon).error().code, Errc::OutOfRange);
}

}  // namespace
}  // namespace eyebridge::bridges::testing
