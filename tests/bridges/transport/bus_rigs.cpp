#include <cstdlib>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include "can_wire.hpp"
#include "eyebridge/bridges/faulty_bus.hpp"
#include "eyebridge/bridges/memory.hpp"
#include "eyebridge/bridges/socket_can.hpp"
#include "eyebridge/bridges/trace.hpp"
#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

void need(bool good, const std::string& step) {
  if (!good) throw std::runtime_error("cannot set up the test: " + step);
}

void write_raw(int fd, const CanFrame& frame) {
  canfd_frame wire;
  const std::size_t size = to_wire(frame, wire);
  need(::write(fd, &wire, size) == static_cast<ssize_t>(size), "writing an error frame");
}

BusRig memory(const std::string&) {
  BusRig rig;
  rig.clock = std::make_unique<MonotonicClock>();
  auto bus = std::make_shared<MemoryCan>(*rig.clock);
  rig.near = bus->connect("near");
  rig.far = bus->connect("far");
  rig.report = [bus](const CanFrame& frame) { bus->report(frame); };
  rig.unplug = [](BusRig& self) { self.far.reset(); };
  rig.replug = [bus](BusRig& self) { self.far = bus->connect("far"); };
  return rig;
}

BusRig faulty(const std::string& name) {
  BusRig rig = memory(name);
  rig.near = std::make_unique<FaultyBus>(std::move(rig.near), FaultPlan{}, *rig.clock);
  return rig;
}

BusRig traced(const std::string& name) {
  BusRig rig = memory(name);
  rig.near = make_traced(std::move(rig.near), *rig.clock, [](std::string_view) {});
  return rig;
}

/// The socket pair that stands for an interface.
struct Cable {
  UniqueFd next;  ///< What the next reopening gets.
  UniqueFd raw;   ///< The far end once more, to write what send() refuses.
};

UniqueFd new_far(Cable& cable, UniqueFd& near) {
  auto [one, other] = socket_pair(SOCK_SEQPACKET);
  near = std::move(one);
  cable.raw = UniqueFd(::dup(other.get()));
  return std::move(other);
}

BusRig seqpacket(const std::string&) {
  BusRig rig;
  rig.clock = std::make_unique<MonotonicClock>();
  Clock& clock = *rig.clock;
  auto cable = std::make_shared<Cable>();
  UniqueFd near;
  rig.far = make_socket_can({new_far(*cable, near), true}, "far", clock);
  rig.near = make_socket_can({std::move(near), true}, "near", clock,
                             [cable, &clock](Time deadline) -> Result<CanSocket> {
                               if (cable->next.valid())
                                 return CanSocket{std::move(cable->next), true};
                               clock.wait_until(deadline);
                               return fail(Errc::Disconnected, "near: still away");
                             });
  rig.report = [cable](const CanFrame& frame) { write_raw(cable->raw.get(), frame); };
  rig.unplug = [cable](BusRig& self) {
    cable->raw.reset();
    self.far.reset();
  };
  rig.replug = [cable](BusRig& self) {
    self.far = make_socket_can({new_far(*cable, cable->next), true}, "far", *self.clock);
  };
  return rig;
}

std::unique_ptr<CanBus> open_interface(const std::string& name, Clock& clock) {
  SocketCanSettings settings;
  settings.interface = name;
  settings.fd = true;
  auto bus = open_socket_can(settings, clock);
  need(bus.has_value(), what(bus));
  return std::move(*bus);
}

void report_on(const std::string& name, const CanFrame& frame) {
  const UniqueFd fd(::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW));
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = static_cast<int>(::if_nametoindex(name.c_str()));
  need(::bind(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0, name);
  write_raw(fd.get(), frame);
}

void set_link(const std::string& name, const char* state) {
  const std::string command = "ip link set " + name + " " + state;
  need(std::system(command.c_str()) == 0, command);
}

BusRig interface(const std::string& name) {
  BusRig rig;
  rig.clock = std::make_unique<MonotonicClock>();
  rig.near = open_interface(name, *rig.clock);
  rig.far = open_interface(name, *rig.clock);
  rig.report = [name](const CanFrame& frame) { report_on(name, frame); };
  rig.unplug = [name](BusRig&) { set_link(name, "down"); };
  rig.replug = [name](BusRig& self) {
    set_link(name, "up");
    self.far = open_interface(name, *self.clock);
  };
  rig.drops = true;
  return rig;
}

}  // namespace

void PrintTo(const BusCase& row, std::ostream* out) { *out << row.name; }

std::vector<BusCase> bus_cases() {
  std::vector<BusCase> cases{{"Memory", memory},
                             {"SeqpacketPair", seqpacket},
                             {"FaultyWithoutFaults", faulty},
                             {"Traced", traced}};
  const char* const named = std::getenv("EYEBRIDGE_TEST_CAN");
  std::istringstream names(named == nullptr ? "" : named);
  for (std::string name; std::getline(names, name, ',');) cases.push_back({name, interface});
  return cases;
}

}  // namespace eyebridge::bridges::testing
