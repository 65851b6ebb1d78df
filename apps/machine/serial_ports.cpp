#include "serial_ports.hpp"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

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

bool has_name(std::string_view list, const std::string& wanted) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(','), list.size());
    if (list.substr(0, end) == wanted) return true;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return false;
}

/// Whether /etc/group ("dialout:x:20:ann,bob") has this user in `group`.
bool is_member(const std::string& group, const fs::path& root) {
  const passwd* user = ::getpwuid(::geteuid());
  if (user == nullptr) return false;
  std::ifstream groups(below(root, "/etc/group"));
  for (std::string line; std::getline(groups, line);) {
    const std::size_t last = line.rfind(':');
    if (line.starts_with(group + ":") && last != std::string::npos) {
      return has_name(std::string_view(line).substr(last + 1), user->pw_name);
    }
  }
  return false;
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
  const fs::path node = below(root, device);
  const fs::path tty = below(root, "/sys/class/tty") / name;
  port.by_id = by_id_of(name, root);
  std::error_code error;
  const fs::path driver = fs::read_symlink(tty / "device" / "driver", error);
  if (!error) port.driver = driver.filename();
  port.product = product_of(tty);
  struct stat status {};
  if (::stat(node.c_str(), &status) == 0) {
    const group* owner = ::getgrgid(status.st_gid);
    port.group = owner == nullptr ? std::to_string(status.st_gid) : owner->gr_name;
    port.group_may = (status.st_mode & S_IRGRP) != 0 && (status.st_mode & S_IWGRP) != 0;
    port.permitted = ::access(node.c_str(), R_OK | W_OK) == 0;
    port.in_group = is_member(port.group, root);
  }
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
