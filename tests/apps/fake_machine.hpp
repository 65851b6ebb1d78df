#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "run_program.hpp"

namespace eyebridge::testing {

/// A folder that looks like the "/" of a machine, as far as serial ports, cameras and CAN go.
class FakeMachine {
 public:
  [[nodiscard]] const std::string& root() const { return folder_.path(); }
  [[nodiscard]] std::string path(const std::string& file) const { return root() + file; }

  /// Writes a file, with the folders above it.
  void file(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
  }
  void link(const std::string& name, const std::string& target) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    std::filesystem::create_symlink(target, path(name));
  }

  /// A board on USB with a port of its own, as the cdc_acm driver shows it.
  void add_acm(const std::string& name = "ttyACM0") const {
    const std::string device = "/sys/devices/usb1/1-1";
    file(device + "/idVendor", "03eb\n");
    file(device + "/idProduct", "2404\n");
    file(device + "/product", "Interface Board\n");
    file(device + "/1-1:1.0/tty/" + name + "/dev", "166:0\n");
    link("/sys/class/tty/" + name, "../../devices/usb1/1-1/1-1:1.0/tty/" + name);
    link(device + "/1-1:1.0/tty/" + name + "/device", "../../../1-1:1.0");
    link(device + "/1-1:1.0/driver", "../../../../bus/usb/drivers/cdc_acm");
    file("/dev/" + name, "");
    link("/dev/serial/by-id/usb-UWA_Interface_Board-if00", "../../" + name);
  }
  /// A process, with `device` open when there is one.
  void add_process(int id, const std::string& name, const std::string& device = "") const {
    const std::string folder = "/proc/" + std::to_string(id);
    file(folder + "/comm", name + "\n");
    if (!device.empty()) link(folder + "/fd/5", device);
  }
  /// A camera's node, as udev tells of it: `capabilities` ":capture:" or, of a metadata node, ":".
  void add_video(int number, const std::string& card, const std::string& capabilities,
                 const std::string& by_id = "") const {
    const std::string name = "video" + std::to_string(number);
    const std::string sys = "/sys/class/video4linux/" + name;
    file(sys + "/name", card + "\n");
    file(sys + "/dev", "81:" + std::to_string(number) + "\n");
    file("/run/udev/data/c81:" + std::to_string(number),
         "E:ID_V4L_VERSION=2\nE:ID_V4L_CAPABILITIES=" + capabilities + "\n");
    file("/dev/" + name, "");
    if (!by_id.empty()) link("/dev/v4l/by-id/" + by_id, "../../" + name);
  }
  void add_can(const std::string& name, bool up, int queue = 10, int mtu = 16) const {
    const std::string folder = "/sys/class/net/" + name;
    file(folder + "/type", "280\n");
    file(folder + "/flags", up ? "0x40081\n" : "0x40080\n");
    file(folder + "/tx_queue_len", std::to_string(queue) + "\n");
    file(folder + "/mtu", std::to_string(mtu) + "\n");
  }

 private:
  ScratchFolder folder_;
};

}  // namespace eyebridge::testing
