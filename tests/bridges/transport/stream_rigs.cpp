#include <cstdlib>
#include <ostream>
#include <stdexcept>
#include <thread>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/bridges/faulty_stream.hpp"
#include "eyebridge/bridges/fd_stream.hpp"
#include "eyebridge/bridges/memory.hpp"
#include "eyebridge/bridges/serial.hpp"
#include "eyebridge/bridges/tcp.hpp"
#include "eyebridge/bridges/trace.hpp"
#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

void need(bool good, const char* step) {
  if (!good) throw std::runtime_error(std::string("cannot set up the test: ") + step);
}

template <class T>
T value_of(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().what);
  return std::move(*result);
}

StreamRig memory() {
  StreamRig rig{std::make_unique<MonotonicClock>(), {}, {}};
  std::tie(rig.near, rig.far) = make_memory_streams(*rig.clock);
  return rig;
}

StreamRig sockets() {
  StreamRig rig{std::make_unique<MonotonicClock>(), {}, {}};
  auto [near, far] = socket_pair(SOCK_STREAM);
  rig.near = make_fd_stream(std::move(near), "near", *rig.clock);
  rig.far = make_fd_stream(std::move(far), "far", *rig.clock);
  return rig;
}

StreamRig serial() {
  StreamRig rig{std::make_unique<MonotonicClock>(), {}, {}};
  auto [master, path] = open_pty();
  rig.near = value_of(open_serial({path, 115200}, *rig.clock));
  rig.far = make_fd_stream(std::move(master), "board", *rig.clock);
  return rig;
}

StreamRig tcp() {
  StreamRig rig{std::make_unique<MonotonicClock>(), {}, {}};
  const UniqueFd listener(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const generic = reinterpret_cast<sockaddr*>(&address);
  need(::bind(listener.get(), generic, size) == 0 && ::listen(listener.get(), 1) == 0 &&
           ::getsockname(listener.get(), generic, &size) == 0,
       "listening on the loopback");
  rig.near = value_of(open_tcp({"127.0.0.1", ntohs(address.sin_port)}, *rig.clock));
  UniqueFd far(::accept4(listener.get(), nullptr, nullptr, SOCK_CLOEXEC));
  need(far.valid(), "accept");
  rig.far = make_fd_stream(std::move(far), "board", *rig.clock);
  return rig;
}

StreamRig faulty() {
  StreamRig rig = memory();
  for (auto* const end : {&rig.near, &rig.far}) {
    *end = std::make_unique<FaultyStream>(std::move(*end), FaultPlan{}, *rig.clock);
  }
  return rig;
}

StreamRig traced() {
  StreamRig rig = memory();
  rig.near = make_traced(std::move(rig.near), *rig.clock, [](std::string_view) {});
  return rig;
}

}  // namespace

Bytes noise(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Bytes bytes(count);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
  return bytes;
}

Bytes read_exactly(ByteStream& stream, std::size_t count, Time deadline) {
  Bytes bytes(count);
  std::size_t done = 0;
  while (done < count) {
    const auto got = stream.read_some(std::span(bytes).subspan(done), deadline);
    if (!got) break;
    done += *got;
  }
  bytes.resize(done);
  return bytes;
}

std::pair<UniqueFd, std::string> open_pty() {
  UniqueFd master(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
  need(master.valid() && ::grantpt(master.get()) == 0 && ::unlockpt(master.get()) == 0, "a pty");
  char path[128];
  need(::ptsname_r(master.get(), path, sizeof path) == 0, "the name of a pty");
  return {std::move(master), path};
}

std::pair<UniqueFd, UniqueFd> socket_pair(int type) {
  int ends[2];
  need(::socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends) == 0, "a socket pair");
  return {UniqueFd(ends[0]), UniqueFd(ends[1])};
}

void PrintTo(const StreamCase& row, std::ostream* out) { *out << row.name; }

std::vector<StreamCase> stream_cases() {
  return {{"Memory", memory},   {"SocketPair", sockets},         {"SerialOverPty", serial},
          {"TcpLoopback", tcp}, {"FaultyWithoutFaults", faulty}, {"Traced", traced}};
}

}  // namespace eyebridge::bridges::testing
