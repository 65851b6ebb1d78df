#include "replay/record_tap.hpp"

#include <mutex>

#include <fmt/format.h>

#include "replay/ebrec.hpp"

namespace eyebridge::hal {
namespace {

constexpr int kMostIds = 255;

/// What the robot has, asked device by device: a backend has no list.
std::vector<RecordedDevice> devices_of(Backend& backend) {
  std::vector<RecordedDevice> devices;
  const auto add = [&](const char* kind, int id, const void* there, Values facts = {}) {
    if (there != nullptr) devices.push_back({kind, id, std::move(facts)});
  };
  add("drive", 1, backend.drive());
  add("compass", 1, backend.compass());
  if (const Lidar* lidar = backend.lidar()) {
    const LidarShape shape = lidar->shape();
    add("lidar", 1, lidar,
        {lidar->max_range(), shape.field_of_view, shape.tilt, static_cast<double>(shape.points)});
  }
  for (int id = 1; id <= kMostIds; ++id) {
    if (const RangeSensor* psd = backend.range_sensor(id))
      add("psd", id, psd, {psd->out_of_range()});
    add("proximity", id, backend.proximity(id));
    add("bumper", id, backend.bumper(id));
    add("motor", id, backend.motor(id));
    add("encoder", id, backend.encoder(id));
    add("servo", id, backend.servo(id));
  }
  return devices;
}

class RecordTap final : public Tap {
 public:
  RecordTap(Backend& backend, const std::filesystem::path& path, LogSink& log,
            const RecordingOrigin& origin)
      : clock_(backend.clock()),
        log_(log),
        writer_(std::make_unique<EbrecWriter>(path, devices_of(backend), origin)) {}

  Result<Values> exchange(const Call& call,
                          const std::function<Result<Values>()>& device) override {
    const Time began = clock_.now();
    Result<Values> reply = device();
    write([&](EbrecWriter& writer) { writer.add(began, call, reply); });
    return reply;
  }

  void finish() noexcept override {
    write([](EbrecWriter& writer) { writer.commit(); });
    const std::lock_guard lock(mutex_);
    writer_.reset();  // closed, it is one file instead of three
  }

 private:
  template <class Write>
  void write(Write&& act) {
    const std::lock_guard lock(mutex_);
    if (writer_ == nullptr) return;
    try {
      act(*writer_);
    } catch (const std::runtime_error& error) {
      log_.write(Severity::Error, fmt::format("the recording ends here: {}", error.what()));
      writer_.reset();
    }
  }

  Clock& clock_;
  LogSink& log_;
  std::mutex mutex_;
  std::unique_ptr<EbrecWriter> writer_;
};

}  // namespace

std::unique_ptr<Backend> with_recording(std::unique_ptr<Backend> inner,
                                        const std::filesystem::path& path, LogSink& log,
                                        const RecordingOrigin& origin) {
  return make_tapped(std::move(inner), [&](Backend& backend) {
    return std::make_unique<RecordTap>(backend, path, log, origin);
  });
}

}  // namespace eyebridge::hal
