// The two ends of a line to a robot that another process has: what they say, and what they make of
// an end that says nonsense or nothing.
#include "remote_robot/remote_robot.hpp"

#include <array>
#include <cstring>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include "eyebridge/base/sent_descriptor.hpp"
#include "eyebridge/camera/view.hpp"
#include "eyebridge/hal/registry.hpp"
#include "remote_rig.hpp"
#include "remote_robot/message.hpp"
#include "remote_robot/message_stream.hpp"
#include "remote_robot/trace_messages.hpp"

namespace eyebridge::hal {
namespace {

using testing::HasSubstr;

MessageStream world_end(int socket) {
  return {socket, LineMemory::offer(socket), MessageStream::End::World};
}

MessageStream program_end(int socket) {
  return {socket, must(LineMemory::accept(socket)), MessageStream::End::Program};
}

/// What the program's end makes of a server that answers its hello with `answer`.
std::string complaint_about(const Message& answer) {
  auto [ours, theirs] = socket_pair();
  EXPECT_TRUE(world_end(theirs.get()).send(answer));
  try {
    make_remote_robot(std::move(ours), no_world, 1.0);
    return "";
  } catch (const ConfigError& error) {
    return error.text();
  }
}

TEST(WorldSlot, WhatIsNoAnswerIsRefused) {
  EXPECT_THAT(complaint_about({'x', 1, 2}), HasSubstr("no answer"));
  EXPECT_THAT(complaint_about({'w'}), HasSubstr("no answer"));
  EXPECT_THAT(complaint_about(encode(RobotReply{})), HasSubstr("no answer"));
  EXPECT_EQ(complaint_about(encode(RobotReply{{}, {}, fail(Errc::Unsupported, "go away")})),
            "go away");
}

TEST(WorldSlot, AWelcomeWithADeviceThatThereIsNotIsRefused) {
  RobotWelcome welcome;
  welcome.devices.push_back({"wing", 1, {}});
  EXPECT_EQ(complaint_about(encode(welcome)), "unknown device 'wing'");
}

TEST(WorldSlot, ALengthThatNoMessageHasEndsTheLine) {
  for (const std::uint32_t length : {0U, MessageStream::kLongest + 1, 0xFFFFFFFFU}) {
    const auto [one, other] = socket_pair();
    MessageStream stream = world_end(one.get());
    const LineMemory memory = must(LineMemory::accept(other.get()));
    std::array<std::uint8_t, sizeof length> bytes{};
    std::memcpy(bytes.data(), &length, sizeof length);
    ASSERT_EQ(must(RingWriter(memory.line().to_world).write(bytes)), sizeof length);
    const auto message = stream.receive();
    ASSERT_FALSE(message);
    EXPECT_EQ(message.error().code, Errc::Corrupt);
  }
}

TEST(WorldSlot, AMessageThatIsCutOffIsALostLine) {
  auto [one, other] = socket_pair();
  MessageStream stream = world_end(one.get());
  const LineMemory memory = must(LineMemory::accept(other.get()));
  const std::array<std::uint8_t, 8> begun{100, 0, 0, 0, 'q'};
  ASSERT_TRUE(RingWriter(memory.line().to_world).write(begun));
  other.reset();
  EXPECT_EQ(stream.receive().error().code, Errc::Disconnected);
}

TEST(WorldSlot, TheLastWordsOfAnEndThatIsGoneAreHeard) {
  auto [one, other] = socket_pair();
  MessageStream stream = world_end(one.get());
  const Message words{1, 2, 3};
  ASSERT_TRUE(program_end(other.get()).send(words));
  other.reset();
  EXPECT_EQ(must(stream.receive()), words);
  EXPECT_EQ(stream.receive().error().code, Errc::Disconnected);
}

TEST(WorldSlot, NonsenseInTheMemoryEndsTheLine) {
  const auto [one, other] = socket_pair();
  MessageStream stream = world_end(one.get());
  const LineMemory memory = must(LineMemory::accept(other.get()));
  std::memset(static_cast<void*>(&memory.line()), 0xA5, sizeof(SharedLine));
  const auto message = stream.receive();
  ASSERT_FALSE(message);
  EXPECT_EQ(message.error().code, Errc::Corrupt);
  EXPECT_THAT(message.error().what, HasSubstr("in a line that has room for 16384"));
  EXPECT_EQ(stream.send(Message{1}).error().code, Errc::Corrupt);
}

TEST(WorldSlot, ALongMessageGoesInParts) {
  const auto [one, other] = socket_pair();
  MessageStream world = world_end(one.get());
  Message sent(10 * SharedRing::kRoom + 77);
  for (std::size_t i = 0; i < sent.size(); ++i) sent[i] = static_cast<std::uint8_t>(i * 7 % 251);
  std::thread program([fd = other.get(), &sent] {
    MessageStream stream = program_end(fd);
    EXPECT_EQ(must(stream.receive()), sent);
    EXPECT_TRUE(stream.send(sent));
  });
  EXPECT_TRUE(world.send(sent));
  EXPECT_EQ(must(world.receive()), sent);
  program.join();
}

TEST(WorldSlot, AnEndThatHasWaitedForRoomWantsNoMoreSigns) {
  const auto [one, other] = socket_pair();
  MessageStream stream = world_end(one.get());
  const LineMemory memory = must(LineMemory::accept(other.get()));
  SharedRing& ring = memory.line().to_program;
  std::thread writer([&stream] { EXPECT_TRUE(stream.send(Message(SharedRing::kRoom))); });
  while (ring.writer_sleeps == 0) std::this_thread::yield();
  std::vector<std::uint8_t> room(SharedRing::kRoom);
  EXPECT_EQ(must(RingReader(ring).read(room)), room.size());
  EXPECT_EQ(::send(other.get(), "", 1, 0), 1);
  writer.join();
  EXPECT_EQ(ring.writer_sleeps, 0U);
}

TEST(WorldSlot, AnEndThatHasWaitedForAMessageWantsNoMoreSigns) {
  const auto [one, other] = socket_pair();
  MessageStream stream = world_end(one.get());
  const LineMemory memory = must(LineMemory::accept(other.get()));
  SharedRing& ring = memory.line().to_world;
  std::thread reader([&stream] { EXPECT_EQ(must(stream.receive()), Message{7}); });
  while (ring.reader_sleeps == 0) std::this_thread::yield();
  EXPECT_TRUE(RingWriter(ring).write(std::array<std::uint8_t, 5>{1, 0, 0, 0, 7}));
  EXPECT_EQ(::send(other.get(), "", 1, 0), 1);
  reader.join();
  EXPECT_EQ(ring.reader_sleeps, 0U);
}

TEST(WorldSlot, OtherMemoryIsRefused) {
  for (const bool has_descriptor : {false, true}) {
    const auto [one, other] = socket_pair();
    const std::array<std::byte, 1> sign{};
    const UniqueFd file(memfd_create("short", MFD_CLOEXEC));
    ASSERT_EQ(send_with_descriptor(one.get(), sign, has_descriptor ? file.get() : -1), 1);
    const auto memory = LineMemory::accept(other.get());
    ASSERT_FALSE(memory);
    EXPECT_EQ(memory.error().code, Errc::Corrupt);
  }
}

TEST(WorldSlot, TheDeskRefusesWhatIsNoQuestion) {
  const Rig rig = lockstep_rig(facing(0.5));
  const auto [program, socket] = socket_pair();
  RobotServer server(*rig.backend, nullptr, socket.get());
  MessageStream stream = program_end(program.get());
  ASSERT_TRUE(stream.send(Message{'q', 0, 0}));
  const auto received = server.receive();
  ASSERT_FALSE(received);
  EXPECT_EQ(received.error().code, Errc::Corrupt);
  EXPECT_THAT(received.error().what, HasSubstr("found 3 bytes that are no question"));
}

TEST(WorldSlot, TheDeskRefusesAProgramOfAnotherVersion) {
  const Rig rig = lockstep_rig(facing(0.5));
  const auto [program, socket] = socket_pair();
  RobotServer server(*rig.backend, nullptr, socket.get());
  MessageStream stream = program_end(program.get());
  ASSERT_TRUE(stream.send(encode(RobotRequest{{}, "robot", 1, "hello", false, {99.0}})));
  ASSERT_TRUE(server.receive() && server.answer());
  const auto reply = decode_reply(must(stream.receive()));
  ASSERT_TRUE(reply);
  EXPECT_THAT(reply->values.error().what, HasSubstr("another version"));
}

/// What a server answers to a call that no interceptor would make.
Error error_of(const Call& call) {
  const Rig rig = lockstep_rig(facing(0.5));
  const auto [program, socket] = socket_pair();
  RobotServer server(*rig.backend, nullptr, socket.get());
  MessageStream stream = program_end(program.get());
  const RobotRequest request{
      {}, std::string(call.device), call.id, std::string(call.name), call.is_command, call.request};
  EXPECT_TRUE(stream.send(encode(request)));
  EXPECT_TRUE(server.receive() && server.answer());
  const auto reply = decode_reply(must(stream.receive()));
  if (!reply || reply->values) return {Errc::Timeout, "no error"};
  return reply->values.error();
}

TEST(WorldSlot, CallsThatThereAreNotAreErrorsOfThatCallAlone) {
  EXPECT_EQ(error_of({"psd", 9, "read", false, {}}).what, "this robot has no psd 9 read");
  EXPECT_EQ(error_of({"psd", 1, "fly", false, {}}).what, "this robot has no psd 1 fly");
  EXPECT_EQ(error_of({"wing", 1, "read", false, {}}).code, Errc::Unsupported);
  EXPECT_EQ(error_of({"serial", 0, "open", true, {9600.0, 0.0}}).code, Errc::Unsupported);
  EXPECT_EQ(error_of({"drive", 1, "start", true, {1.0}}).what,
            "drive 1 start: 1 numbers in the request, expected 3");
  EXPECT_EQ(error_of({"world", 0, "set_robot_pose", true, {1.0}}).code, Errc::Corrupt);
  EXPECT_EQ(error_of({"world", 0, "set_robot_altitude", true, {}}).code, Errc::Corrupt);
  EXPECT_EQ(error_of({"view", 1, "smell", false, {}}).code, Errc::Unsupported);
  EXPECT_EQ(error_of({"remote", 1, "bend", false, {}}).code, Errc::Unsupported);
}

TEST(WorldSlot, ALostRemoteRobotIsAnErrorNotAReading) {
  RemoteRig rig = remote_rig(facing(0.5));
  ASSERT_TRUE(rig.robot->range_sensor(1)->read());
  camera::View& view = *rig.robot->camera_view();
  const double eye = view.eye().x;
  EXPECT_NE(eye, 0.0);
  rig.end();
  EXPECT_EQ(view.eye().x, eye) << "nothing moves any more";
  const auto range = rig.robot->range_sensor(1)->read();
  ASSERT_FALSE(range);
  EXPECT_EQ(range.error().code, Errc::Disconnected);
  EXPECT_FALSE(rig.robot->drive()->set_speed({0.1, 0.0}));
  EXPECT_EQ(rig.robot->world()->robot_count(), 0);
  // Nobody waits for ever: time passes without a world.
  const Time later = rig.robot->clock().now() + from_seconds(10.0);
  rig.robot->clock().wait_until(later);
  EXPECT_EQ(rig.robot->clock().now(), later);
  rig.robot->stop();
}

TEST(WorldSlot, TheClockRunsByItselfOnlyUpToItsLimit) {
  auto [ours, theirs] = socket_pair();
  MessageStream stream = world_end(theirs.get());
  RobotWelcome welcome;
  welcome.is_virtual = true;
  welcome.limit = from_seconds(1.0);
  ASSERT_TRUE(stream.send(encode(welcome)));
  const auto robot = make_remote_robot(std::move(ours), no_world, 1.0);
  ASSERT_EQ(decode_request(must(stream.receive()))->name, "hello");
  robot->clock().spend(from_seconds(0.25));
  robot->clock().wait_until(from_seconds(0.999));
  EXPECT_EQ(robot->clock().now(), from_seconds(0.999));
  // The answer lies ready: what is asked is read afterwards.
  ASSERT_TRUE(stream.send(encode(RobotReply{from_seconds(1.5), from_seconds(2.0), Values{}})));
  robot->clock().wait_until(from_seconds(1.5));
  const auto asked = decode_request(must(stream.receive()));
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->name, "now");
  EXPECT_EQ(asked->time, from_seconds(1.5));
  robot->clock().spend(from_seconds(0.4));
  EXPECT_EQ(robot->clock().now(), from_seconds(1.9));
  theirs.reset();
}

TEST(WorldSlot, ALongTraceComesInSeveralMessages) {
  TraceMessages messages;
  const std::array<double, 8> ranges{1, 2, 3, 4, 5, 6, 7, 8};
  constexpr int kPoints = 20'000;
  for (int i = 0; i < kPoints; ++i) {
    messages.contact({Time(i), "robot 1", "wall", {1.0, 2.0}});
    messages.point({Time(i), {0.5, 0.25, 1.0}, {0.1, 0.2}, {1, 2, 3}, ranges});
  }
  struct Counting final : TraceSink {
    void point(const TracePoint& point) noexcept override {
      in_order = in_order && point.time == Time(points) && point.ranges.size() == 8 &&
                 contacts == points + 1;
      ++points;
    }
    void contact(const TraceContact& contact) noexcept override {
      in_order = in_order && contact.robot == "robot 1" && contact.with == "wall";
      ++contacts;
    }
    int points = 0;
    int contacts = 0;
    bool in_order = true;
  } sink;
  const auto all = messages.take();
  EXPECT_GT(all.size(), 2U);
  for (const Message& message : all) EXPECT_TRUE(tell_trace(message, sink));
  EXPECT_EQ(sink.points, kPoints);
  EXPECT_TRUE(sink.in_order);
  EXPECT_TRUE(messages.take().empty());
}

TEST(WorldSlot, AnythingElseThanARemoteRobotIsRefusedAsHal) {
  KeepingLog log;
  const auto complaint = [&](const std::string& hal) {
    const Config config = rig_config({{"hal", hal}});
    try {
      open_backend({config, log});
    } catch (const ConfigError& error) {
      return error.text();
    }
    return std::string();
  };
  EXPECT_THAT(complaint("remote:"), HasSubstr("expected a robot that this process was given"));
  EXPECT_THAT(complaint("remote:1"), HasSubstr("expected a robot that this process was given"));
  EXPECT_THAT(complaint("remote:9999"), HasSubstr("expected a robot that this process was given"));
  EXPECT_THAT(complaint("remote:7?colour=red"), HasSubstr("found 'colour=red', expected robot=N"));
}

}  // namespace
}  // namespace eyebridge::hal
