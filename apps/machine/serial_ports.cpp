#include "serial_ports.hpp"

#include <fstream>

#include <fmt/format.h>

#include "holders.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

std::string name_of(const std::string& device) { return fs::path(device).filename(); }

/// The first link in /dev/serial/by-id that leads to the port.
std::string by_id_of(const std::string& name, const fs::path& root) {
  const std::string folder = "/dev/serial/by-id";
  for (const std::string& link : names_in(below(root, folder))) {
    std::error_code error;
    const fs::path target = fs::read_symlink(below(root, folder) / link, error);
    if (!error && target.filename() == name) return folder + "/" + link;
  }
  return "";
}

/// What the USB device that the port belongs to calls itself.
std::string product_of(const fs::path& tty) {
  std::error_code error;
  fs::path folder = fs::canonical(tty / "device", error);
  constexpr int kLevels = 4;  // port, interface, device
  for (int level = 0; !error && level < kLevels; ++level, folder = folder.parent_path()) {
    const auto vendor = line_of(folder / "idVendor");
    const auto product = line_of(folder / "idProduct");
    if (!vendor || !product) continue;
    const auto name = line_of(folder / "product");
    return fmt::format("{}({}:{})", name ? *name + " " : "", *vendor, *product);
  }
  return "";
}

/// /run/udev/data/c166:0 holds a line "E:NAME=value" for each property.
bool is_hidden(const fs::path& tty, const fs::path& root) {
  const auto number = line_of(tty / "dev");
  if (!number) return false;
  std::ifstream data(below(root, "/run/udev/data") / ("c" + *number));
  for (std::string line; std::getline(data, line);) {
    if (line == "E:ID_MM_DEVICE_IGNORE=1" || line == "E:ID_MM_PORT_IGNORE=1") return true;
  }
  return false;
}

}  // namespace

SerialPort look_at_port(const std::string& device, const fs::path& root) {
  SerialPort port;
  port.device = device;
  const std::string name = name_of(device);
  const fs::path tty = below(root, "/sys/class/tty") / name;
  port.by_id = by_id_of(name, root);
  std::error_code error;
  const fs::path driver = fs::read_symlink(tty / "device" / "driver", error);
  if (!error) port.driver = driver.filename();
  port.product = product_of(tty);
  port.access = access_of(device, root);
  port.latency_ms = number_of(below(root, "/sys/bus/usb-serial/devices") / name / "latency_timer");
  port.holders = holders_of(device, root);
  port.hidden_from_modem_manager = is_hidden(tty, root);
  return port;
}

SerialState look_at_serial(const fs::path& root) {
  SerialState state;
  for (const std::string& name : names_in(below(root, "/dev"), {"ttyACM", "ttyUSB", "ttyAMA"})) {
    state.ports.push_back(look_at_port("/dev/" + name, root));
  }
  for (Process& process : processes(root)) {
    if (process.name == "ModemManager") state.modem_manager = std::move(process);
  }
  return state;
}

}  // namespace eyebridge::apps
