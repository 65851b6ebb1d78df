// Through the client of a robot on a CAN bus, against send() and recv() of frames of the same size
// on such a bus: what PSDGet() does, which is to read what the robot told last (target: 1.5 times
// the raw echo); and, for those who close a loop over the bus, a command until its answer can be
// read.
//
// On a SOCK_SEQPACKET pair everywhere; on the interface that EYEBRIDGE_TEST_CAN names, too: in the
// lab, tests/lab/run -- build/release/bin/bench_latency_can.
#include <atomic>
#include <cstdlib>
#include <optional>
#include <thread>

#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include "eyebridge/bridges/client/can_client.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"
#include "eyebridge/bridges/socket_can.hpp"
#include "latencies.hpp"
#include "opcodes.h"

namespace eyebridge::bench {
namespace {

using namespace std::chrono_literals;
using bridges::CanClient;
namespace can = bridges::can;

constexpr int kNode = 1;

/// Two sockets on one bus: ours and the robot's.
struct Ends {
  UniqueFd near;
  UniqueFd far;
};

Ends pair_of_sockets() {
  int fds[2];
  need(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, fds) == 0, "socketpair");
  return {UniqueFd(fds[0]), UniqueFd(fds[1])};
}

UniqueFd on_interface(const std::string& name) {
  UniqueFd fd(::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW));
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = static_cast<int>(::if_nametoindex(name.c_str()));
  need(::bind(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0, name);
  return fd;
}

Ends ends_on(const std::string& interface) {
  if (interface.empty()) return pair_of_sockets();
  return {on_interface(interface), on_interface(interface)};
}

can_frame wire(const Result<bridges::CanFrame>& frame) {
  need(frame.has_value(), "encode");
  can_frame out{};
  out.can_id = frame->id;
  out.can_dlc = frame->length;
  std::copy_n(frame->data.begin(), frame->length, out.data);
  return out;
}

void put(int fd, const can_frame& frame) {
  need(::send(fd, &frame, sizeof frame, MSG_NOSIGNAL) == sizeof frame, "send");
}

/// A node on a thread of its own: answers each frame for which `answer` has one.
template <class Answer>
std::jthread serve(int fd, Answer answer) {
  const timeval patience{0, 50'000};  // a CAN socket cannot be shut down: look up now and then
  need(::setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience) == 0, "setsockopt");
  return std::jthread([fd, answer](const std::stop_token& stop) {
    can_frame frame{};
    while (!stop.stop_requested()) {
      if (::recv(fd, &frame, sizeof frame, 0) != sizeof frame) continue;
      if (const auto reply = answer(frame)) put(fd, *reply);
    }
  });
}

/// All that a client waits for before a robot is ready.
std::vector<can_frame> signs_of_life() {
  const auto of = [](const auto& status) { return wire(can::encode(kNode, status)); };
  return {of(can::Heartbeat{EYECAN_STATE_OPERATIONAL}),
          of(can::VersionStatus{}),
          of(can::BoardStatus{}),
          of(can::PoseStatus{}),
          of(can::SpeedStatus{}),
          of(can::Encoder12Status{}),
          of(can::Encoder34Status{}),
          of(can::PsdAStatus{}),
          of(can::PsdBStatus{}),
          of(can::PsdRawStatus{}),
          of(can::DigitalStatus{}),
          of(can::AnalogAStatus{}),
          of(can::AnalogBStatus{})};
}

Latencies raw_echo(const std::string& interface) {
  constexpr int kExchanges = 20'000;
  const Ends ends = ends_on(interface);
  // On a bus everybody hears everybody: an answer has another number.
  const auto robot = serve(ends.far.get(), [](can_frame frame) -> std::optional<can_frame> {
    if (frame.can_id != 0x261) return std::nullopt;
    frame.can_id = 0x1F1;
    return frame;
  });
  can_frame request{};
  request.can_id = 0x261;
  request.can_dlc = 4;
  Latencies raw;
  for (int i = 0; i < kExchanges; ++i) {
    raw.time([&] {
      put(ends.near.get(), request);
      can_frame reply{};
      need(::recv(ends.near.get(), &reply, sizeof reply, 0) == sizeof reply, "recv");
    });
  }
  return raw;
}

void read_range(CanClient& client) {
  need(client.latest<can::PsdAStatus>().has_value(), "the last range");
}

void command_and_answer(CanClient& client) {
  static std::uint16_t value = 0;
  value = static_cast<std::uint16_t>(value % 255 + 1);
  need(client.say(can::DigitalCommand{0xFFFF, value}).has_value(), "say");
  for (auto seen = client.latest<can::DigitalStatus>(); !seen || seen->in != value;
       seen = client.latest<can::DigitalStatus>()) {
    std::this_thread::yield();
  }
}

void measure(benchmark::State& state, const std::string& interface, void (*exchange)(CanClient&)) {
  Latencies raw = raw_echo(interface);
  Ends ends = ends_on(interface);
  const int far = ends.far.get();
  bridges::MonotonicClock clock;
  NullLog log;
  std::atomic<bool> alive = true;
  std::atomic<bool> measuring = false;
  auto robot = serve(far, [](const can_frame& frame) -> std::optional<can_frame> {
    if (frame.can_id >> EYECAN_NODE_BITS != EYECAN_C_DIGITAL) return std::nullopt;
    can::DigitalStatus status;
    status.in = frame.data[2];
    return wire(can::encode(kNode, status));
  });
  std::jthread heart([&] {
    for (const auto frames = signs_of_life(); alive; clock.wait_until(clock.now() + 50ms)) {
      for (const can_frame& frame : frames) {
        // Not to overwrite the answer that is waited for.
        if (frame.can_id >> EYECAN_NODE_BITS != EYECAN_S_DIGITAL || !measuring) put(far, frame);
      }
    }
  });
  {
    CanClient client(bridges::make_socket_can({std::move(ends.near), false}, "bench", clock), kNode,
                     clock, log);
    client.start();
    const auto ready = client.wait_ready(3s);
    need(ready.has_value(), ready ? "" : ready.error().what);
    measuring = true;
    Latencies ours;
    for (auto _ : state) ours.time([&] { exchange(client); });
    // A command goes through three threads, the raw echo through two.
    report(state, ours, raw, exchange == read_range);
    alive = false;
    heart.join();  // before the other side is gone
  }
}

const bool registered = [] {
  std::vector<std::string> buses{""};
  if (const char* const named = std::getenv("EYEBRIDGE_TEST_CAN")) {
    const std::string names(named);
    buses.push_back(names.substr(0, names.find(',')));
  }
  for (const std::string& bus : buses) {
    const std::string name = bus.empty() ? "socketpair" : bus;
    const auto add = [&](const std::string& what, void (*exchange)(CanClient&)) {
      benchmark::RegisterBenchmark((what + "/" + name).c_str(), [bus, exchange](
                                                                    benchmark::State& state) {
        measure(state, bus, exchange);
      })->UseRealTime();
    };
    add("read_range", read_range);
    add("command_and_answer", command_and_answer);
  }
  return true;
}();

}  // namespace
}  // namespace eyebridge::bench
