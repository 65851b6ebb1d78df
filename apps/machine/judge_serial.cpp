// What to say about serial ports.
#include <fmt/format.h>

#include "holders.hpp"
#include "serial_ports.hpp"

namespace eyebridge::apps {
namespace {

constexpr long kLowLatency_ms = 1;

}  // namespace

std::string described(const SerialPort& port) {
  std::string out = port.product.empty() ? "not a USB device" : port.product;
  if (!port.driver.empty()) out += ", driver " + port.driver;
  if (!port.access.permitted) out += fmt::format(", not permitted (group {})", port.access.group);
  return out;
}

Finding judge_port(const SerialPort& port, const SerialState& state) {
  Finding out{"  " + port.device.substr(port.device.rfind('/') + 1), false, port.access.permitted,
              "", ""};
  out.detail = described(port);
  if (!port.access.permitted) out.remedy = how_to_be_permitted(port);
  if (!port.by_id.empty()) out.advice.push_back("stays the same when re-plugged: " + port.by_id);
  if (!port.holders.empty()) {
    out.advice.push_back("in use by " + listed(port.holders) + ": end it first");
  }
  if (state.modem_manager && !port.hidden_from_modem_manager) {
    out.advice.push_back(described(*state.modem_manager) +
                         " sends modem commands to it when it is plugged in: install the rule of "
                         "eyebridge doctor --udev");
  }
  if (port.latency_ms && *port.latency_ms > kLowLatency_ms) {
    out.advice.push_back(fmt::format(
        "the adapter holds bytes back for {0} ms: as root: echo 1 >/sys/bus/usb-serial/devices/{1}/"
        "latency_timer; the rule of eyebridge doctor --udev does it each time",
        *port.latency_ms, port.device.substr(port.device.rfind('/') + 1)));
  }
  return out;
}

std::string how_to_be_permitted(const SerialPort& port) {
  return how_to_be_permitted(
      port.access,
      "only root may use it: install the rule of eyebridge doctor --udev, then plug it "
      "in again");
}

std::vector<Finding> judge_serial(const SerialState& state) {
  constexpr const char* kWhat = "serial boards";
  if (state.ports.empty()) {
    return {{kWhat, false, false, "no /dev/ttyACM*, /dev/ttyUSB* or /dev/ttyAMA*", ""}};
  }
  std::string names;
  for (const SerialPort& port : state.ports) names += (names.empty() ? "" : " ") + port.device;
  std::vector<Finding> out = {
      {kWhat, false, true, names, "", {"what is on it: eyebridge probe " + state.ports[0].device}}};
  for (const SerialPort& port : state.ports) out.push_back(judge_port(port, state));
  return out;
}

}  // namespace eyebridge::apps
