#include "tap/device_list.hpp"

#include <utility>

namespace eyebridge::hal {
namespace {

constexpr int kMostIds = 255;

}  // namespace

std::vector<ListedDevice> devices_of(Backend& backend) {
  std::vector<ListedDevice> devices;
  const auto add = [&](const char* kind, int id, const void* there, Values facts = {}) {
    if (there != nullptr) devices.push_back({kind, id, std::move(facts)});
  };
  add("drive", 1, backend.drive());
  add("compass", 1, backend.compass());
  add("gyroscope", 1, backend.gyroscope());
  add("accelerometer", 1, backend.accelerometer());
  if (const Lidar* lidar = backend.lidar()) {
    const LidarShape shape = lidar->shape();
    add("lidar", 1, lidar,
        {lidar->max_range(), shape.field_of_view, shape.tilt, static_cast<double>(shape.points)});
  }
  add("digital", 1, backend.digital());
  add("analog", 1, backend.analog());
  add("board", 1, backend.io_board());
  add("remote", 1, backend.remote());
  add("sound", 1, backend.sound());
  if (const Radio* radio = backend.radio())
    add("radio", 1, radio, {static_cast<double>(radio->id())});
  add("serial", 0, backend.serial_port(0));
  for (int id = 1; id <= kMostIds; ++id) {
    if (const RangeSensor* psd = backend.range_sensor(id))
      add("psd", id, psd, {psd->out_of_range()});
    add("proximity", id, backend.proximity(id));
    add("bumper", id, backend.bumper(id));
    add("motor", id, backend.motor(id));
    add("encoder", id, backend.encoder(id));
    add("servo", id, backend.servo(id));
    add("serial", id, backend.serial_port(id));
  }
  return devices;
}

}  // namespace eyebridge::hal
