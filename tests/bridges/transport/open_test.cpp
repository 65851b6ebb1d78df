#include "eyebridge/bridges/open.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/bridges/memory.hpp"
#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

using ::testing::HasSubstr;

const SourceLocation kWhere{"--hal"};

template <class Parse>
std::string complaint(Parse parse, std::string_view text) {
  try {
    parse(parse_url(text, kWhere), kWhere);
    return "no complaint";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(LineUrl, ReadsSerialPorts) {
  const auto settings = serial_settings(parse_url("serial:/dev/ttyACM0", {}), {});
  EXPECT_EQ(settings.device, "/dev/ttyACM0");
  EXPECT_EQ(settings.baud, 115200u);
  EXPECT_EQ(serial_settings(parse_url("serial:x?baud=921600", {}), {}).baud, 921600u);
}

TEST(LineUrl, RefusesBadSerialPorts) {
  EXPECT_EQ(complaint(serial_settings, "serial:"),
            "--hal: found 'serial:', expected the device of a serial port, as in "
            "serial:/dev/ttyACM0");
  EXPECT_EQ(complaint(serial_settings, "serial:x?baud=fast"),
            "--hal: found 'fast' for 'baud', expected 50 … 12000000");
  for (const char* const baud :
       {"", "-1", "0", "49", "12000001", "1e5", "9600 ", "99999999999999999999"}) {
    EXPECT_THAT(complaint(serial_settings, std::string("serial:x?baud=") + baud),
                HasSubstr("for 'baud', expected"));
  }
  EXPECT_EQ(complaint(serial_settings, "serial:x?bd=1"),
            "--hal: found the option 'bd', expected one of baud");
}

TEST(LineUrl, ReadsTcpAddresses) {
  const auto named = tcp_settings(parse_url("tcp:robot.local:4711?connect_ms=250", {}), {});
  EXPECT_EQ(named.host, "robot.local");
  EXPECT_EQ(named.port, 4711);
  EXPECT_EQ(named.connect_timeout.count(), 250);
  EXPECT_EQ(tcp_settings(parse_url("tcp:[::1]:1", {}), {}).host, "::1");
}

TEST(LineUrl, TakesNamesOfOtherAlphabets) {
  EXPECT_EQ(tcp_settings(parse_url("tcp:r\xC3\xB6\x62oter\xFF:4711", {}), {}).host,
            "r\xC3\xB6\x62oter\xFF")
      << "bytes above 0x7F are letters, whether char has a sign or not";
  for (const char* const host : {"a\x01", "a\x1F", "a ", "a\x7F"}) {
    EXPECT_THAT(complaint(tcp_settings, "tcp:" + std::string(host) + ":1"),
                HasSubstr("expected a host and a port"));
  }
}

TEST(LineUrl, RefusesBadTcpAddresses) {
  for (const char* const rest :
       {"", "robot", ":1", "[]:1", "::1:4711", "a b:1", "[::1:1", "a]:1"}) {
    EXPECT_THAT(complaint(tcp_settings, std::string("tcp:") + rest),
                HasSubstr("expected a host and a port, as in tcp:robot:4711"))
        << rest;
  }
  for (const char* const port : {"", "0", "65536", "-1", "http"}) {
    EXPECT_THAT(complaint(tcp_settings, std::string("tcp:robot:") + port),
                HasSubstr("for the port, expected 1 … 65535"));
  }
}

TEST(LineUrl, ReadsCanInterfaces) {
  const auto plain = socket_can_settings(parse_url("can:can0", {}), {});
  EXPECT_EQ(plain.interface, "can0");
  EXPECT_FALSE(plain.fd);
  const auto fd = socket_can_settings(parse_url("can:c?fd=1&receive_buffer=65536", {}), {});
  EXPECT_TRUE(fd.fd);
  EXPECT_EQ(fd.receive_buffer, 65536);
}

TEST(LineUrl, RefusesBadCanInterfaces) {
  for (const char* const rest : {"", "sixteen_letters_", "can 0"}) {
    EXPECT_THAT(complaint(socket_can_settings, std::string("can:") + rest),
                HasSubstr("expected the name of a CAN interface"))
        << rest;
  }
  EXPECT_EQ(complaint(socket_can_settings, "can:./my robot.bus"), "no complaint")
      << "a bus on a socket";
  EXPECT_THAT(complaint(socket_can_settings, "can:/" + std::string(107, 'x')),
              HasSubstr("the path of a bus's socket, at most 107"));
  EXPECT_THAT(complaint(socket_can_settings, "can:can0?fd=2"), HasSubstr("expected 0 … 1"));
  EXPECT_THAT(complaint(socket_can_settings, "can:can0?node=1"),
              HasSubstr("the option 'node', expected one of fd, receive_buffer, ids, offset"));
}

TEST(OpenLine, NamesTheSchemesWhenItKnowsNoSuchOne) {
  MonotonicClock clock;
  EXPECT_EQ(complaint([&](const Url& url,
                          const SourceLocation& where) { return open_stream(url, where, clock); },
                      "can:can0"),
            "--hal: found 'can:', expected serial:DEVICE?baud=115200 or "
            "tcp:HOST:PORT?connect_ms=3000");
  EXPECT_THAT(complaint([&](const Url& url,
                            const SourceLocation& where) { return open_bus(url, where, clock); },
                        "serial:x"),
              HasSubstr("expected can:INTERFACE"));
}

TEST(OpenLine, OpensAPortByItsUrl) {
  MonotonicClock clock;
  const auto [master, path] = open_pty();
  const Url url = parse_url("serial:" + path + "?baud=57600", {});
  const auto stream = open_stream(url, {}, clock);
  ASSERT_TRUE(stream) << what(stream);
  EXPECT_EQ((*stream)->name(), path);
}

TEST(OpenLine, ADeviceThatIsNotThereIsNoMistakeInTheUrl) {
  MonotonicClock clock;
  const auto stream = open_stream(parse_url("serial:/dev/none", {}), {}, clock);
  ASSERT_FALSE(stream);
  EXPECT_EQ(stream.error().code, Errc::Disconnected);
}

TEST(OpenLine, TakesRowsOfItsCaller) {
  MonotonicClock clock;
  const Scheme<ByteStream> rows[] = {
      {"memory", "memory:", [](const Url&, const SourceLocation&, Clock& on) {
         return Result<std::unique_ptr<ByteStream>>(make_memory_streams(on).first);
       }}};
  const auto stream = open_stream(parse_url("memory:", {}), {}, clock, rows);
  ASSERT_TRUE(stream) << what(stream);
  EXPECT_EQ((*stream)->name(), "memory");
}

}  // namespace
}  // namespace eyebridge::bridges::testing
